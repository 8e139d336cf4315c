// Private. How thick flat parts are at least.
#pragma once

#include <algorithm>
#include <span>

#include "core/base/types.h"

namespace trivet {

/// Thinner than this, of the farthest coordinate, a part is flat but for the rounding of float32: 8
/// roundings. It gets twice as much, so that it is not flat again when it is scaled and rounded.
inline constexpr double kFlatByRounding = 0x1p-21;

inline double farthest_coordinate(std::span<const Vec3> points) {
  double out = 0;
  for (const Vec3& p : points) out = std::max(out, p.cwiseAbs().maxCoeff());
  return out;
}

/// The diagonal of the box of the points; 1 if they are all the same.
inline double flat_size(std::span<const Vec3> points) {
  Aabb box;
  for (const Vec3& p : points) box.extend(p);
  return box.diagonal() > 0 ? box.diagonal() : 1.0;
}

/// Thickness of a flat part, in the unit of the points: `relative` to its size, or more where that
/// would be lost in rounding.
inline double flat_thickness(std::span<const Vec3> points, double relative) {
  return std::max(relative * flat_size(points), 2 * kFlatByRounding * farthest_coordinate(points));
}

}  // namespace trivet
