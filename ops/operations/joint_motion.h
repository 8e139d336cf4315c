// One motion of several objects at once, as gravity and friction begin it.
#pragma once

#include <functional>

#include "core/scene/transaction.h"
#include "ops/operations/operation_run.h"
#include "ops/stability/free_bodies.h"

namespace trivet {

/// Lets bodies close gaps alone; the argument: those that moved.
using CloseGaps = std::function<void(Transaction&, const std::vector<ObjectId>&)>;

struct JointMotionResult {
  bool moved = false;            // else the scene is as it was
  std::int64_t num_queries = 0;  // of first contacts, without those of closing gaps
};

/// The first motion of these bodies with friction (coulomb.h), as exact motions: bodies of equal
/// twist go as one rigid group, those that recede first, each as far as it gets. What stops them
/// and was no contact joins the contacts, and the motion is found again. Of the attempts the one
/// that lowers the bodies by enough, or farthest, is taken; then gaps are closed. Taken back unless
/// the energy of all falls by enough.
/// @param part  bodies and contacts. @param ids  those of them that go; the others stand still.
/// @param max_queries  of first contacts; one attempt may go beyond.
JointMotionResult move_jointly(Transaction& transaction, const FreeBodies& part,
                               const std::vector<ObjectId>& ids, double clearance,
                               OperationRun& run, std::int64_t max_queries, const CloseGaps& close);

}  // namespace trivet
