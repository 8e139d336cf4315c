#include "ops/operations/duplicate.h"

#include "ops/operations/edit_parts.h"
#include "ops/operations/table.h"

namespace trivet {

template <>
const OperationTable& table<DuplicateOperation>() {
  using P = DuplicateOperation;
  using R = Row<P>;
  static const OperationTable rows = make_table<P>(
      {{"duplicate", "Make a new object of the same model, out of the scene until it is put"}},
      {R("as", &P::as, kNewName, "Name of the new object; no other has it").needed()});
  return rows;
}

OperationResult apply(Transaction& transaction, const DuplicateOperation& o, OperationRun&) {
  if (auto why = refuse_name(transaction.scene(), o.as)) return refused(std::move(*why));
  const Object& original = transaction.scene().at(id_named(transaction, o.object));
  Object object;
  object.name = o.as;
  object.model = original.model;
  object.shape = original.shape;
  object.up = original.up;
  object.scale = original.scale;
  object.material = original.material;
  object.given_mass = original.given_mass;
  transaction.add(std::move(object));
  return done_result();
}

}  // namespace trivet
