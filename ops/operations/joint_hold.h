// Joints that friction alone holds.
#pragma once

#include "core/scene/transaction.h"
#include "ops/base/options.h"
#include "ops/base/outcome.h"

namespace trivet {

/// True for a link that its weight, and that of what lies in and on it, slides or turns: its joint
/// is not locked, and neither friction nor a limit holds it.
bool gives_way_in_joint(const Scene& scene, ObjectId link);

/// Refuses what was done if a link that was touched, or bears something that was, gives way now.
void refuse_links_that_give_way(const Transaction& transaction, const Named& object,
                                OperationResult& result);

}  // namespace trivet
