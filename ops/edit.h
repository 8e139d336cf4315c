// What is done to the list of objects rather than to their poses: append, duplicate, delete, lock,
// fix, group.
#pragma once

#include "ops/layout/load.h"
#include "ops/operation.h"

namespace trivet {

/// A new object, out of the scene until it is put. Refused: the name is taken or is none; the model
/// was not loaded (load_model()).
OperationResult append(Scene& scene, const AppendOperation& operation);

/// A new object of the same model, scale and axis, free, out of the scene until it is put.
OperationResult duplicate(Scene& scene, const DuplicateOperation& operation);

/// What the object leaves without support is named in OperationResult::unsupported, and settles if
/// asked to. Refused: it is locked.
OperationResult remove(Scene& scene, const DeleteOperation& operation,
                       const SettleOptions& options);

/// Locked objects are moved by no operation, neither by themselves nor with what carries them.
OperationResult lock(Scene& scene, const LockOperation& operation);

/// A free object becomes fixed where it is (or where it will be put first), or a fixed one free:
/// what it carries stays on it, and when nothing holds it that is said as for what a move leaves.
/// Refused: to fix what interpenetrates.
OperationResult fix(Scene& scene, const FixOperation& operation, const SettleOptions& options);

/// Objects of one group move as one.
OperationResult group(Scene& scene, const GroupOperation& operation);

/// Fills operation.model_data and operation.shape: from an object of the scene that has the same
/// model, else from `models`. @throws what `models` throws.
void load_model(const Scene& scene, const ModelSource& models, AppendOperation& operation);

}  // namespace trivet
