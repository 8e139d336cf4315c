// Exact test of whether an open surface passes through itself.
#pragma once

#include <optional>

#include "core/flex/body.h"

namespace trivet::flex {

struct FacePair {
  int a, b;
};

/// The first pair of faces, by a, then b, that have more in common than the corners and edges that
/// they share: they cross, touch, overlap or are folded flat on each other. By exact predicates of
/// the doubles. Degenerate faces that share an edge with another count as folded.
/// @return nullopt if there is none.   Cost O(n log n) of a surface that is not crumpled.
std::optional<FacePair> self_crossing(const Points& x,
                                      const std::vector<std::array<int, 3>>& faces);

/// The positions as files hold them.
Points rounded_to_float32(const Points& x);

}  // namespace trivet::flex
