#include "ops/operations/delete.h"

#include "ops/operations/edit_parts.h"
#include "ops/operations/table.h"

namespace trivet {

template <>
const OperationTable& table<DeleteOperation>() {
  using P = DeleteOperation;
  static const OperationTable rows = make_table<P>({{"delete", "Delete an object"}}, {});
  return rows;
}

OperationResult apply(Transaction& transaction, const DeleteOperation& o, OperationRun& run) {
  const ObjectId id = id_named(transaction, o.object);
  return take_away(transaction, id, o, "delete", run, [&] { transaction.remove(id); });
}

}  // namespace trivet
