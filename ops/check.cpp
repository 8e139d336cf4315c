#include "ops/check.h"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <algorithm>

#include "core/base/tunables.h"
#include "ops/rest.h"
#include "ops/verify.h"

namespace trivet {
namespace {

struct PlacedObject {
  ObjectId id;
  ObjectInWorld world;
  const Object& object() const { return *world.object; }
};

std::vector<PlacedObject> placed_objects(const Scene& scene) {
  std::vector<PlacedObject> out;
  for (const ObjectId id : scene.ids()) {
    const Object& object = scene.at(id);
    if (object.placed) out.push_back({id, in_world(object, object.pose)});
  }
  return out;
}

struct PairToCheck {
  size_t a, b;
  PairVerdict verdict;
};

std::vector<PairToCheck> near_pairs(const std::vector<PlacedObject>& objects) {
  std::vector<PairToCheck> out;
  for (size_t i = 0; i < objects.size(); ++i)
    for (size_t j = i + 1; j < objects.size(); ++j)
      if (overlaps(objects[i].world.box, objects[j].world.box)) out.push_back({i, j, {}});
  return out;
}

void add_floor_findings(const PlacedObject& o, SceneCheck& check) {
  if (o.world.box.lower.z() >= 0) return;
  if (const auto n = num_below_floor(o.world.doubles))
    check.crossings.push_back({o.object().name, "floor", n});
  if (const auto n = num_below_floor(o.world.floats))
    check.float32_crossings.push_back({o.object().name, "floor", n});
}

void add_pair_findings(const std::string& a, const std::string& b, const PairVerdict& v,
                       SceneCheck& check) {
  if (v.crossings) check.crossings.push_back({a, b, v.crossings});
  if (v.float_crossings) check.float32_crossings.push_back({a, b, v.float_crossings});
  if (v.a_inside_b) check.contained.push_back({a, b, v.a_inside_b});
  if (v.b_inside_a) check.contained.push_back({b, a, v.b_inside_a});
}

void add_rest_findings(const Scene& scene, const PlacedObject& o, double clearance,
                       SceneCheck& check) {
  const Surroundings others(scene, o.id);
  const auto contacts = touching(scene, o.object(), o.object().pose, others, clearance);
  for (const ContactsWith& c : contacts)
    for (const ContactPoint& p : c.points) check.smallest_gap = std::min(check.smallest_gap, p.gap);
  if (!o.object().fixed && !rests_at(scene, o.object(), o.object().pose, others, clearance))
    check.not_at_rest.push_back(o.object().name);
}

// What a file says its clearance was must not turn hovering into rest.
double believable_clearance(const Scene& scene, double clearance) {
  const double usual = default_clearance(scene);
  return clearance > 0 ? std::min(clearance, kLargestClearance / kRelativeClearance * usual)
                       : usual;
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

SceneCheck check_scene(const Scene& scene, int num_threads, double clearance) {
  const tbb::global_control threads(
      tbb::global_control::max_allowed_parallelism,
      num_threads > 0
          ? num_threads
          : tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
  clearance = believable_clearance(scene, clearance);
  const std::vector<PlacedObject> objects = placed_objects(scene);
  std::vector<PairToCheck> pairs = near_pairs(objects);
  tbb::parallel_for(size_t{0}, pairs.size(), [&](size_t i) {
    pairs[i].verdict = verify_pair(objects[pairs[i].a].world, objects[pairs[i].b].world, true,
                                   std::numeric_limits<std::int64_t>::max());
  });
  SceneCheck check;
  for (const PlacedObject& o : objects) {
    if (scene.floor) add_floor_findings(o, check);
    add_rest_findings(scene, o, clearance, check);
  }
  for (const PairToCheck& p : pairs)
    add_pair_findings(objects[p.a].object().name, objects[p.b].object().name, p.verdict, check);
  return check;
}

namespace {

// Of a free object, from how it lies; what nobody can see of it stays.
ObjectState state_as_it_lies(const Scene& scene, ObjectId id, const Surroundings& others,
                             double clearance) {
  const Object& object = scene.at(id);
  const ObjectState was = object.state;
  if (was == ObjectState::Invalid && !why_invalid(scene, id, object.pose, true).empty()) return was;
  if (rests_at(scene, object, object.pose, others, clearance)) return ObjectState::Stable;
  if (was == ObjectState::Held || was == ObjectState::Invalid) return ObjectState::Held;
  return was == ObjectState::Unsupported ? was : ObjectState::Wedged;
}

struct KnownCrossing {
  ObjectId id;
  std::optional<ObjectId> with;  // nothing: the floor
};

// Of what is invalid.
std::vector<KnownCrossing> crossing_pairs(const Scene& scene) {
  std::vector<KnownCrossing> out;
  for (const ObjectId id : scene.ids()) {
    const Object& object = scene.at(id);
    if (object.state != ObjectState::Invalid) continue;
    const Placement here{id, object.pose};
    for (const Interpenetration& x :
         interpenetrations(scene, {&here, 1}, true, std::numeric_limits<size_t>::max()))
      out.push_back({x.id, x.with});
  }
  return out;
}

bool means_nothing(const std::vector<KnownCrossing>& crossing, ObjectId id,
                   std::optional<ObjectId> contact_with) {
  return std::any_of(crossing.begin(), crossing.end(), [&](const KnownCrossing& x) {
    return (x.id == id && x.with == contact_with) || (x.id == contact_with && x.with == id);
  });
}

}  // namespace

void update_contacts(Scene& scene, double clearance) {
  clearance = believable_clearance(scene, clearance);
  const std::vector<KnownCrossing> crossing = crossing_pairs(scene);
  for (const ObjectId id : scene.ids()) {
    const Object& object = scene.at(id);
    if (!object.placed) continue;
    const Surroundings others(scene, id);
    auto contacts = touching(scene, object, object.pose, others, clearance);
    std::erase_if(contacts, [&](const ContactsWith& c) {
      return means_nothing(
          crossing, id,
          c.fixed == ContactsWith::kFloor ? std::optional<ObjectId>() : others.ids[c.fixed]);
    });
    const ObjectState state =
        object.fixed ? ObjectState::Fixed : state_as_it_lies(scene, id, others, clearance);
    commit(scene, id, object.pose, state, others, contacts, clearance);
  }
}

}  // namespace trivet
