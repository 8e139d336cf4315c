// Commits after which the scene is at rest as a whole, or that are refused.
#pragma once

#include <cstdint>
#include <optional>

#include "ops/operations/whole.h"

namespace trivet {

/// commit(), and settle_whole() if the options ask for it.
OperationResult commit_at_rest(Transaction& transaction, MovePlan plan, OperationRun& run,
                               const Named& object, Budget budget = {});

/// Verdict of commit_at_rest() on a plan, and the cost of the trial.
struct CommitVerdict {
  std::optional<Refusal> refusal;  // nullopt: the plan can be committed
  std::int64_t first_contacts = 0;
};

/// Commits a plan within `trial`, which the caller then rolls back.
CommitVerdict try_commit(Transaction& trial, MovePlan plan, OperationRun& run, const Named& object,
                         Budget budget);

}  // namespace trivet
