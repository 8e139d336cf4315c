// MEND and SETTLE: a scene that floats and interpenetrates comes to rest. Done by ops/mend, a layer
// above this one.
#pragma once

#include <string>
#include <vector>

#include "ops/base/context.h"
#include "ops/base/options.h"
#include "ops/operations/move_options.h"

namespace trivet {

/// Brings all free objects that are not at rest, or pass through others, to rest: near what their
/// poses meant ("mend"), or straight down from just above where they are ("settle"). What finds no
/// place stays, and is named in OperationResult::repaired. RunContext::time_budget_s is for all;
/// objects that are left over then stay, too.
struct RepairOperation {
  std::string object;  // empty: it is of the scene
  bool mends = false;
  double tolerance = 0;           // mend: metres by which poses may be off; 0: found from them
  double lift = 0.2;              // settle: metres up from its place to where one is let go
  std::vector<std::string> only;  // objects that may move; empty: all that are free
};

template <>
const OperationTable& table<RepairOperation>();

/// Refused: a name that the scene does not have; it was cancelled.
OperationResult repair(Transaction& transaction, const RepairOperation& o,
                       const SettleOptions& settle, const RunContext& context);

}  // namespace trivet
