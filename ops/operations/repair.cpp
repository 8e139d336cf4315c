#include "ops/operations/repair.h"

#include "ops/operations/table.h"

namespace trivet {
namespace {

constexpr Accepts kToOneMetre{Sort::Number, 0, 1, "metres"};
constexpr unsigned kMend = 0, kSettle = 1;

OperationTable repair_table() {
  using P = RepairOperation;
  OperationTable out = make_table<P>(
      {{"mend",
        "Find the nearest scene in which nothing interpenetrates, everything rests, and what stood "
        "on what still does",
        {},
        {},
        [](const P& o) { return o.mends; },
        [](P& o) { o.mends = true; }},
       {"settle",
        "Let what floats or is sunk come to rest; what is at rest stays, to the bit",
        {},
        {},
        [](const P& o) { return !o.mends; },
        [](P& o) { o.mends = false; }}},
      {Row<P>("tolerance", &P::tolerance, kToOneMetre,
              "Largest error of the poses; 0: found from the poses")
           .in({kMend}),
       Row<P>("lift", &P::lift, kToOneMetre, "Largest height to lift an object before it is let go")
           .in({kSettle}),
       Row<P>("only", &P::only, kObjectName, "Objects that may move; none: all that are free")});
  out.fields.erase(out.fields.begin());  // it names no object
  return out;
}

}  // namespace

template <>
const OperationTable& table<RepairOperation>() {
  static const OperationTable rows = repair_table();
  return rows;
}

}  // namespace trivet
