#include "ops/operations/unplace.h"

#include "ops/operations/edit_parts.h"
#include "ops/operations/table.h"

namespace trivet {

template <>
const OperationTable& table<UnplaceOperation>() {
  using P = UnplaceOperation;
  static const OperationTable rows = make_table<P>(
      {{"unplace", "Take an object out of the scene; it stays loaded and can be put again"}}, {});
  return rows;
}

OperationResult apply(Transaction& transaction, const UnplaceOperation& o, OperationRun& run) {
  const ObjectId id = id_named(transaction, o.object);
  const Object& here = transaction.scene().at(id);
  if (!here.placed && !here.locked)
    return refused({Refusal::Cause::NotPlaced, {named(transaction.scene(), Support(id))}});
  // Contacts of the partners go first: they name this object.
  return take_away(transaction, id, o, "unplace", run, [&] {
    transaction.clear_contacts(id);
    transaction.edit(id, [](Object& object) {
      object.placed = false;
      object.pose = {};
      object.state = ObjectState::Unplaced;
      object.stability_margin = object.least_friction = 0;
    });
  });
}

}  // namespace trivet
