#include "ops/base/outcome.h"

#include <utility>

namespace trivet {

const char* to_string(OperationResult::End end) {
  switch (end) {
    case OperationResult::End::Done:
      return "done";
    case OperationResult::End::AtRest:
      return "at_rest";
    case OperationResult::End::Reached:
      return "reached";
    case OperationResult::End::Blocked:
      return "blocked";
    case OperationResult::End::Step:
      return "step";
    case OperationResult::End::Edge:
      return "edge";
    case OperationResult::End::Limit:
      return "limit";
  }
  return "?";
}

OperationResult refused(Refusal why) {
  OperationResult result;
  result.refuse(std::move(why));
  return result;
}

}  // namespace trivet
