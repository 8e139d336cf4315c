// One operation on its way: its options, its circumstances, and when it began.
#pragma once

#include <functional>
#include <optional>

#include "ops/base/interrupt.h"
#include "ops/base/options.h"
#include "ops/base/refusal.h"
#include "ops/base/stopwatch.h"

namespace trivet {

struct MovePlan;

struct OperationRun {
  SettleOptions options;
  Detector* detector = nullptr;  // null: BVHs
  Interrupt interrupt;
  Stopwatch stopwatch;
  /// Refusal of a plan, were it committed; checked at each place that a PUT tries. Empty: no
  /// checks.
  std::function<std::optional<Refusal>(const MovePlan&)> refuse_commit;
  /// First contacts by which the whole may come to rest: a bound of time that is the same on every
  /// machine.
  std::int64_t whole_queries = 300;
  /// The same at the places that a PUT tries, all together.
  std::int64_t trial_queries = 2400;
  bool is_trial = false;

  OperationRun(const SettleOptions& settle, const RunContext& context)
      : options(settle), detector(context.detector), interrupt(context) {}
};

}  // namespace trivet
