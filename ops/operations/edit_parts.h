// Parts of the operations that edit the list of objects, or objects that do not move by motions.
// Each gives a result that is refused or done; when refused, the transaction is to be rolled back.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/scene/transaction.h"
#include "ops/operations/commit.h"
#include "ops/operations/operation_run.h"
#include "ops/settle/rest.h"

namespace trivet {

/// A name that is invalid or taken.
std::optional<Refusal> refuse_name(const Scene& scene, const std::string& name);
/// A pose that cannot be committed as it is.
std::optional<Refusal> refuse_stand(const Scene& scene, ObjectId id, const Pose& pose,
                                    const SettleOptions& options);
Refusal locked_refusal(const Scene& scene, ObjectId id);

/// An object that hangs in a joint, or in which others hang, stays in the scene as it is.
std::optional<Refusal> refuse_in_joint(const Scene& scene, ObjectId id);

OperationResult done_result();
ObjectId id_named(const Transaction& transaction, const std::string& name);

/// The object exactly at a pose: Fixed, or Stable if it is at rest there, else Wedged.
void stand_at(Transaction& transaction, ObjectId id, const Pose& pose, const RestRules& rules);

/// Rates the neighbours that an object has left, and lets them settle if asked to.
void leave_neighbours(Transaction& transaction, const std::vector<ObjectId>& dependents,
                      const MoveOptions& move, const char* op, const Named& object,
                      double clearance, OperationRun& run, OperationResult& result);

/// Takes an object out of the scene, by `remove()`, and sees to those that touched it.
template <class Remove>
OperationResult take_away(Transaction& transaction, ObjectId id, const MoveOptions& move,
                          const char* op, OperationRun& run, const Remove& remove) {
  const Scene& scene = transaction.scene();
  if (scene.at(id).locked) return refused(locked_refusal(scene, id));
  if (auto why = refuse_in_joint(scene, id)) return refused(std::move(*why));
  const double clearance = clearance_near(scene, run.options, scene.world_box(id));
  const Named name = named(scene, Support(id));
  const std::vector<ObjectId> dependents = dependents_of(scene, id);
  remove();
  OperationResult result = done_result();
  leave_neighbours(transaction, dependents, move, op, name, clearance, run, result);
  return result;
}

}  // namespace trivet
