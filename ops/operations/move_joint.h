// MOVE_JOINT: a drawer slides, a door turns, with all that lies in and on it.
#pragma once

#include "ops/operations/move_options.h"

namespace trivet {

/// Moves a link in its joint, up to a collision or the joint's limit. "move_joint"
struct MoveJointOperation : MoveOptions {
  enum class Limit { Lower, Upper };
  std::optional<double> to, by;  // metres or degrees; one of the three is given
  std::optional<Limit> until = {};
};

template <>
const OperationTable& table<MoveJointOperation>();
OperationResult apply(Transaction& transaction, const MoveJointOperation& o, OperationRun& run);

}  // namespace trivet
