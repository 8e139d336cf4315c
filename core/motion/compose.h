// Poses as maps of frames: one after the other, back, and turns by degrees.
#pragma once

#include "core/motion/pose.h"

namespace trivet {

/// First b, then a: pose of b's frame in the frame that `a` is in.
Pose composed(const Pose& a, const Pose& b);
Pose inverse(const Pose& pose);
/// Angle of any size, degrees, about a unit axis.
Rotation turn_about(const Vec3& axis, double degrees);
/// True if no number differs.
bool is_same_pose(const Pose& a, const Pose& b);

}  // namespace trivet
