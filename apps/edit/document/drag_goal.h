// Goal of a drag. Private.
#pragma once

#include <chrono>
#include <optional>

#include "core/base/types.h"

namespace trivet::edit {

struct DragGoal {
  using Clock = std::chrono::steady_clock;
  std::optional<Vec3> to;  // nullopt: use `by`
  double by = 0;
  Clock::time_point when;
};

}  // namespace trivet::edit
