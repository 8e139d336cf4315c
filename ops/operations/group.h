// GROUP: objects of one group move as one.
#pragma once

#include "ops/operations/move_options.h"

namespace trivet {

/// Objects of one group move as one. "group", "ungroup"
struct GroupOperation {
  std::string object;
  std::string group;  // empty: taken out of its group
};

template <>
const OperationTable& table<GroupOperation>();
OperationResult apply(Transaction& transaction, const GroupOperation& o, OperationRun& run);

}  // namespace trivet
