#include "core/contact/leaf_box.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "core/contact/rounding.h"

namespace trivet {
namespace {

Triangle in_frame(const Triangle& t, const UnitFrame& frame) {
  return {frame.point(t[0]), frame.point(t[1]), frame.point(t[2])};
}

}  // namespace

LeafBox::LeafBox(const Body& body, const BvhNode& leaf, const UnitFrame& frame) {
  const Index* faces = &body.shape->bvh().faces[leaf.second_child];
  const Triangle t = in_frame(body.triangle(faces[0]), frame);
  const std::array<Vec3, 3> edge{t[1] - t[0], t[2] - t[1], t[0] - t[2]};
  const Vec3& longest = *std::max_element(
      edge.begin(), edge.end(),
      [](const Vec3& a, const Vec3& b) { return a.squaredNorm() < b.squaredNorm(); });
  const Vec3 n = edge[0].cross(edge[1]);
  valid = n.squaredNorm() > kFlat * longest.squaredNorm() * longest.squaredNorm();
  if (!valid) return;
  axis[0] = n.normalized();
  axis[1] = longest.normalized();
  axis[2] = axis[0].cross(axis[1]);
  lower.fill(kInfinity);
  upper.fill(-kInfinity);
  for (Index i = 0; i < leaf.num_faces; ++i)
    for (const Vec3& p : in_frame(body.triangle(faces[i]), frame))
      for (int k = 0; k < 3; ++k) {
        lower[k] = std::min(lower[k], axis[k].dot(p));
        upper[k] = std::max(upper[k], axis[k].dot(p));
      }
}

double LeafBox::gap(const Vec3& centre, double radius) const {
  double gap = -kInfinity;
  for (int k = 0; k < 3; ++k) {
    const double x = axis[k].dot(centre);
    gap = std::max({gap, x - upper[k], lower[k] - x});
  }
  return gap - radius;
}

}  // namespace trivet
