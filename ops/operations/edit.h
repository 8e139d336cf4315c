// Edits of the scene's list of objects, and of objects that do not move by motions: append,
// duplicate, rename, delete, lock, fix, material, group, stand, unplace.
#pragma once

#include "core/scene/transaction.h"
#include "ops/operations/operation_run.h"
#include "ops/operations/operations.h"

namespace trivet {

/// Each gives a result that is refused or done; when refused, the transaction is to be rolled back.

/// A new object, not placed until it is put. Refused: the name is taken or invalid; the model was
/// not loaded.
OperationResult apply(Transaction& transaction, const AppendOperation& o, OperationRun& run);

/// A new object of the same model, scale, axis and material, free, not placed until it is put.
OperationResult apply(Transaction& transaction, const DuplicateOperation& o, OperationRun& run);

/// Only the name: pose, contacts, state, group and id stay. Refused: the name is taken or invalid.
OperationResult apply(Transaction& transaction, const RenameOperation& o, OperationRun& run);

/// Refused: the object is locked. Objects left without support are named, and settle if asked to.
OperationResult apply(Transaction& transaction, const DeleteOperation& o, OperationRun& run);
OperationResult apply(Transaction& transaction, const UnplaceOperation& o, OperationRun& run);

/// Locked objects are moved by no operation, neither by themselves nor with what carries them.
OperationResult apply(Transaction& transaction, const LockOperation& o, OperationRun& run);

/// A free object becomes fixed where it is (or where it will be put first), or a fixed one free:
/// its loads stay on it, and if nothing holds it, it is named like objects that a move leaves.
/// Refused: to fix an object that interpenetrates another.
OperationResult apply(Transaction& transaction, const FixOperation& o, OperationRun& run);

/// Only what the object is made of: nothing moves, and no state changes.
OperationResult apply(Transaction& transaction, const MaterialOperation& o, OperationRun& run);

/// Objects of one group move as one.
OperationResult apply(Transaction& transaction, const GroupOperation& o, OperationRun& run);

/// Tested like every end pose, but not settled: fixed objects become ObjectState::Fixed; free ones
/// are Stable if at rest there, else Wedged or Unsupported; see state_at(). What only touches
/// others there is moved apart from them by a clearance or two: result.moved. Objects that touched
/// it before are rated again. Refused: it is locked, or fixed and placed already; the exact test
/// fails.
OperationResult apply(Transaction& transaction, const StandOperation& o, OperationRun& run);

}  // namespace trivet
