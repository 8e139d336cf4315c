// Brings a moved group into the scene, with contacts, states and what becomes of its surroundings.
#pragma once

#include "ops/interrupt.h"
#include "ops/move/moving_group.h"

namespace trivet {

/// Verifies every member against everything outside, in double and in the exported float32 (and
/// the members among each other in float32), then gives all their poses. Contacts inside the group
/// move along; those with the surroundings are found anew; whatever touched the group before or
/// does so now is rated again, and free objects that nothing holds any more are named in
/// result.unsupported.
/// @param otherwise  the object's state when it is not at rest. @param settled  whether that is
///   known to be its state.
/// @return why not; empty: it is done. Nothing is changed unless it is done.
std::string commit_group(Scene& scene, const MovingGroup& group, ObjectState otherwise,
                         bool settled, OperationResult& result);

/// The same without the test: members that interpenetrate others become ObjectState::Invalid, and
/// what they interpenetrate is named in result.interpenetrates.
void commit_freely(Scene& scene, const MovingGroup& group, OperationResult& result);

/// Rates an object again that touched something that is gone; when it is not at rest any more, it
/// becomes ObjectState::Unsupported and is named in result.unsupported.
void rate_left_alone(Scene& scene, ObjectId id, double clearance, OperationResult& result);

/// Lets the objects of result.unsupported settle, the lowest first, and those that this leaves
/// without support; result.settled says which. What cannot come to rest stays where it is, and in
/// result.unsupported.
/// @param only  these; nothing: all.
void settle_unsupported(Scene& scene, const SettleOptions& options, double clearance,
                        const std::optional<std::vector<ObjectId>>& only, Interrupt& interrupt,
                        OperationResult& result);

}  // namespace trivet
