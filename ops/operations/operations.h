// Operations as data [Shinya 1995, 4.1]: layouts, journals and programs hold the same. perform.h
// performs them. Objects by name. Metres, degrees; world: z up.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "ops/operations/append.h"
#include "ops/operations/arrange.h"
#include "ops/operations/delete.h"
#include "ops/operations/drape.h"
#include "ops/operations/duplicate.h"
#include "ops/operations/fix.h"
#include "ops/operations/group.h"
#include "ops/operations/lock.h"
#include "ops/operations/material.h"
#include "ops/operations/move_joint.h"
#include "ops/operations/pick_up.h"
#include "ops/operations/push.h"
#include "ops/operations/put.h"
#include "ops/operations/rename.h"
#include "ops/operations/repair.h"
#include "ops/operations/rotate.h"
#include "ops/operations/stand.h"
#include "ops/operations/translate.h"
#include "ops/operations/turn.h"
#include "ops/operations/unplace.h"

namespace trivet {

using Operation =
    std::variant<PutOperation, PushOperation, TurnOperation, PickUpOperation, TranslateOperation,
                 RotateOperation, AppendOperation, DuplicateOperation, DeleteOperation,
                 LockOperation, FixOperation, MaterialOperation, GroupOperation, StandOperation,
                 UnplaceOperation, ArrangeOperation, RenameOperation, DrapeOperation,
                 RepairOperation, MoveJointOperation>;

/// Its name in layouts: "put", "push", "unlock", ...
const char* op_name(const Operation& operation);
const std::string& object_name(const Operation& operation);

/// Rows of its arguments; see table.h.
const OperationTable& table_of(const Operation& operation);
/// The operation as OperationTable takes it.
void* data_of(Operation& operation);
const void* data_of(const Operation& operation);
/// One of every kind, with its defaults, in the order of the variant.
const std::vector<Operation>& all_kinds();

}  // namespace trivet
