// Which boxes of two sets overlap.
#pragma once

#include <cstddef>
#include <functional>
#include <span>

#include "core/base/types.h"

namespace trivet {

/// Indices of a box of each set.
struct BoxPair {
  Index a, b;
};

/// Visits all pairs of overlapping boxes, closed, in any order, by Embree's collision of two scenes
/// (rtcCollide), from within its callback; and perhaps a few that miss each other by less than
/// float32 can tell within the extent of all of b. No box may be empty; infinite ones are accepted
/// in a.
/// @param most  stands for more pairs than the caller can use.
/// @param visit  throws nothing; called by one thread at a time.
/// @return false, and none was visited, if a sample shows that there are many more.
/// @throws Error (Environment) when Embree lacks memory. Cost O(n log n + pairs), in one thread.
/// Re-entrant.
bool visit_overlapping_boxes(std::span<const Aabb> a, std::span<const Aabb> b, std::size_t most,
                             const std::function<void(const BoxPair&)>& visit);

}  // namespace trivet
