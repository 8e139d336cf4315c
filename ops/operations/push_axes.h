// The plane of a PUSH: axes across the direction that counts as up.
#pragma once

#include <Eigen/Geometry>
#include <cmath>

#include "core/base/types.h"

namespace trivet {

/// Length of the normal seen from above.
inline double level_part(const Vec3& normal) {
  return std::sqrt(normal.x() * normal.x() + normal.y() * normal.y());
}

/// True within a micrometre per metre.
inline bool is_vertical(const Vec3& normal) {
  constexpr double kRounding = 1e-6;
  return level_part(normal) <= kRounding * std::abs(normal.z());
}

/// Rows: the two axes in which directions and goals of a PUSH are given, then the unit normal. With
/// the normal upwards x, y and z; on walls, seen from the object's side, to the right and upwards;
/// under a ceiling x and -y. What is vertical but for rounding counts as vertical: the axes of
/// walls turn with it.
/// @param normal  from the surface to the object, any length but zero.
inline Mat3 push_axes(const Vec3& normal) {
  Mat3 rows = Mat3::Identity();
  const double level = level_part(normal);
  if (is_vertical(normal)) {
    if (normal.z() < 0) rows(1, 1) = rows(2, 2) = -1;
    return rows;
  }
  const Vec3 n = normal.normalized(), right(-normal.y() / level, normal.x() / level, 0);
  rows << right.transpose(), n.cross(right).transpose(), n.transpose();
  return rows;
}

/// True if the axes are those of the world: the push is level.
inline bool is_level(const Vec3& normal) { return is_vertical(normal) && normal.z() > 0; }

inline Vec3 level(const Vec2& v) { return {v.x(), v.y(), 0}; }

/// A point or vector of the world in these axes; its own bits where the push is level.
inline Vec3 in_push_axes(const Vec3& normal, const Vec3& v) {
  return is_level(normal) ? v : Vec3(push_axes(normal) * v);
}

}  // namespace trivet
