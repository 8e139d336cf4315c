// Parts of PUT: from a start that is given, and where there is room.
#pragma once

#include <functional>
#include <optional>
#include <span>

#include "ops/operations/move_plan.h"
#include "ops/operations/operations.h"

namespace trivet {

/// Refuses where a group has settled; may be empty.
using EndCondition = std::function<std::optional<Refusal>(const MovingGroup&)>;
/// Refusal of a plan, were it committed; empty: nothing is tried.
using TryCommit = std::function<std::optional<Refusal>(const MovePlan&)>;

/// plan() of a PUT that tries its commit at each place before it takes it.
MovePlan plan_put(const Scene& scene, ObjectId id, const PutOperation& o, OperationRun& run,
                  const TryCommit& try_commit);

/// A PUT from o.start.
MovePlan plan_put_from_start(const Scene& scene, ObjectId id, const PutOperation& o,
                             OperationRun& run, const EndCondition& refuse_end);

/// Does it ask for more than rest: for a region, a margin, or little friction?
bool is_judged_at_rest(const PlaceOptions& place);

/// A PUT that searches for its start: o.place is set.
MovePlan plan_put_where_free(const Scene& scene, ObjectId id, const PutOperation& o,
                             OperationRun& run, const TryCommit& try_commit);

/// Pose from which a PUT let its object go: if its place was searched for, above the end of the
/// first fall. @param steps  of `result`, or more. @return nothing of other operations, or where no
/// fall is.
std::optional<Pose> start_of_put(const Operation& operation, const OperationResult& result,
                                 std::span<const SettleStep> steps);

}  // namespace trivet
