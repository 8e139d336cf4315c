#include "apps/edit/tools/lean.h"

#include <Eigen/Geometry>

#include "apps/edit/tools/picking.h"
#include "ops/operations/turn_axis.h"

namespace trivet::edit {
namespace {

constexpr double kMostDeg = 85;

/// From a point to the nearest place of a box, level and unit; zero if it is inside.
Vec3 way_to(const Aabb& wall, const Vec3& from) {
  Vec3 way = from.cwiseMax(wall.lower).cwiseMin(wall.upper) - from;
  way.z() = 0;
  return way.norm() > 0 ? Vec3(way.normalized()) : Vec3(Vec3::Zero());
}

/// Across an edge of the support, level and unit, to where the wall is nearest and nothing is
/// between; zero: nowhere.
Vec3 way_across_edges(const ObjectSnapshot& object, const ObjectSnapshot& wall,
                      const std::vector<Vec3>& hull, const SceneSnapshot& scene) {
  const Vec3 from = object->centre_of_mass();
  Vec3 nearest = Vec3::Zero();
  double time = kInfinity;
  for (size_t i = 0; i < hull.size(); ++i) {
    const Vec3 way = (hull[(i + 1) % hull.size()] - hull[i]).cross(Vec3::UnitZ());
    if (!(way.norm() > 0)) continue;
    for (const Vec3& there : {way, Vec3(-way)}) {
      const auto hit = pick(scene, {from, there.normalized()}, {object.id});
      if (!hit || hit->object != wall.id || hit->time >= time) continue;
      time = hit->time;
      nearest = there.normalized();
    }
  }
  return nearest;
}

const ObjectContact* support_of(const Object& object) {
  const ObjectContact* best = nullptr;
  for (const ObjectContact& entry : object.contacts)
    if (holds_up(entry) && entry.contact.hull.size() > 1 && (!best || holds_more(entry, *best)))
      best = &entry;
  return best;
}

}  // namespace

std::optional<TurnOperation> lean_against(const ObjectSnapshot& object, const ObjectSnapshot& wall,
                                          const SceneSnapshot& scene) {
  const ObjectContact* const support = support_of(*object.object);
  if (!support) return std::nullopt;
  const std::vector<Vec3>& hull = support->contact.hull;
  Vec3 way = way_across_edges(object, wall, hull, scene);
  if (way.isZero()) way = way_to(world_box(*wall.object), object->centre_of_mass());
  if (way.isZero()) return std::nullopt;
  Vec3 edge = 0.5 * (hull[0] + hull[1]);
  for (size_t i = 1; i < hull.size(); ++i) {
    const Vec3 middle = 0.5 * (hull[i] + hull[(i + 1) % hull.size()]);
    if (middle.dot(way) > edge.dot(way)) edge = middle;
  }
  TurnOperation turn;
  turn.object = object->name;
  turn.about = TurnOperation::About::Line;
  turn.with = support->with.is_object() ? (*scene.find(support->with.object()))->name : "floor";
  turn.point = edge;
  turn.axis = Vec3::UnitZ().cross(way);
  turn.angle_deg = kMostDeg;
  turn.settle = true;
  return turn;
}

}  // namespace trivet::edit
