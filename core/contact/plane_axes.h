// Axes in a plane. Private.
#pragma once

#include <Eigen/Geometry>

#include "core/base/types.h"

namespace trivet {

/// Right-handed with the unit normal `n`.
inline std::array<Vec3, 2> plane_axes(const Vec3& n) {
  int k = 0;
  n.cwiseAbs().minCoeff(&k);
  const Vec3 u = n.cross(Vec3::Unit(k)).normalized();
  return {u, n.cross(u)};
}

}  // namespace trivet
