// ROTATE [Shinya 1995, 4.1].
#pragma once

#include "ops/operations/move_options.h"

namespace trivet {

/// About an axis. Stops at collision. "rotate"
struct RotateOperation : JointMoveOptions {
  Vec3 axis = Vec3::UnitZ();        // of any length but zero
  double angle_deg = 0;             // right-handed
  std::optional<Vec3> centre = {};  // a point on the axis; nullopt: the centre of mass
  bool free = false;                // as for TranslateOperation
  bool settle = false;              // release it at the end
};

template <>
const OperationTable& table<RotateOperation>();
MovePlan plan(const Scene& scene, ObjectId id, const RotateOperation& o, OperationRun& run);

}  // namespace trivet
