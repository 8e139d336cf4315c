// RENAME: another name for an object.
#pragma once

#include "ops/operations/move_options.h"

namespace trivet {

/// Another name for an object: pose, contacts, state, group and id stay. Refused: the name is taken
/// or invalid. "rename"
struct RenameOperation {
  std::string object, to;
};

template <>
const OperationTable& table<RenameOperation>();
OperationResult apply(Transaction& transaction, const RenameOperation& o, OperationRun& run);

}  // namespace trivet
