#include "ops/place/place_setting.h"

#include <algorithm>

#include "ops/move/moving_group.h"

namespace trivet {

PlaceSetting::PlaceSetting(const Scene& scene, ObjectId id, const PlaceRequest& request,
                           double motion_clearance)
    : floor(scene.floor), on_floor(!request.on), clearance(motion_clearance) {
  const Object& object = scene.at(id);
  body = Body(*object.shape,
              world_from_object({request.rotation, Vec3::Zero()}, object.up, object.scale));
  centre = body.world_from_object.apply(object.shape->mass.centre);
  const std::vector<ObjectId> carried = carried_with(scene, id);
  for (const ObjectId other : scene.ids()) {
    const Object& o = scene.at(other);
    if (!o.placed || std::find(carried.begin(), carried.end(), other) != carried.end()) continue;
    auto& bodies = request.on == other ? support : others;
    bodies.emplace_back(*o.shape, o.world_from_object());
  }
  const double top = on_floor ? 0 : support.front().world_box.upper.z();
  start_z = request.from.value_or(top + 4 * clearance);
}

Pose PlaceSetting::start(const Rotation& rotation, const Vec2& at) const {
  const Vec2 position = at - centre.head<2>();
  return {rotation,
          Vec3(position.x(), position.y(), start_z - body.world_box.lower.z() + clearance)};
}

}  // namespace trivet
