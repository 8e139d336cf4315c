#include "ops/arrange/sight_grid.h"

#include <Eigen/Geometry>
#include <cmath>

namespace trivet {
namespace {

constexpr int kRaysAcross = 8;
constexpr double kAbove = 1e-6;  // metres over a box, where rays down to it begin
// Tangent of the widest angle to the box's centre: 76 degrees. Of a corner nearly abeam it is so
// large that hardly a ray of the grid would meet the object.
constexpr double kWidest = 4;

// Centres of the cells of a grid on the rectangle.
std::vector<Vec2> grid_on(const Vec2& lower, const Vec2& upper) {
  std::vector<Vec2> out;
  out.reserve(kRaysAcross * kRaysAcross);
  for (int row = 0; row < kRaysAcross; ++row)
    for (int column = 0; column < kRaysAcross; ++column) {
      const Vec2 cell((column + 0.5) / kRaysAcross, (row + 0.5) / kRaysAcross);
      out.emplace_back(lower + cell.cwiseProduct(Vec2(upper - lower)));
    }
  return out;
}

}  // namespace

Vec3 corner_of(const Aabb& box, int i) {
  return {i & 1 ? box.upper.x() : box.lower.x(), i & 2 ? box.upper.y() : box.lower.y(),
          i & 4 ? box.upper.z() : box.lower.z()};
}

std::vector<Ray> rays_to(const Vec3& eye, const Aabb& box) {
  const Vec3 to = box.centre() - eye;
  if (!(to.norm() > 0)) return {};
  const Vec3 ahead = to.normalized();
  const Vec3 aside = (std::abs(ahead.z()) < 0.9 ? Vec3::UnitZ() : Vec3::UnitX());
  // The grid spans what is seen of the box, in the plane ahead of the eye.
  const Vec3 right = ahead.cross(aside).normalized(), up = right.cross(ahead);
  Vec2 lower = Vec2::Constant(kInfinity), upper = -lower;
  for (int i = 0; i < 8; ++i) {
    const Vec3 v = corner_of(box, i) - eye;
    if (!(v.dot(ahead) > 0)) return {{eye, ahead}};  // the eye is in it, or nearly
    const Vec2 p(v.dot(right) / v.dot(ahead), v.dot(up) / v.dot(ahead));
    lower = lower.cwiseMin(p), upper = upper.cwiseMax(p);
  }
  lower = lower.cwiseMax(-kWidest), upper = upper.cwiseMin(kWidest);
  std::vector<Ray> out;
  out.reserve(kRaysAcross * kRaysAcross);
  for (const Vec2& p : grid_on(lower, upper))
    out.push_back({eye, (ahead + p.x() * right + p.y() * up).normalized()});
  return out;
}

std::vector<Ray> rays_down_to(const Aabb& box) {
  std::vector<Ray> out;
  out.reserve(kRaysAcross * kRaysAcross);
  for (const Vec2& p : grid_on(box.lower.head<2>(), box.upper.head<2>()))
    out.push_back({Vec3(p.x(), p.y(), box.upper.z() + kAbove), -Vec3::UnitZ()});
  return out;
}

}  // namespace trivet
