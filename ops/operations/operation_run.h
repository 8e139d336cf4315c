// One operation on its way: its options, its circumstances, and when it began.
#pragma once

#include "ops/base/interrupt.h"
#include "ops/base/options.h"
#include "ops/base/stopwatch.h"

namespace trivet {

struct OperationRun {
  SettleOptions options;
  Detector* detector = nullptr;  // null: BVHs
  Interrupt interrupt;
  Stopwatch stopwatch;

  OperationRun(const SettleOptions& settle, const RunContext& context)
      : options(settle), detector(context.detector), interrupt(context) {}
};

}  // namespace trivet
