// The plane of a PUSH: axes across the direction that counts as up.
#pragma once

#include <Eigen/Geometry>
#include <cmath>

#include "core/base/types.h"

namespace trivet {

/// Rows: the two axes in which directions and goals of a PUSH are given, then the unit normal. With
/// the normal upwards x, y and z; on walls, seen from the object's side, to the right and upwards;
/// under a ceiling x and -y.
/// @param normal  from the surface to the object, any length but zero.
inline Mat3 push_axes(const Vec3& normal) {
  Mat3 rows = Mat3::Identity();
  const double level = std::sqrt(normal.x() * normal.x() + normal.y() * normal.y());
  if (level == 0) {
    if (normal.z() < 0) rows(1, 1) = rows(2, 2) = -1;
    return rows;
  }
  const Vec3 n = normal.normalized(), right(-normal.y() / level, normal.x() / level, 0);
  rows << right.transpose(), n.cross(right).transpose(), n.transpose();
  return rows;
}

/// True if the axes are those of the world: the push is level.
inline bool is_level(const Vec3& normal) {
  return normal.x() == 0 && normal.y() == 0 && normal.z() > 0;
}

/// A point or vector of the world in these axes; its own bits where the push is level.
inline Vec3 in_push_axes(const Vec3& normal, const Vec3& v) {
  return is_level(normal) ? v : Vec3(push_axes(normal) * v);
}

}  // namespace trivet
