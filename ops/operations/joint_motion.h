// One motion of several objects at once, as gravity and friction begin it.
#pragma once

#include <functional>

#include "core/scene/transaction.h"
#include "ops/operations/operation_run.h"
#include "ops/stability/free_bodies.h"

namespace trivet {

/// Lets bodies closes gaps alone; the argument: those that moved.
using CloseGaps = std::function<void(Transaction&, const std::vector<ObjectId>&)>;

/// The first motion of these bodies with friction (coulomb.h), as exact motions: bodies of equal
/// twist go as one rigid group, those that recede first, each as far as it gets; then gaps are
/// closed. Taken back unless the energy of all falls by enough.
/// @param part  bodies and contacts. @param ids  those of them that go; the others stand still.
/// @return whether the scene has changed.
bool move_jointly(Transaction& transaction, const FreeBodies& part,
                  const std::vector<ObjectId>& ids, double clearance, OperationRun& run,
                  const CloseGaps& close);

}  // namespace trivet
