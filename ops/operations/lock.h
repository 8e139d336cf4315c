// LOCK: no operation moves the object.
#pragma once

#include "ops/operations/move_options.h"

namespace trivet {

/// No operation moves it, neither by itself nor with what carries it. "lock", "unlock"
struct LockOperation {
  std::string object;
  bool locked = true;
};

template <>
const OperationTable& table<LockOperation>();
OperationResult apply(Transaction& transaction, const LockOperation& o, OperationRun& run);

}  // namespace trivet
