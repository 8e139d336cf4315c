// Scenes at rest as a whole: what an operation unbalances gives way until all stands again.
//
//   judge the parts that the operation touched (ops/stability/part.h)
//     stand                  -> done
//     do not                 -> each object of them with its loads, as one rigid body, the lowest
//                               first, gives way until each holds alone; judge again
//     each holds alone, but not all together
//                            -> one joint motion (joint_motion.h); again from the start
//     nothing moves, or too often -> refused: Topples
#pragma once

#include "core/scene/transaction.h"
#include "ops/operations/move_plan.h"

namespace trivet {

/// Settles the parts of the scene that were touched within `transaction`; adds to result.gave_way,
/// and refuses when they do not come to rest: the transaction is then to be rolled back. Objects
/// held by a hand count as fixed. Every motion is exact and lowers the energy of all.
/// @param object  of the operation.
void settle_whole(Transaction& transaction, const Named& object, double clearance,
                  OperationRun& run, OperationResult& result);

/// commit(), and settle_whole() if the options ask for it.
OperationResult commit_at_rest(Transaction& transaction, MovePlan plan, OperationRun& run,
                               const Named& object);

}  // namespace trivet
