// PUT: from a start pose down along gravity to the first contact, then settle [Shinya 1995, 4.1].
#pragma once

#include <functional>
#include <optional>
#include <span>

#include "ops/operations/move_plan.h"

namespace trivet {

/// Refuses where a group has settled; may be empty.
using EndCondition = std::function<std::optional<Refusal>(const MovingGroup&)>;

/// A PUT from o.start.
MovePlan plan_put_from_start(const Scene& scene, ObjectId id, const PutOperation& o,
                             OperationRun& run, const EndCondition& refuse_end);

/// Does it ask for more than rest: for a region, a margin, or little friction?
bool is_judged_at_rest(const PlaceOptions& place);

/// A PUT that searches for its start: o.place is set.
MovePlan plan_put_where_free(const Scene& scene, ObjectId id, const PutOperation& o,
                             OperationRun& run);

/// Pose from which a PUT let its object go: if its place was searched for, above the end of the
/// first fall. @param steps  of `result`, or more. @return nothing of other operations, or where no
/// fall is.
std::optional<Pose> start_of_put(const Operation& operation, const OperationResult& result,
                                 std::span<const SettleStep> steps);

}  // namespace trivet
