// Links in a joint, slid or turned along it with all that lies on or in them, up to a limit or the
// first contact.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/scene/joint_load.h"
#include "ops/operations/moving_group.h"
#include "ops/operations/operation_run.h"

namespace trivet {

/// A joint whose links are fixed objects of a scene.
struct JointToMove : JointPlace {
  std::string name;
  std::vector<ObjectId> links;  // that move, the one in the joint first
};

struct JointMove {
  enum class End { Reached, Limit, Blocked } end = End::Reached;
  double value = 0;                    // where the joint is now
  std::vector<ObjectId> carried;       // loads that went along
  Support blocker = Support::floor();  // Blocked: what stopped it, and where
  Vec3 point = Vec3::Zero();
};

/// Moves a group, the links of the joint and what they carry, to a value, or until the first of
/// them meets something. @param stepped  called after each motion; may be empty.
JointMove drive_joint(MovingGroup& group, const JointToMove& joint, double to,
                      const std::function<void()>& stepped = {});

/// Moves a joint to a value. What lies on or in the links comes along; nothing passes through
/// anything but by the scene's pair rules, which must let links pass what they hang in. Objects
/// that do not come along stay, even if nothing holds them any more. The scene's contacts must be
/// those of its poses; they are not found anew.
JointMove move_joint(Scene& scene, const JointToMove& joint, double to, const OperationRun& run);

}  // namespace trivet
