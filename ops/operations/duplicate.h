// DUPLICATE: another object of the same model.
#pragma once

#include "ops/operations/move_options.h"

namespace trivet {

/// A new object of the same model, scale, axis and material, free, not placed until it is put.
/// "duplicate"
struct DuplicateOperation {
  std::string object, as;
};

template <>
const OperationTable& table<DuplicateOperation>();
OperationResult apply(Transaction& transaction, const DuplicateOperation& o, OperationRun& run);

}  // namespace trivet
