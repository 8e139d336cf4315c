#include "ops/operations/rename.h"

#include <memory>

#include "core/flex/flexible.h"
#include "ops/operations/edit_parts.h"
#include "ops/operations/table.h"

namespace trivet {
namespace {

// Cloths and cables know by its name what they lie on.
void rename_support(Transaction& transaction, ObjectId draped, const RenameOperation& o) {
  auto renamed = std::make_shared<Flexible>(*transaction.scene().at(draped).flexible);
  for (FlexSupport& support : renamed->supports)
    if (support.name == o.object) support.name = o.to;
  for (FlexTie& tie : renamed->ties)
    if (tie.name == o.object) tie.name = o.to;
  transaction.edit(draped, [&](Object& object) { object.flexible = std::move(renamed); });
}

}  // namespace

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
  // Draped objects keep names of their supports, and follow.
  transaction.edit(id_named(transaction, o.object), [&](Object& object) { object.name = o.to; });
  for (const ObjectId id : transaction.scene().ids())
    if (transaction.scene().at(id).flexible) rename_support(transaction, id, o);
  return done_result();
}

}  // namespace trivet
