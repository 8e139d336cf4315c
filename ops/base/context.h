// Circumstances of a run, on which no result depends: the detector, and how to stop it.
#pragma once

#include <atomic>

namespace trivet {

class Detector;

struct RunContext {
  /// Answers first-contact queries; null: BVHs. Not owned; results do not depend on it.
  Detector* detector = nullptr;
  /// Set by another thread to stop the operation; null: never. Not owned. See interrupt.h.
  const std::atomic<bool>* cancel = nullptr;
  /// Seconds that an operation may take, checked between motions; 0: unlimited.
  double time_budget_s = 0;
};

}  // namespace trivet
