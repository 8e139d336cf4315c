#include "apps/edit/tools/lean.h"

#include <Eigen/Geometry>

#include "ops/operations/turn_axis.h"

namespace trivet::edit {
namespace {

constexpr double kMostDeg = 85;

/// From the middle of an object to the nearest place of a box, level and unit; zero if it is
/// inside.
Vec3 way_to(const Aabb& wall, const Vec3& from) {
  Vec3 way = from.cwiseMax(wall.lower).cwiseMin(wall.upper) - from;
  way.z() = 0;
  return way.norm() > 0 ? Vec3(way.normalized()) : Vec3(Vec3::Zero());
}

const ObjectContact* support_of(const Object& object) {
  const ObjectContact* best = nullptr;
  for (const ObjectContact& entry : object.contacts)
    if (holds_up(entry) && entry.contact.hull.size() > 1 && (!best || holds_more(entry, *best)))
      best = &entry;
  return best;
}

}  // namespace

std::optional<TurnOperation> lean_against(const Object& object, const Object& wall,
                                          const SceneSnapshot& scene) {
  const ObjectContact* const support = support_of(object);
  const Vec3 way = way_to(world_box(wall), object.centre_of_mass());
  if (!support || way.isZero()) return std::nullopt;
  const std::vector<Vec3>& hull = support->contact.hull;
  Vec3 edge = 0.5 * (hull[0] + hull[1]);
  for (size_t i = 1; i < hull.size(); ++i) {
    const Vec3 middle = 0.5 * (hull[i] + hull[(i + 1) % hull.size()]);
    if (middle.dot(way) > edge.dot(way)) edge = middle;
  }
  TurnOperation turn;
  turn.object = object.name;
  turn.about = TurnOperation::About::Line;
  turn.with = support->with.is_object() ? (*scene.find(support->with.object()))->name : "floor";
  turn.point = edge;
  turn.axis = Vec3::UnitZ().cross(way);
  turn.angle_deg = kMostDeg;
  turn.settle = true;
  return turn;
}

}  // namespace trivet::edit
