// PICK-UP [Shinya 1995, 4.1].
#pragma once

#include "ops/operations/move_options.h"

namespace trivet {

/// Away along the contact normal; deletes the links; the object is held then. "pick_up"
struct PickUpOperation : JointMoveOptions {
  double distance = 0;              // metres
  std::optional<std::string> with;  // partner of the contact, "floor" too; nullopt: all supports
};

template <>
const OperationTable& table<PickUpOperation>();
MovePlan plan(const Scene& scene, ObjectId id, const PickUpOperation& o, OperationRun& run);

}  // namespace trivet
