#include "ops/check/check.h"

#include <tbb/global_control.h>

#include <algorithm>

#include "core/base/in_parallel.h"
#include "core/base/tunables.h"
#include "core/model/exported_floats.h"
#include "core/scene/transaction.h"
#include "ops/operations/commit.h"
#include "ops/placement/clearance.h"
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
};

// Pairs (a, b) with a < b whose boxes overlap, sorted.
std::vector<PairToCheck> near_pairs(const Scene& scene, const std::vector<PlacedObject>& objects) {
  std::vector<size_t> index_of;  // by slot
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
      if (j > i && overlaps(objects[i].world.box, objects[j].world.box)) out.push_back({i, j, {}});
    }
  return out;
}

void add_floor_findings(const PlacedObject& o, SceneCheck& check) {
  if (o.world.box.lower.z() >= 0) return;
  if (const auto n = num_below_floor(o.world))
    check.crossings.push_back({o.object().name, "floor", n});
  if (const auto n = num_floats_below_floor(o.world))
    check.float32_crossings.push_back({o.object().name, "floor", n});
}

void add_pair_findings(const std::string& a, const std::string& b, const PairVerdict& v,
                       SceneCheck& check) {
  if (v.crossings) check.crossings.push_back({a, b, v.crossings});
  if (v.float_crossings) check.float32_crossings.push_back({a, b, v.float_crossings});
  if (v.a_inside_b) check.contained.push_back({a, b, v.a_inside_b});
  if (v.b_inside_a) check.contained.push_back({b, a, v.b_inside_a});
}

// Partners of each object that it passes through: these do not hold it.
std::vector<std::vector<Support>> crossed_by(const std::vector<PlacedObject>& objects,
                                             const std::vector<PairToCheck>& pairs) {
  std::vector<std::vector<Support>> out(objects.size());
  for (size_t i = 0; i < objects.size(); ++i)
    if (objects[i].world.box.lower.z() < 0 && num_below_floor(objects[i].world))
      out[i].push_back(Support::floor());
  for (const PairToCheck& p : pairs)
    if (!p.verdict.clear()) {
      out[p.a].push_back(objects[p.b].id);
      out[p.b].push_back(objects[p.a].id);
    }
  return out;
}

void add_rest_findings(const PlacedObject& o, const Neighbourhood& others, const RestRules& rules,
                       SceneCheck& check) {
  const auto contacts = touching(body_of(o.object()), others, rules.clearance);
  for (const ContactsWith& c : contacts)
    for (const ContactPoint& p : c.points) check.smallest_gap = std::min(check.smallest_gap, p.gap);
  if (!o.object().fixed && !rests_at(o.object(), o.object().pose, others, rules))
    check.not_at_rest.push_back(o.object().name);
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
  return crossings.empty() && float32_crossings.empty() && contained.empty() && not_at_rest.empty();
}

SceneCheck check_scene(const Scene& scene, int num_threads, double clearance,
                       const SettleOptions& settled_by) {
  const tbb::global_control threads(
      tbb::global_control::max_allowed_parallelism,
      num_threads > 0
          ? num_threads
          : tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
  const RestRules rules = rest_rules(settled_by, believable_clearance(scene, clearance));
  const std::vector<PlacedObject> objects = placed_objects(scene);
  std::vector<PairToCheck> pairs = near_pairs(scene, objects);
  in_parallel(pairs.size(), [&](size_t i) {
    pairs[i].verdict = verify_pair(objects[pairs[i].a].world, objects[pairs[i].b].world, true,
                                   std::numeric_limits<std::int64_t>::max());
  });
  const std::vector<std::vector<Support>> crossed = crossed_by(objects, pairs);
  SceneCheck check;
  for (size_t i = 0; i < objects.size(); ++i) {
    if (scene.floor) add_floor_findings(objects[i], check);
    Neighbourhood holders(scene, objects[i].id);
    holders.leave_out(crossed[i]);
    add_rest_findings(objects[i], holders, rules, check);
  }
  for (const PairToCheck& p : pairs)
    add_pair_findings(objects[p.a].object().name, objects[p.b].object().name, p.verdict, check);
  return check;
}

namespace {

// State of a free object, from its pose; held and unsupported objects stay what they were.
ObjectState state_as_it_lies(const Scene& scene, ObjectId id, const Neighbourhood& others,
                             const RestRules& rules) {
  const Object& object = scene.at(id);
  const ObjectState was = object.state;
  if (was == ObjectState::Invalid && refuse_interpenetration(scene, id, object.pose, true))
    return was;
  if (rests_at(object, object.pose, others, rules)) return ObjectState::Stable;
  if (was == ObjectState::Held || was == ObjectState::Invalid) return ObjectState::Held;
  return was == ObjectState::Unsupported ? was : ObjectState::Wedged;
}

}  // namespace

void update_contacts(Scene& scene, double clearance, const SettleOptions& settled_by) {
  const RestRules rules = rest_rules(settled_by, believable_clearance(scene, clearance));
  Transaction transaction(scene);
  for (const ObjectId id : scene.ids()) {
    const Object& object = transaction.scene().at(id);
    if (!object.placed) continue;
    const Neighbourhood others = holders(scene, id);
    const auto contacts = touching(body_of(object), others, rules.clearance);
    const ObjectState state =
        object.fixed ? ObjectState::Fixed : state_as_it_lies(scene, id, others, rules);
    commit_object(transaction, id, object.pose, state, contacts, rules);
  }
  rate_again(transaction, scene.ids(), rules);
  transaction.commit();
}

}  // namespace trivet
