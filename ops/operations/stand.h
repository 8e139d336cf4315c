// STAND: an object exactly at a pose.
#pragma once

#include "ops/operations/move_options.h"

namespace trivet {

/// An object exactly at a pose, tested like every end pose, but not settled: fixed objects come
/// into the scene so; free ones are Stable if at rest there, else Wedged or Unsupported; see
/// state_at(). An object that only touches others there is moved apart from them by a clearance or
/// two: result.moved. Objects that touched it before are rated again. Refused: it is locked, or
/// fixed and placed already; the exact test fails. "stand"
struct StandOperation : MoveOptions {
  Pose pose;
};

template <>
const OperationTable& table<StandOperation>();
OperationResult apply(Transaction& transaction, const StandOperation& o, OperationRun& run);

}  // namespace trivet
