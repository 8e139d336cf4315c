// Problems of arranging as operations carry them. Their language and their solver are in layers
// above this one: ops/files/arrange and ops/arrange.
#pragma once

#include <string>

#include "ops/base/context.h"
#include "ops/base/options.h"
#include "ops/base/outcome.h"

namespace trivet {

class Transaction;

class ArrangeProblem {
 public:
  virtual ~ArrangeProblem() = default;

  /// Places for all things, or a refusal; then the transaction is to be rolled back.
  virtual OperationResult solve(Transaction& transaction, const SettleOptions& options,
                                const RunContext& context) const = 0;
  /// As layouts have it: a JSON object, but for "op".
  virtual std::string json() const = 0;
};

}  // namespace trivet
