// UNPLACE: an object leaves the scene, and can be put again.
#pragma once

#include "ops/operations/move_options.h"

namespace trivet {

/// Takes an object out of the scene; it stays loaded and can be put again. Refused as DELETE is.
/// "unplace"
struct UnplaceOperation : MoveOptions {};

template <>
const OperationTable& table<UnplaceOperation>();
OperationResult apply(Transaction& transaction, const UnplaceOperation& o, OperationRun& run);

}  // namespace trivet
