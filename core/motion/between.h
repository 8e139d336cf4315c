// Poses between two others, to be watched; no answer depends on them.
#pragma once

#include "core/motion/pose.h"

namespace trivet {

/// Metres from one pose to another: of the origin, and of what is `radius` away from it when it
/// turns, the short way.
double length_between(const Pose& from, const Pose& to, double radius);

/// Where something is that ends at `end` and is carried, when the object is at `now` and ends at
/// `object_end`.
Pose carried_pose(const Pose& now, const Pose& object_end, const Pose& end);

/// Between two poses on one motion: a straight line, a turn about a fixed axis, or a screw.
Pose between(const Pose& from, const Pose& to, double part);

/// Between two poses that no motion is known for: its origin goes straight while it turns.
Pose straight_between(const Pose& from, const Pose& to, double part);

}  // namespace trivet
