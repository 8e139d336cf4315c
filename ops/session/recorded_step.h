// Steps whose outcome is known: nothing is computed, objects get their recorded poses.
#pragma once

#include <vector>

#include "core/scene/transaction.h"
#include "ops/base/options.h"
#include "ops/operations/operations.h"
#include "ops/session/recorded.h"

namespace trivet {

/// Repeats what operations do to the list of objects (append, rename, fix, ...), then the poses as
/// they are, then contacts and states of what changed. An object that interpenetrates others there
/// is ObjectState::Invalid, one that is not at rest ObjectState::Held.
/// @param operations  their models loaded; those that were refused at the time are refused again.
void repeat_recorded(Transaction& transaction, const std::vector<Operation>& operations,
                     const RecordedPoses& poses, const SettleOptions& settle);

}  // namespace trivet
