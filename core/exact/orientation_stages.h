// The two stages of orient2d() and orient3d(): a floating-point filter, inline because it decides
// nearly every call, and the exact fallback. For tests that compare them; other code uses
// predicates.h.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/types.h"

namespace trivet {

int orient2d_exact(const Vec2& a, const Vec2& b, const Vec2& c);
int orient3d_exact(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

inline constexpr double kUnitRoundoff = 0x1p-53;

/// The sign, if rounding cannot have changed it.
/// Both products pass through 4 roundings, of two differences, the product and the sum: the error
/// is below 4.01 u x (|left| + |right|); the sum of the magnitudes is itself good to 4.01 u.
/// Products that underflow are off by less than 2^-1074: the constant covers them.
inline std::optional<int> orient2d_filter(const Vec2& a, const Vec2& b, const Vec2& c) {
  const double left = (b.x() - a.x()) * (c.y() - a.y());
  const double right = (b.y() - a.y()) * (c.x() - a.x());
  const double det = left - right;
  const double bound = 5 * kUnitRoundoff * (std::abs(left) + std::abs(right)) + 0x1p-1000;
  if (std::abs(det) > bound) return det > 0 ? 1 : -1;
  return std::nullopt;
}

/// The sign, if rounding cannot have changed it. Each of the 6 terms of the determinant is at most
/// x_max y_max z_max and passes through 8 roundings, of three differences, a product, a difference,
/// a product and two sums: the error is below 48.01 u x_max y_max z_max. Underflow is harmless if
/// the differences are above 2^-300: its error is below 2^-1072 max(x_max, y_max, z_max), the 2 u
/// to spare are above 2^-652 max(x_max, y_max, z_max). If all differences along an axis are 0, so
/// is the sign.
inline std::optional<int> orient3d_filter(const Vec3& a, const Vec3& b, const Vec3& c,
                                          const Vec3& d) {
  const double ax = a.x() - d.x(), ay = a.y() - d.y(), az = a.z() - d.z();
  const double bx = b.x() - d.x(), by = b.y() - d.y(), bz = b.z() - d.z();
  const double cx = c.x() - d.x(), cy = c.y() - d.y(), cz = c.z() - d.z();
  // The bound needs the largest difference along each axis only: cheaper than the sum of all
  // magnitudes, and nearly as sharp.
  const double x_max = std::max(std::max(std::abs(ax), std::abs(bx)), std::abs(cx));
  const double y_max = std::max(std::max(std::abs(ay), std::abs(by)), std::abs(cy));
  const double z_max = std::max(std::max(std::abs(az), std::abs(bz)), std::abs(cz));
  const double det = ax * (by * cz - bz * cy) + bx * (cy * az - cz * ay) + cx * (ay * bz - az * by);
  const double bound = 50 * kUnitRoundoff * x_max * y_max * z_max;
  const double smallest = std::min(std::min(x_max, y_max), z_max);
  if (std::abs(det) > bound && smallest > 0x1p-300) return det > 0 ? 1 : -1;
  if (smallest == 0) return 0;
  return std::nullopt;
}

}  // namespace trivet
