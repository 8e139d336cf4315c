// Rotations that leave a model as it is. Private.
#pragma once

#include <optional>
#include <vector>

#include "core/base/types.h"

namespace trivet {

/// A surface of revolution.
struct Revolution {
  Vec3 axis = Vec3::UnitZ();  // unit
  Vec3 point = Vec3::Zero();  // on it
  bool flips = false;  // half a turn about any axis across it through the point leaves it as it is
};

/// Surfaces that were turned on a lathe: about an axis of the frame through the middle of the
/// box or the mean of the corners, every vertex, and every face that is not across the axis, is
/// one of a full ring without gaps of 30 degrees. Scans and surfaces about other axes are not
/// found. The same answer on any machine.   Cost O(n log n).
/// @param materials  of the faces: rings have one each. Empty: the same for all.
std::optional<Revolution> surface_of_revolution(const std::vector<Vec3>& vertices,
                                                const std::vector<Index3>& triangles,
                                                const std::vector<Index>& materials);

}  // namespace trivet
