// TRANSLATE [Shinya 1995, 4.1].
#pragma once

#include "ops/operations/move_options.h"

namespace trivet {

/// Along a straight path, or several. Stops at collision. "translate"
struct TranslateOperation : JointMoveOptions {
  Vec3 by = Vec3::Zero();      // metres
  bool free = false;           // as in a modeller: through everything; see ObjectState::Invalid
  bool settle = false;         // release it at the end
  std::vector<Vec3> via = {};  // waypoints, as `by`
};

template <>
const OperationTable& table<TranslateOperation>();
MovePlan plan(const Scene& scene, ObjectId id, const TranslateOperation& o, OperationRun& run);

}  // namespace trivet
