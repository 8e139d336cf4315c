#include "apps/edit/tools/placing.h"

#include <algorithm>
#include <cmath>

namespace trivet::edit {
namespace {

bool overlap_from_above(const Aabb& a, const Aabb& b) {
  return a.lower.x() <= b.upper.x() && b.lower.x() <= a.upper.x() && a.lower.y() <= b.upper.y() &&
         b.lower.y() <= a.upper.y();
}

}  // namespace

Pose put_start(const SceneSnapshot& scene, const Object& object,
               const std::vector<ObjectId>& moving, const Vec3& point, double height, bool near) {
  Pose start{object.pose.rotation, Vec3::Zero()};
  Object there = object;
  there.pose = start;
  const Vec2 aside = point.head<2>() - there.centre_of_mass().head<2>();
  start.translation.head<2>() = aside;
  there.pose = start;
  const Aabb box = world_box(there);
  double top = near ? point.z() : std::max(point.z(), scene.floor ? 0.0 : -kInfinity);
  for (const ObjectSnapshot& o : scene.objects) {
    if (near || !o->placed) continue;
    if (std::find(moving.begin(), moving.end(), o.id) != moving.end()) continue;
    const Aabb other = world_box(*o.object);
    if (overlap_from_above(box, other)) top = std::max(top, other.upper.z());
  }
  start.translation.z() = top + height - box.lower.z();
  return start;
}

double rounded(double value, double step) {
  if (!(step > 0)) return value;
  const double per_unit = std::pow(10, std::ceil(-std::log10(step)));
  return std::round(value * per_unit) / per_unit;
}

}  // namespace trivet::edit
