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

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/scene/transaction.h"
#include "ops/operations/move_plan.h"

namespace trivet {

/// Work by which the whole may come to rest: a bound of time that is the same on every machine.
struct Budget {
  std::int64_t first_contacts = 300;
  /// Objects that may be about to move at a time: where more are, it is refused at once, as their
  /// joint motion costs more than another start. 0: all have to stand as they are.
  size_t most_movers = std::numeric_limits<size_t>::max();
  /// First contacts of rounds in which all together sink by much, that do not count: only creeping
  /// takes long and ends nowhere.
  std::int64_t while_sinking = 0;

  /// The smaller of both.
  Budget within(const Budget& other) const {
    return {std::min(first_contacts, other.first_contacts),
            std::min(most_movers, other.most_movers), std::min(while_sinking, other.while_sinking)};
  }
};

/// Purpose of settling the whole: to stay, or to be taken back, where ratings and names of who gave
/// way are of no use.
enum class Purpose { Commit, Trial };

/// Settles the parts of the scene that were touched within `transaction`; adds to result.gave_way,
/// and refuses when they do not come to rest: the transaction is then to be rolled back. Objects
/// held by a hand count as fixed. Every motion is exact and lowers the energy of all.
/// @param object  of the operation. @param in_hand  moved by a hand, which does not let go of them
/// where they would not rest.
/// @return what is left of the budget.
Budget settle_whole(Transaction& transaction, const Named& object, double clearance,
                    OperationRun& run, OperationResult& result, Budget budget = {},
                    Purpose purpose = Purpose::Commit, std::vector<ObjectId> in_hand = {});

}  // namespace trivet
