// Where the hand is. Private.
#pragma once

#include <chrono>
#include <optional>

#include "core/base/types.h"

namespace trivet::edit {

struct DragGoal {
  using Clock = std::chrono::steady_clock;
  std::optional<Vec3> to;  // nothing: `by`
  double by = 0;
  Clock::time_point when;
};

}  // namespace trivet::edit
