#include "apps/demo/shapes/parts.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace trivet::shapes {
Surface moved(Surface surface, const Vec3& by) {
  for (Triangle& t : surface.triangles)
    for (Vec3& p : t) p += by;
  return surface;
}

Surface turned(Surface surface, const Vec3& axis, double angle_deg) {
  const Eigen::AngleAxisd rotation(angle_deg * kTurn / 360, axis.normalized());
  const Eigen::Matrix3d matrix = rotation.toRotationMatrix();
  for (Triangle& t : surface.triangles)
    for (Vec3& p : t) p = matrix * p;
  return surface;
}

Surface painted(Surface surface, Index material) {
  surface.materials.assign(surface.triangles.size(), material);
  return surface;
}

Surface painted(Surface surface, Index material, const std::function<bool(const Vec3&)>& wanted) {
  for (size_t f = 0; f < surface.triangles.size(); ++f) {
    const auto& [a, b, c] = surface.triangles[f];
    if (wanted((a + b + c) / 3)) surface.materials[f] = material;
  }
  return surface;
}

Ring rectangle(const Vec2& half_size, double z) {
  const double x = half_size.x(), y = half_size.y();
  return {{Vec3(x, y, z), Vec3(-x, y, z), Vec3(-x, -y, z), Vec3(x, -y, z)}, 0};
}

Surface box(const Vec3& lower, const Vec3& upper, double bevel) {
  const Vec3 middle = 0.5 * (lower + upper), half = 0.5 * (upper - lower);
  const std::vector<Ring> rings =
      bevel > 0 ? slab(half.head<2>(), 2 * bevel, bevel, -half.z(), half.z(), 1)
                : std::vector<Ring>{rectangle(half.head<2>(), -half.z()),
                                    rectangle(half.head<2>(), half.z())};
  return moved(skin(rings), middle);
}

void add_box(const Vec3& lower, const Vec3& upper, double bevel, Index material,
             std::vector<Part>* parts) {
  parts->push_back({painted(box(lower, upper, bevel), material), 40});
}

std::vector<Ring> cushion(const Vec2& half_size, double radius,
                          const std::vector<CurveSample>& outline, int corner_segments) {
  std::vector<Ring> rings;
  for (const CurveSample& at : outline) {
    const double inset = at[0];
    rings.push_back(rounded_rectangle(half_size.x() - inset, half_size.y() - inset, radius - inset,
                                      corner_segments, at[1]));
    rings.back().material = at.material;
  }
  return rings;
}

Surface rod(const Vec3& from, const Vec3& to, double radius_from, double radius_to, int segments) {
  const Vec3 along = (to - from).normalized();
  const Vec3 across = along.unitOrthogonal(), third = along.cross(across);
  const auto ring = [&](const Vec3& centre, double radius) {
    Ring out;
    for (int k = 0; k < segments; ++k) {
      const double angle = kTurn * (k + 0.5) / segments;
      out.points.push_back(centre + radius * (std::cos(angle) * across + std::sin(angle) * third));
    }
    return out;
  };
  return skin({ring(from, radius_from), ring(to, radius_to)});
}

Surface bow_handle(double half_length) {
  const double h = half_length, sunk = -0.001, thick = 0.004;
  const auto path =
      flatten({smooth({-h, sunk, thick, thick}), smooth({0.001 - h, 0.020, thick, thick}),
               smooth({0.015 - h, 0.028, thick, thick}), smooth({h - 0.015, 0.028, thick, thick}),
               smooth({h - 0.001, 0.020, thick, thick}), smooth({h, sunk, thick, thick})},
              0.0008);
  return turned(skin(sweep(path, 8)), Vec3::UnitX(), 90);
}

Part handle(const std::vector<CurveSample>& path, int segments,
            const std::vector<CurveSample>& body, double depth) {
  std::vector<Ring> tube = sweep(path, segments);
  sink_into(body, depth, &tube.front());
  sink_into(body, depth, &tube.back());
  return {skin(tube), 75};
}

}  // namespace trivet::shapes
