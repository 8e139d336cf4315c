// Links in a joint, slid or turned along it with all that lies on or in them, up to a limit or the
// first contact.
#pragma once

#include <string>
#include <vector>

#include "ops/operations/operation_run.h"
#include "ops/placement/neighbourhood.h"

namespace trivet {

/// A joint whose links are fixed objects of a scene. Metres, or degrees where it turns; world.
struct JointToMove {
  std::string name;
  bool turns = false;           // a hinge; else a slide
  std::vector<ObjectId> links;  // that move, the one in the joint first
  Vec3 axis = Vec3::UnitZ();    // unit; a turn is right-handed about it
  Vec3 anchor = Vec3::Zero();   // a point on the axis of a hinge
  double value = 0;
  double lower = -kInfinity, upper = kInfinity;
};

struct JointMove {
  enum class End { Reached, Limit, Blocked } end = End::Reached;
  double value = 0;                    // where the joint is now
  std::vector<ObjectId> carried;       // loads that went along
  Support blocker = Support::floor();  // Blocked: what stopped it, and where
  Vec3 point = Vec3::Zero();
};

/// Moves a joint to a value. What lies on or in the links comes along; nothing passes through
/// anything but by the scene's pair rules, which must let links pass what they hang in. Objects
/// that do not come along stay, even if nothing holds them any more. The scene's contacts must be
/// those of its poses; they are not found anew.
JointMove move_joint(Scene& scene, const JointToMove& joint, double to, const OperationRun& run);

}  // namespace trivet
