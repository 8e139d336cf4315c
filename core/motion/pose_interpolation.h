// Pose interpolation, for display only; no answer depends on it.
#pragma once

#include "core/motion/pose.h"

namespace trivet {

/// Metres from one pose to another: the path of the origin, and the arc at distance `radius` from
/// it, turning the short way.
double path_length(const Pose& from, const Pose& to, double radius);

/// Pose of a carried load when the object is at `now`, given that the load ends at `end` when the
/// object ends at `object_end`.
Pose carried_pose(const Pose& now, const Pose& object_end, const Pose& end);

/// Interpolates between two poses of one motion: a straight line, a turn about a fixed axis, or a
/// screw.
Pose interpolate_pose(const Pose& from, const Pose& to, double part);

/// Interpolates between two poses without a known motion: the origin goes straight while the object
/// turns.
Pose interpolate_straight(const Pose& from, const Pose& to, double part);

}  // namespace trivet
