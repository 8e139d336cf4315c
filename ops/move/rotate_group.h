// A turn of any angle, as motions of at most a quarter turn.
#pragma once

#include "ops/move/attempt.h"

namespace trivet {

/// Turns until collision or the angle is reached; result.turned_deg says how far.
/// @param axis  unit. @param free  through everything.
void rotate_group(Attempt& attempt, const Vec3& centre, const Vec3& axis, double angle_deg,
                  bool free);

}  // namespace trivet
