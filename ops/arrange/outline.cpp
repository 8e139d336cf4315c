#include "ops/arrange/outline.h"

#include <algorithm>
#include <tuple>

#include "core/contact/contact_points.h"
#include "core/mesh/mass.h"
#include "ops/arrange/convex_region.h"

namespace trivet {
namespace {

constexpr double kLeastFront = 0.1;  // horizontal part of a front

Vec2 front_of(const Rotation& rotation, const Vec3& front) {
  const Vec2 seen = (rotation.matrix() * front).head<2>();
  if (seen.norm() >= kLeastFront) return seen.normalized();
  // The turn about z alone: what is left when the tilt is undone.
  const Vec3 up = rotation.matrix().col(2);
  const Vec2 level =
      (smallest_rotation(up, Vec3::UnitZ()).matrix() * (rotation.matrix() * front)).head<2>();
  return level.norm() > 0 ? Vec2(level.normalized()) : Vec2(-Vec2::UnitY());
}

}  // namespace

double Outline::width(const Vec2& direction) const {
  return extent(hull, direction) + extent(hull, -direction);
}

std::vector<Vec3> hull_points(const Shape& shape) {
  std::vector<Vec3> out;
  const std::vector<Index> ids = convex_hull_vertices(shape.mesh);
  out.reserve(ids.size());
  for (const Index v : ids) out.push_back(shape.mesh.vertices[v]);
  return out;
}

Outline outline_of(const std::vector<Vec3>& points, const Object& object, const Pose& pose,
                   const Vec3& front) {
  const Affine world = world_from_object(pose, object.up, object.scale);
  // The hull of the points seen from above, and their lowest and highest, are all that relations
  // know.
  Outline out;
  out.bottom = kInfinity, out.top = -kInfinity;
  std::vector<Vec2> seen;
  seen.reserve(points.size());
  for (const Vec3& p : points) {
    const Vec3 q = world.apply(p);
    seen.push_back(q.head<2>());
    out.bottom = std::min(out.bottom, q.z());
    out.top = std::max(out.top, q.z());
  }
  out.hull = convex_hull(std::move(seen));
  out.mass_centre = world.apply(object.shape->mass.centre).head<2>();
  out.front = front_of(pose.rotation, front);
  // The centre is that of the box along front and right, as people measure.
  for (const Vec2& axis : {out.front, out.right()})
    out.centre += 0.5 * (extent(out.hull, axis) - extent(out.hull, -axis)) * axis;
  return out;
}

std::vector<Vec3> rim_of(const std::vector<Vec3>& points, const Object& object, const Pose& pose,
                         const Outline& outline) {
  const auto less = [](const Vec2& a, const Vec2& b) {
    return std::make_tuple(a.x(), a.y()) < std::make_tuple(b.x(), b.y());
  };
  std::vector<Vec2> corners = outline.hull;
  std::sort(corners.begin(), corners.end(), less);
  const Affine world = world_from_object(pose, object.up, object.scale);
  std::vector<Vec3> out;
  // Points inside the outline and between top and bottom never count while the thing turns about z.
  for (const Vec3& p : points) {
    const Vec3 q = world.apply(p);
    if (q.z() == outline.bottom || q.z() == outline.top ||
        std::binary_search(corners.begin(), corners.end(), Vec2(q.head<2>()), less))
      out.push_back(p);
  }
  return out;
}

Outline moved(Outline outline, const Vec2& by) {
  for (Vec2& p : outline.hull) p += by;
  outline.centre += by;
  outline.mass_centre += by;
  return outline;
}

}  // namespace trivet
