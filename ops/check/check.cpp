#include "ops/check/check.h"

#include <tbb/global_control.h>

#include <algorithm>

#include "core/base/in_parallel.h"
#include "core/base/tunables.h"
#include "core/model/exported_floats.h"
#include "core/scene/friction.h"
#include "core/scene/transaction.h"
#include "ops/operations/commit.h"
#include "ops/operations/draped_rest.h"
#include "ops/operations/joint_hold.h"
#include "ops/placement/clearance.h"
#include "ops/placement/depth.h"
#include "ops/placement/verify.h"
#include "ops/settle/rest.h"

namespace trivet {
namespace {

struct PlacedObject {
  ObjectId id;
  ObjectInWorld world;
  const Object& object() const { return *world.object; }
};

std::vector<PlacedObject> placed_objects(const Scene& scene) {
  const Vec3 origin = export_origin(scene.box());
  std::vector<PlacedObject> out;
  for (const ObjectId id : scene.ids()) {
    const Object& object = scene.at(id);
    if (object.placed) out.push_back({id, in_world(object, object.pose, origin)});
  }
  return out;
}

struct PairToCheck {
  size_t a, b;
  PairVerdict verdict;
  Depth depth;  // unless it is clear
  bool is_judged = false;
};

bool only_touches(const Depth& depth, double clearance) {
  return depth.metres <= kTouchingDepth * clearance;
}

// Pairs (a, b) with a < b whose boxes overlap, sorted.
std::vector<PairToCheck> near_pairs(const Scene& scene, const std::vector<PlacedObject>& objects) {
  std::vector<size_t> index_of;  // by slot
  // Boxes are searched with the largest slack: float32 positions may leave their double's box.
  double slack = 0;
  for (size_t i = 0; i < objects.size(); ++i) {
    index_of.resize(std::max<size_t>(index_of.size(), objects[i].id.index + 1));
    index_of[objects[i].id.index] = i;
    slack = std::max(slack, objects[i].world.floats.slack);
  }
  std::vector<PairToCheck> out;
  for (size_t i = 0; i < objects.size(); ++i)
    for (const ObjectId id : scene.near(objects[i].world.box, slack)) {
      const size_t j = index_of[id.index];
      // Each pair is taken once; a rule may let two objects pass through each other.
      if (j > i && overlaps(objects[i].world.box, objects[j].world.box) &&
          !may_pass(scene, objects[i].object(), objects[j].object()))
        out.push_back({i, j, {}, {}});
    }
  return out;
}

using Finding = SceneCheck::PairFinding;

Finding finding(const std::string& a, const std::string& b, std::int64_t count,
                const Depth& depth) {
  return {a, b, count, depth.metres, depth.point};
}

bool reaches_floor(const Scene& scene, const PlacedObject& o) {
  return scene.floor && o.world.box.lower.z() < 0 && !may_pass_floor(scene, o.object());
}

void add_floor_findings(const PlacedObject& o, double clearance, SceneCheck& check) {
  const auto crossings = num_below_floor(o.world), floats = num_floats_below_floor(o.world);
  // An object may be below the floor in float32 alone, as a renderer or simulator would see it.
  if (!crossings && !floats) return;
  const Depth depth = depth_below_floor(o.world);
  const std::string& name = o.object().name;
  if (crossings) check.crossings.push_back(finding(name, "floor", crossings, depth));
  if (floats) check.float32_crossings.push_back(finding(name, "floor", floats, depth));
  if (only_touches(depth, clearance))
    check.touching.push_back(finding(name, "floor", crossings, depth));
}

void add_pair_findings(const PlacedObject& a, const PlacedObject& b, const PairToCheck& pair,
                       double clearance, SceneCheck& check) {
  const PairVerdict& v = pair.verdict;
  // Most pairs are clear: their depth was not even computed.
  if (v.clear()) return;
  const Depth& depth = pair.depth;
  const std::string &name_a = a.object().name, &name_b = b.object().name;
  const auto add = [&](std::vector<Finding>& findings, const std::string& first,
                       const std::string& second, std::int64_t count) {
    if (count) findings.push_back(finding(first, second, count, depth));
  };
  add(check.crossings, name_a, name_b, v.crossings);
  add(check.float32_crossings, name_a, name_b, v.float_crossings);
  add(check.contained, name_a, name_b, v.a_inside_b);
  add(check.contained, name_b, name_a, v.b_inside_a);
  // A pair that only touches is told, but does not fail the check, see ok().
  if (only_touches(depth, clearance))
    check.touching.push_back(finding(name_a, name_b, v.crossings, depth));
}

// Partners of each object that it passes through: these do not hold it. What it only touches does.
std::vector<std::vector<Support>> crossed_by(const Scene& scene,
                                             const std::vector<PlacedObject>& objects,
                                             const std::vector<PairToCheck>& pairs,
                                             double clearance) {
  std::vector<std::vector<Support>> out(objects.size());
  for (size_t i = 0; i < objects.size(); ++i)
    if (reaches_floor(scene, objects[i]) &&
        !only_touches(depth_below_floor(objects[i].world), clearance))
      out[i].push_back(Support::floor());
  // Both partners lose each other: neither may rest on what it is inside of.
  for (const PairToCheck& p : pairs)
    if (!p.verdict.clear() && !only_touches(p.depth, clearance)) {
      out[p.a].push_back(objects[p.b].id);
      out[p.b].push_back(objects[p.a].id);
    }
  return out;
}

// The same of one object, by the findings of a check.
std::vector<Support> deeply_crossed_by(const Scene& scene, const SceneCheck& check,
                                       const std::string& name, double clearance) {
  std::vector<Support> out;
  for (const auto* findings : {&check.crossings, &check.contained, &check.float32_crossings})
    for (const Finding& f : *findings) {
      if ((f.a != name && f.b != name) || f.depth <= kTouchingDepth * clearance) continue;
      const std::string& other = f.a == name ? f.b : f.a;
      if (other == "floor")
        out.push_back(Support::floor());
      else if (const auto id = scene.find(other); id && other != name)
        out.emplace_back(*id);
    }
  return out;
}

// Distance by which it would fall, to within a clearance, and onto what.
SceneCheck::Hovering hovering_at(const PlacedObject& o, const Neighbourhood& others,
                                 double clearance) {
  const Body body = body_of(o.object());
  // The fall is asked down to the lowest that there is.
  const double lowest = std::min(others.floor() ? 0.0 : kInfinity, others.box().lower.z());
  const double depth = body.world_box.upper.z() - lowest;
  if (!(depth > 0) || !(depth < kInfinity)) return {o.object().name, "", kInfinity};
  Clearance keep;
  keep.distance = clearance;
  const ObstacleContact found =
      first_contact({&body, 1}, others, Motion::translation(-Vec3::UnitZ(), depth), keep, nullptr);
  if (found.status != FirstContact::Status::Contact) return {o.object().name, "", kInfinity};
  // The found time leaves a clearance below; the surfaces are that much farther apart.
  return {o.object().name, named(others.scene(), found.with).name, found.time + clearance};
}

// A cloth or cable that passes through itself, or that what was under it no longer holds.
void add_flexible_findings(const PlacedObject& o, const Scene& scene, SceneCheck& check) {
  const Object& object = o.object();
  const flex::Judgement judged = judge_draped(scene, o.id);
  if (judged.crosses_itself) check.crossings.push_back({object.name, object.name, 1});
  if (judged.crosses_itself_in_float32)
    check.float32_crossings.push_back({object.name, object.name, 1});
  if (!judged.is_at_rest()) check.not_at_rest.push_back(object.name);
}

void add_rest_findings(const PlacedObject& o, const Neighbourhood& others, const RestRules& rules,
                       SceneCheck& check) {
  const auto contacts = touching(body_of(o.object()), others, rules.clearance);
  for (const ContactsWith& c : contacts)
    for (const ContactPoint& p : c.points) check.smallest_gap = std::min(check.smallest_gap, p.gap);
  if (o.object().flexible) add_flexible_findings(o, others.scene(), check);
  if (gives_way_in_joint(others.scene(), o.id)) check.not_at_rest.push_back(o.object().name);
  // A fixed object needs nothing that holds it.
  if (o.object().fixed || rests_at(o.object(), o.object().pose, others, rules)) return;
  check.not_at_rest.push_back(o.object().name);
  // An object hovers if it lies on nothing: the way down tells whether that is seen.
  const bool lies = std::any_of(contacts.begin(), contacts.end(), [](const ContactsWith& c) {
    return std::any_of(c.points.begin(), c.points.end(),
                       [](const ContactPoint& p) { return p.normal.z() > kSupportNormalZ; });
  });
  if (!lies) check.hovering.push_back(hovering_at(o, others, rules.clearance));
}

// Clearance of a file, limited: it must not turn hovering into rest.
double believable_clearance(const Scene& scene, double clearance) {
  const ClearanceRange range = clearance_range(scene);
  return clearance > 0 ? std::min(clearance, range.largest) : range.usual;
}

}  // namespace

std::int64_t SceneCheck::interpenetrating_pairs() const {
  std::int64_t sum = 0;
  for (const PairFinding& f : crossings) sum += f.count;
  return sum;
}

bool SceneCheck::ok() const {
  // Crossings that are only touched are no failure.
  const auto is_deep = [this](const PairFinding& f) {
    return std::none_of(touching.begin(), touching.end(), [&](const PairFinding& t) {
      return (t.a == f.a && t.b == f.b) || (t.a == f.b && t.b == f.a);
    });
  };
  return whole() && not_at_rest.empty() &&
         std::none_of(crossings.begin(), crossings.end(), is_deep) &&
         std::none_of(float32_crossings.begin(), float32_crossings.end(), is_deep) &&
         std::none_of(contained.begin(), contained.end(), is_deep);
}

SceneCheck check_scene(const Scene& scene, int num_threads, double clearance,
                       const SettleOptions& settled_by, const IsOver& is_over) {
  const tbb::global_control threads(
      tbb::global_control::max_allowed_parallelism,
      num_threads > 0
          ? num_threads
          : tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
  const RestRules rules = rest_rules(settled_by, believable_clearance(scene, clearance));
  const std::vector<PlacedObject> objects = placed_objects(scene);
  std::vector<PairToCheck> pairs = near_pairs(scene, objects);
  // Pairs are independent: they are verified in parallel, and told in their order.
  in_parallel(pairs.size(), [&](size_t i) {
    PairToCheck& p = pairs[i];
    if (is_time_over(is_over)) return;
    p.is_judged = true;
    const ObjectInWorld &a = objects[p.a].world, &b = objects[p.b].world;
    p.verdict = verify_pair(a, b, true, std::numeric_limits<std::int64_t>::max());
    if (!p.verdict.clear()) p.depth = depth_of(a, b);
  });
  const std::vector<std::vector<Support>> crossed =
      crossed_by(scene, objects, pairs, rules.clearance);
  SceneCheck check;
  for (size_t i = 0; i < objects.size(); ++i) {
    if (is_time_over(is_over)) {
      check.not_judged.push_back(objects[i].object().name);
      continue;
    }
    if (reaches_floor(scene, objects[i])) add_floor_findings(objects[i], rules.clearance, check);
    Neighbourhood holders(scene, objects[i].id);
    // Objects that it crosses do not hold it.
    holders.leave_out(crossed[i]);
    add_rest_findings(objects[i], holders, rules, check);
  }
  for (const PairToCheck& p : pairs)
    if (p.is_judged)
      add_pair_findings(objects[p.a], objects[p.b], p, rules.clearance, check);
    else
      ++check.num_pairs_not_judged;
  return check;
}

bool may_rest_by(const Scene& scene, const SceneCheck& check, double clearance,
                 const SettleOptions& settled_by) {
  const RestRules rules = rest_rules(settled_by, believable_clearance(scene, clearance));
  const Vec3 origin = export_origin(scene.box());
  for (const std::string& name : check.not_at_rest) {
    const ObjectId id = *scene.find(name);
    if (scene.at(id).joint) continue;  // its load counts, which links tell
    Neighbourhood holders(scene, id);
    holders.leave_out(deeply_crossed_by(scene, check, name, rules.clearance));
    SceneCheck again;
    add_rest_findings({id, in_world(scene.at(id), scene.at(id).pose, origin)}, holders, rules,
                      again);
    if (!again.not_at_rest.empty()) return false;
  }
  return true;
}

namespace {

// State of a free object, from its pose; held and unsupported objects stay what they were.
ObjectState state_as_it_lies(const Scene& scene, ObjectId id, const Neighbourhood& others,
                             const RestRules& rules) {
  const Object& object = scene.at(id);
  const ObjectState was = object.state;
  // An object that is invalid stays so until it crosses nothing any more.
  if (was == ObjectState::Invalid && refuse_interpenetration(scene, id, object.pose, true))
    return was;
  // A held object is stable now, or still held.
  if (was == ObjectState::Held || was == ObjectState::Invalid)
    return rests_at(object, object.pose, others, rules) ? ObjectState::Stable : ObjectState::Held;
  return state_at(object, object.pose, others, rules);
}

}  // namespace

void update_contacts(Scene& scene, double clearance, const SettleOptions& settled_by,
                     const IsOver& is_over) {
  Transaction transaction(scene);
  update_contacts(transaction, scene.ids(), clearance, settled_by, is_over);
  transaction.commit();
}

void update_contacts(Transaction& transaction, const std::vector<ObjectId>& ids, double clearance,
                     const SettleOptions& settled_by, const IsOver& is_over) {
  const Scene& scene = transaction.scene();
  const RestRules rules = rest_rules(settled_by, believable_clearance(scene, clearance));
  for (const ObjectId id : ids) {
    const Object& object = scene.at(id);
    if (!object.placed) continue;
    if (is_time_over(is_over)) return;
    // Contacts are found anew with the scene's own holders, and ratings follow from all of them.
    const Neighbourhood others = holders(scene, id);
    const auto contacts = touching(body_of(object), others, rules.clearance);
    const ObjectState state =
        object.fixed ? ObjectState::Fixed : state_as_it_lies(scene, id, others, rules);
    commit_object(transaction, id, object.pose, state, contacts, rules);
  }
  rate_again(transaction, ids, rules);
}

}  // namespace trivet
