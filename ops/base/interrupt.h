// Stops an operation from outside: another thread cancels it, or its time is up.
//
// Every operation makes one Interrupt of its context when it begins, and checks it between motions.
// After a stop, the operation ends by refuse() and leaves the scene as it was.
#pragma once

#include <chrono>
#include <functional>
#include <optional>

#include "ops/base/context.h"
#include "ops/base/outcome.h"

namespace trivet {

class Interrupt {
 public:
  enum class Reason { Cancelled, OutOfTime };

  /// The time of context.time_budget_s begins now.
  explicit Interrupt(const RunContext& context);

  /// Stops, as cancelled, when this becomes true, too. Not owned.
  void stop_on(const std::atomic<bool>& unneeded) { m_unneeded = &unneeded; }

  /// Calls `call` once, in the first reason() from that time on that does not say stop.
  /// @param call  may be empty: none. Copies made before would call it, too.
  void call_after(std::chrono::milliseconds time, std::function<void()> call);

  /// Why to stop; nullopt: go on. Once it says stop it stays with that. Costs a look at the clock.
  std::optional<Reason> reason();

  /// The result of a stopped operation: "put of \"cup\" was cancelled", "... did not end within
  /// 0.5 s". Only after reason() said to stop.
  /// @param op  its name. @param object  of the operation.
  void refuse(const std::string& op, const Named& object, OperationResult& result) const;

 private:
  using Clock = std::chrono::steady_clock;
  const std::atomic<bool>* m_cancel;
  const std::atomic<bool>* m_unneeded = nullptr;
  double m_budget_s;
  std::optional<Clock::time_point> m_deadline;
  std::optional<Reason> m_reason;
  Clock::time_point m_call_time;
  std::function<void()> m_call;
};

}  // namespace trivet
