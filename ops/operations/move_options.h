// Common parts of operations: structs, and what each of them declares for perform().
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/motion/pose.h"
#include "core/scene/support.h"

namespace trivet {

class Scene;
class Transaction;
struct MovePlan;         // move_plan.h
struct OperationResult;  // ops/base/outcome.h
struct OperationRun;     // operation_run.h
struct OperationTable;   // table.h

/// Rows of an operation's arguments; see table.h.
template <class Operation>
const OperationTable& table();

/// Common part of all operations that move an object. The object carries its loads.
struct MoveOptions {
  std::string object;
  /// Release objects that the move leaves without support, in order, so that they settle. Otherwise
  /// they are named in OperationResult::unsupported and stay, ObjectState::Unsupported.
  bool settle_left = false;
};

/// Common part of the operations that move objects of the scene.
struct JointMoveOptions : MoveOptions {
  std::vector<std::string> together = {};  // move along like group members; each is released
};

}  // namespace trivet
