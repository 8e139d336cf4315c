// Poses as numbers that people read and type: metres, and degrees about the axes.
#pragma once

#include "core/motion/pose.h"

namespace trivet::edit {

/// Degrees about x, then y, then z, axes of the world: in [-180, 180], y in [-90, 90]. Where y is
/// 90 degrees either way, x is 0.
Vec3 angles_deg(const Rotation& rotation);
/// The inverse, for angles in [-360, 360].
Rotation rotation_by_angles(const Vec3& deg);
/// A turn about a unit axis, in [-360, 360] degrees.
Rotation turned_about(const Vec3& axis, double deg);

enum class PosePart { Position, Rotation };
/// The pose with one number replaced; an unchanged rotation or coordinate keeps all its digits.
/// @param axis  0 x, 1 y, 2 z.
Pose with_number(Pose pose, PosePart part, int axis, double value);

}  // namespace trivet::edit
