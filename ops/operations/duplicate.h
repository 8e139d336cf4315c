// DUPLICATE: another object of the same model.
#pragma once

#include "ops/operations/move_options.h"

namespace trivet {

/// A new object of the same model, scale, axis, material and mass, free, not placed until it is
/// put. What hangs in the other by joints is not copied, nor the joint in which it hangs.
/// "duplicate"
struct DuplicateOperation {
  std::string object, as;
};

template <>
const OperationTable& table<DuplicateOperation>();
OperationResult apply(Transaction& transaction, const DuplicateOperation& o, OperationRun& run);

}  // namespace trivet
