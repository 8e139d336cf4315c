#include "ops/operations/group.h"

#include "ops/operations/edit_parts.h"
#include "ops/operations/table.h"

namespace trivet {

template <>
const OperationTable& table<GroupOperation>() {
  using P = GroupOperation;
  using R = Row<P>;
  static const OperationTable rows =
      make_table<P>({{"group",
                      "Add an object to a group: what moves one of them moves all",
                      {},
                      {},
                      [](const P& o) { return !o.group.empty(); }},
                     {"ungroup",
                      "Take an object out of its group",
                      {},
                      {},
                      [](const P& o) { return o.group.empty(); }}},
                    {R("group", &P::group, kText, "Name of the group").in({0}).needed()});
  return rows;
}

OperationResult apply(Transaction& transaction, const GroupOperation& o, OperationRun&) {
  transaction.edit(id_named(transaction, o.object),
                   [&](Object& object) { object.group = o.group; });
  return done_result();
}

}  // namespace trivet
