// Door to all operations: validate, plan, verify, commit.
//
//   validate()  arguments alone (validate.h)
//   plan        where things would go, on copies; or a refusal (move_plan.h)
//   verify      exact test of the poses, in double and in the exported float32
//   commit      poses, contacts and states in one transaction (commit.h)
//
// The scene changes by commits only, and is as it was whenever something is refused or thrown.
#pragma once

#include "ops/base/context.h"
#include "ops/base/options.h"
#include "ops/base/outcome.h"
#include "ops/operations/operations.h"

namespace trivet {

class Transaction;

/// The whole operation or nothing: when refused, the scene is as it was. Operations that move
/// objects carry their loads along.
/// @throws std::bad_alloc, and Error as models do; the scene is as it was.
OperationResult perform(Scene& scene, const Operation& operation, const SettleOptions& options = {},
                        const RunContext& context = {});
/// The same as a part of something larger.
OperationResult perform(Transaction& transaction, const Operation& operation,
                        const SettleOptions& options = {}, const RunContext& context = {});

/// PUT of an object from a start pose: down along gravity to the first contact, then settle
/// [Shinya 1995, 4.1]. As perform() of a PutOperation.
/// Refused: the start pose interpenetrates another object or the floor; nothing is below it; it
/// wedges; a limit is reached; the exact test of the end pose fails.
OperationResult put(Scene& scene, ObjectId object, const Pose& start,
                    const SettleOptions& options = {}, const RunContext& context = {});

/// Places an object exactly at `pose`, as layouts do: tested like every end pose, but not settled.
/// As perform() of a StandOperation.
OperationResult stand(Scene& scene, ObjectId object, const Pose& pose,
                      const SettleOptions& options = {});

}  // namespace trivet
