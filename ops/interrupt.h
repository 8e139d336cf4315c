// Stops an operation from outside: another thread cancels it, or its time is up.
//
// Every operation makes one Interrupt of its options when it begins, asks it between motions, and
// gives it to settle() in SettleProblem::interrupt. When it says stop, the operation is refused by
// refuse() and leaves the scene as it was.
#pragma once

#include <atomic>
#include <chrono>
#include <optional>

#include "ops/put.h"

namespace trivet {

class Interrupt {
 public:
  enum class Reason { Cancelled, OutOfTime };

  /// The time of options.time_budget_s begins now.
  explicit Interrupt(const SettleOptions& options);

  /// Why to stop; nothing: go on. Once it says stop it stays with that. Costs a look at the clock.
  std::optional<Reason> reason();

  /// What a stopped operation says: "put of \"cup\" was cancelled", "... did not end within 0.5 s".
  /// @param what  "put of \"cup\"".
  /// Only after reason() said to stop.
  void refuse(const std::string& what, OperationResult& result) const;

 private:
  using Clock = std::chrono::steady_clock;
  const std::atomic<bool>* m_cancel;
  double m_budget_s;
  std::optional<Clock::time_point> m_deadline;
  std::optional<Reason> m_reason;
};

}  // namespace trivet
