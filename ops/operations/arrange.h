// ARRANGE: places for several objects at once. The language of problems and their solver are in
// layers above this one: ops/files/arrange and ops/arrange.
#pragma once

#include <memory>
#include <string>

#include "ops/base/context.h"
#include "ops/base/options.h"
#include "ops/base/outcome.h"
#include "ops/operations/move_options.h"

namespace trivet {

class ArrangeProblem {
 public:
  virtual ~ArrangeProblem() = default;

  /// Places for all things, or a refusal; then the transaction is to be rolled back.
  virtual OperationResult solve(Transaction& transaction, const SettleOptions& options,
                                const RunContext& context) const = 0;
  /// As layouts have it: a JSON object, but for "op".
  virtual std::string json() const = 0;
};

/// Finds places for several objects at once, by relations between them. "arrange"
struct ArrangeOperation {
  std::string object;  // the first that the problem names, or a pattern of names: for messages
  std::shared_ptr<const ArrangeProblem> problem;  // never null
};

template <>
const OperationTable& table<ArrangeOperation>();

}  // namespace trivet
