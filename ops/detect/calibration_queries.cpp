#include "ops/detect/calibration_queries.h"

#include <cmath>

namespace trivet {
namespace {

/// Offsets of the moving sphere across the motion, in radii: the farther, the narrower the image.
constexpr double kOffsets[] = {0.05, 0.8, 1.7};
constexpr double kWave = 0.05;

Vec3 on_sphere(const Vec3& on_octahedron) {
  const Vec3 d = on_octahedron.normalized();
  const auto wave = [](double x) { return x * (5 - x * x * (20 - 16 * x * x)); };  // Chebyshev, 5th
  return (1 + kWave * wave(d.x()) * wave(d.y()) * wave(d.z())) * d;
}

void add_octant(const Vec3& sign, int n, std::vector<Triangle>& out) {
  const auto at = [&](int i, int j) { return on_sphere(Vec3(i, j, n - i - j).cwiseProduct(sign)); };
  // An odd number of negative signs mirrors the octant: its faces are turned to look outwards.
  const bool mirrored = sign.prod() < 0;
  const auto add = [&](const Vec3& a, const Vec3& b, const Vec3& c) {
    out.push_back(mirrored ? Triangle{a, c, b} : Triangle{a, b, c});
  };
  for (int i = 0; i < n; ++i)
    for (int j = 0; i + j < n; ++j) {
      add(at(i, j), at(i + 1, j), at(i, j + 1));
      if (i + j + 1 < n) add(at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
    }
}

CalibrationQuery drop(const std::shared_ptr<const Shape>& sphere, double offset) {
  const Pose tilted{Rotation{0.9, 0.3, -0.2, 0.25}.normalized(), Vec3(offset, 0.03, 2.6)};
  return {sphere, world_from_object(tilted, UpAxis::Z, 1), Affine(),
          Motion::translation(-Vec3::UnitZ(), 3)};
}

// A quarter turn about an axis beside the fixed sphere, which the moving one meets on its way.
CalibrationQuery turn(const std::shared_ptr<const Shape>& sphere, double offset) {
  const Pose tilted{Rotation{0.8, -0.25, 0.3, 0.4}.normalized(), Vec3(2.2, offset, -2.2)};
  return {sphere, world_from_object(tilted, UpAxis::Z, 1), Affine(),
          Motion::rotation(Vec3(2.2, 0, 0), Vec3::UnitY(), 1)};
}

}  // namespace

std::shared_ptr<const Shape> wavy_sphere(int n) {
  std::vector<Triangle> out;
  out.reserve(static_cast<std::size_t>(8) * n * n);
  for (const double x : {1, -1})
    for (const double y : {1, -1})
      for (const double z : {1, -1}) add_octant({x, y, z}, n, out);
  return make_shape(weld(out));
}

std::vector<CalibrationQuery> calibration_queries(const std::shared_ptr<const Shape>& sphere,
                                                  Motion::Kind kind) {
  std::vector<CalibrationQuery> out;
  // Each offset makes an image of another width, which tells pixels and triangles apart.
  for (const double offset : kOffsets)
    out.push_back(kind == Motion::Kind::Translation ? drop(sphere, offset) : turn(sphere, offset));
  return out;
}

}  // namespace trivet
