// An arrangement as one operation among others.
#pragma once

#include "ops/arrange/arrange.h"

namespace trivet {

/// As arrange(). The result has the things in the order of their PUTs as `settled`; a conflict is
/// the refusal NoArrangement. The transaction is to be rolled back unless it is done.
OperationResult arrange_as_operation(Transaction& transaction, const Arrangement& arrangement,
                                     const SettleOptions& options, const RunContext& context);

}  // namespace trivet
