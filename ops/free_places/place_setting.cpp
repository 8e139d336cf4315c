#include "ops/free_places/place_setting.h"

namespace trivet {
namespace {

std::vector<ObjectId> without(std::span<const ObjectId> carried, const Support& support) {
  std::vector<ObjectId> out(carried.begin(), carried.end());
  if (support.is_object()) out.push_back(support.object());
  return out;
}

}  // namespace

PlaceSetting::PlaceSetting(const Scene& scene, ObjectId id, std::span<const ObjectId> carried,
                           const PlaceRequest& request, double motion_clearance)
    : body(body_of(scene.at(id), {request.rotation, Vec3::Zero()})),
      centre(body.world_from_object.apply(scene.at(id).shape->mass.centre)),
      region(PlaceRegion(request.region).of_point(centre.head<2>(), body)),
      others(scene, without(carried, request.on)),
      clearance(motion_clearance) {
  if (request.on.is_object()) support = body_of(scene.at(request.on.object()));
  const double top = support ? support->world_box.upper.z() : 0;
  // The start is just above the support, unless a height is given.
  start_z = request.from.value_or(top + 4 * clearance);
}

Pose PlaceSetting::start(const Rotation& rotation, const Vec2& at) const {
  const Vec2 position = at - centre.head<2>();
  return {rotation,
          Vec3(position.x(), position.y(), start_z - body.world_box.lower.z() + clearance)};
}

}  // namespace trivet
