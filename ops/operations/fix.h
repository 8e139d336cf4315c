// FIX: the object never moves and carries everything.
#pragma once

#include "ops/operations/move_options.h"

namespace trivet {

/// Never moves and carries everything, where it is or where it will be put first; or free again:
/// its loads stay on it, and if nothing holds it, it is named like objects that a move leaves.
/// Refused: to fix an object that interpenetrates another. "fix", "unfix"
struct FixOperation {
  std::string object;
  bool fixed = true;
};

template <>
const OperationTable& table<FixOperation>();
OperationResult apply(Transaction& transaction, const FixOperation& o, OperationRun& run);

}  // namespace trivet
