#include "ops/operations/lock.h"

#include "ops/operations/edit_parts.h"
#include "ops/operations/table.h"

namespace trivet {

template <>
const OperationTable& table<LockOperation>() {
  using P = LockOperation;
  static const OperationTable rows = make_table<P>({{"lock",
                                                     "Lock an object: no operation moves it",
                                                     {},
                                                     {},
                                                     [](const P& o) { return o.locked; },
                                                     [](P& o) { o.locked = true; }},
                                                    {"unlock",
                                                     "Unlock an object: it can be moved again",
                                                     {},
                                                     {},
                                                     [](const P& o) { return !o.locked; },
                                                     [](P& o) { o.locked = false; }}},
                                                   {});
  return rows;
}

OperationResult apply(Transaction& transaction, const LockOperation& o, OperationRun&) {
  transaction.edit(id_named(transaction, o.object),
                   [&](Object& object) { object.locked = o.locked; });
  return done_result();
}

}  // namespace trivet
