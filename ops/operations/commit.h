// The only writer of poses: brings a plan into the scene, with contacts, states and the
// consequences for the neighbours.
#pragma once

#include "core/scene/transaction.h"
#include "ops/operations/move_plan.h"
#include "ops/settle/rest.h"

namespace trivet {

/// Commits a verified plan: poses; contacts, which are found anew; states and margins of what
/// touched the group before or does so now. Free objects that nothing holds any more are named in
/// result.unsupported, and released if the plan says so.
/// Members of a free move that interpenetrate others become ObjectState::Invalid.
/// @return plan.result, completed; refused when it is interrupted: the transaction is then to be
///   rolled back.
OperationResult commit(Transaction& transaction, MovePlan plan, OperationRun& run);

/// Gives one object a pose and a state, links it with its contacts, and finds its margin.
void commit_object(Transaction& transaction, ObjectId id, const Pose& pose, ObjectState state,
                   const std::vector<ContactsWith>& contacts, const RestRules& rules);

/// Ratings of those of these that are placed, by links, poses and states alone, and who carries
/// them (carriers.h): what an operation touched has then the rating that it gets where the scene is
/// read from a file.
void rate_again(Transaction& transaction, std::vector<ObjectId> ids, const RestRules& rules);

/// Judges an object again when something that it touched is gone; if it is not at rest any more, it
/// becomes ObjectState::Unsupported and is named in result.unsupported.
void rate_left_alone(Transaction& transaction, ObjectId id, const RestRules& rules,
                     OperationResult& result);

/// Objects to rate again when this one leaves: its contacts, those that may lean on it, and those
/// that interpenetrate something.
std::vector<ObjectId> dependents_of(const Scene& scene, ObjectId id);

/// Releases the objects of result.unsupported, the lowest first, and those that this leaves without
/// support; result.settled says which. An object that cannot come to rest stays where it is, and in
/// result.unsupported.
/// @param only  these; empty: all.
void settle_unsupported(Transaction& transaction, OperationRun& run, double clearance,
                        const std::vector<ObjectId>& only, OperationResult& result);

/// Unless it is there.
void add_name(std::vector<std::string>& names, const std::string& name);

}  // namespace trivet
