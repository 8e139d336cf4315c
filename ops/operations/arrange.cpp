#include "ops/operations/arrange.h"

#include "ops/operations/table.h"

namespace trivet {
namespace {

std::optional<InvalidArgument> refuse_nothing(const ArrangeOperation& o) {
  if (o.problem) return std::nullopt;
  return InvalidArgument{"problem", "nothing", "a problem of arranging"};
}

}  // namespace

// The keys of a problem are those of the schema of arrangements.
template <>
const OperationTable& table<ArrangeOperation>() {
  static const OperationTable rows = make_table<ArrangeOperation>(
      {{"arrange",
        "Places for several objects at once, by relations between them, or a refusal that "
        "says what cannot be met together"}},
      {}, refuse_nothing);
  return rows;
}

}  // namespace trivet
