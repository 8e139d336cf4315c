// DELETE: an object leaves the scene for good.
#pragma once

#include "ops/operations/move_options.h"

namespace trivet {

/// Refused: the object is locked. Objects left without support are named, and settle if asked to.
/// "delete"
struct DeleteOperation : MoveOptions {};

template <>
const OperationTable& table<DeleteOperation>();
OperationResult apply(Transaction& transaction, const DeleteOperation& o, OperationRun& run);

}  // namespace trivet
