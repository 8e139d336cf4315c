#include "ops/move/leaning.h"

#include <algorithm>

#include "core/base/tunables.h"

namespace trivet {
namespace {

double size_of(const Object& object) { return object.scale * object.shape->box.diagonal(); }

bool leans(const Object& object) {
  return object.state == ObjectState::Stable && !stands_on_its_own(object);
}

Aabb box_of(const Object& object) {
  return Body(*object.shape, object.world_from_object()).world_box;
}

}  // namespace

bool stands_on_its_own(const Object& object) {
  return object.state == ObjectState::Stable &&
         object.stability_margin >= kRestMargin * size_of(object);
}

std::vector<ObjectId> leaning_on(const Scene& scene, const Object& object,
                                 const Surroundings& others) {
  std::vector<ObjectId> out;
  if (!object.placed) return out;
  const Aabb box = box_of(object);
  for (size_t i = 0; i < others.ids.size(); ++i) {
    const Object& other = scene.at(others.ids[i]);
    if (leans(other) && overlaps(others.bodies[i].world_box, box, size_of(other)))
      out.push_back(others.ids[i]);
  }
  return out;
}

bool leans_on_any(const Scene& scene, const Object& object, const Surroundings& others) {
  if (!object.placed || !leans(object)) return false;
  const Aabb box = box_of(object);
  const double reach = size_of(object);
  return (scene.floor && box.lower.z() <= reach) ||
         std::any_of(others.bodies.begin(), others.bodies.end(),
                     [&](const Body& other) { return overlaps(box, other.world_box, reach); });
}

}  // namespace trivet
