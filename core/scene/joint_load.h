// Weights at joints: the force along an axis, or the torque about it, and what that moves.
#pragma once

#include "core/base/types.h"

namespace trivet {

inline constexpr double kGravity = 9.80665;  // m/s^2

/// A slide or hinge in the world, where it is. Metres, or degrees where it turns.
struct JointPlace {
  bool turns = false;                                // a hinge; else a slide
  Vec3 axis = Vec3::UnitZ(), anchor = Vec3::Zero();  // unit; a point on the axis of a hinge
  double value = 0;
  double lower = -kInfinity, upper = kInfinity;
};

/// Effect of a weight on the joint: newtons along the axis or newton metres about it.
/// @param centre  of mass, world. @param newtons  the weight.
double joint_load(const JointPlace& joint, const Vec3& centre, double newtons);

/// True if the load moves the joint: friction does not hold it, and no limit.
bool moves_joint(const JointPlace& joint, double friction, double load);

}  // namespace trivet
