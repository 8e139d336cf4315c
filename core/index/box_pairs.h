// Which boxes of two sets overlap.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/base/types.h"

namespace trivet {

/// Indices of a box of each set.
struct BoxPair {
  Index a, b;
};

/// All pairs of overlapping boxes, closed, in any order, by Embree's collision of two scenes
/// (rtcCollide); and perhaps a few that miss each other by less than float32 can tell within the
/// extent of all of b. No box may be empty; infinite ones are accepted in a.
/// @param most  stands for more pairs than the caller can use.
/// @return nothing if a sample shows that there are many more.
/// @throws Error (Environment) when Embree lacks memory. Cost O(n log n + pairs), in one thread.
/// Re-entrant.
std::optional<std::vector<BoxPair>> overlapping_boxes(std::span<const Aabb> a,
                                                      std::span<const Aabb> b, std::size_t most);

}  // namespace trivet
