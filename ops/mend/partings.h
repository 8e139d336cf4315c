// Shifts that part pairs, as short as possible together. Private.
#pragma once

#include <optional>
#include <vector>

#include "core/base/types.h"

namespace trivet {

/// way . (shift of a - shift of b) is to be at least this; in the plane, or in space.
template <class Way>
struct PartingAlong {
  size_t a = 0;
  std::optional<size_t> b;  // nothing: what stays
  Way way = Way::Zero();    // unit
  double least = 0;         // metres
};
using Parting = PartingAlong<Vec2>;
using Parting3 = PartingAlong<Vec3>;

/// The shifts with the least sum of squares that meet all partings, to a micrometre; where these
/// contradict each other, each gives way a little. By relaxation of their multipliers [Hildreth
/// 1957]; cost O(partings) for each of some thousand sweeps.
/// @param num  of shifts.
template <class Way>
std::vector<Way> least_shifts(const std::vector<PartingAlong<Way>>& partings, size_t num);

/// The unit way along which polygon `a` leaves polygon `b` soonest, and the metres until then;
/// negative: so far apart they are. Convex, counter-clockwise.
struct WayApart {
  Vec2 way = Vec2::Zero();
  double metres = 0;
};
WayApart way_apart(const std::vector<Vec2>& a, const std::vector<Vec2>& b);

}  // namespace trivet
