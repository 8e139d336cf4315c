#include "ops/operations/rename.h"

#include "ops/operations/edit_parts.h"
#include "ops/operations/table.h"

namespace trivet {

template <>
const OperationTable& table<RenameOperation>() {
  using P = RenameOperation;
  using R = Row<P>;
  static const OperationTable rows = make_table<P>(
      {{"rename", "Give an object another name; nothing moves. From here on it is called by that"}},
      {R("to", &P::to, kNewName, "The new name; no other object has it").needed()});
  return rows;
}

OperationResult apply(Transaction& transaction, const RenameOperation& o, OperationRun&) {
  if (auto why = refuse_name(transaction.scene(), o.to)) return refused(std::move(*why));
  transaction.edit(id_named(transaction, o.object), [&](Object& object) { object.name = o.to; });
  return done_result();
}

}  // namespace trivet
