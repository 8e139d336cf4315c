#include "gpu/picture/shadow_map.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace trivet {

ShadowMap fit_shadow_map(const Vec3& direction, std::span<const Vec3> hull_points, int size_px,
                         const Vec2& jitter_px) {
  Mat3 light_from_frame;  // x, y in the image, z away from the light
  light_from_frame.row(0) = direction.unitOrthogonal();
  light_from_frame.row(2) = -direction;
  light_from_frame.row(1) = direction.cross(light_from_frame.row(0).transpose());
  Aabb box;
  for (const Vec3& p : hull_points) box.extend(light_from_frame * p);
  if (box.empty()) box.extend(Vec3::Zero());
  // Two texels of margin: for the jitter, and to keep outlines inside.
  const Vec3 half = box.half_extent().cwiseMax(1e-4) * (1 + 4.0 / size_px);
  const Vec3 centre = box.centre();
  ShadowMap map;
  map.texel = 2 * std::max(half.x(), half.y()) / size_px;
  const Vec3 shift(2 * jitter_px.x() / size_px, 2 * jitter_px.y() / size_px, 0);
  Eigen::Matrix4d clip = Eigen::Matrix4d::Identity();
  for (int r = 0; r < 3; ++r) {
    clip.block<1, 3>(r, 0) = light_from_frame.row(r) / half[r];
    clip(r, 3) = shift[r] - centre[r] / half[r];
  }
  map.clip_from_frame = clip.cast<float>();
  return map;
}

}  // namespace trivet
