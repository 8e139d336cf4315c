// Gap between two nodes at time 0, by their boxes and slabs. Private.
#pragma once

#include <utility>

#include "core/contact/placed_node.h"

namespace trivet {

// One lane per frame for everything that counts both ways, by the moving body and by the fixed one
// as seen from it. Lane kFixed: the moving body moves in the frame of the fixed one, which stands
// still; lane kMoving: the other way about.

/// One lane per frame: quantities of the body that moves in it.
inline Double2 others(Double2 of_moving, Double2 of_fixed) {
  return Double2{of_moving[kFixed], of_fixed[kMoving]};
}
inline Vec3Lanes others(const Vec3Lanes& of_moving, const Vec3Lanes& of_fixed) {
  return {others(of_moving[0], of_fixed[0]), others(of_moving[1], of_fixed[1]),
          others(of_moving[2], of_fixed[2])};
}
/// One lane per frame: quantities of the body whose frame it is.
inline Double2 own(Double2 of_moving, Double2 of_fixed) {
  return Double2{of_fixed[kFixed], of_moving[kMoving]};
}
inline Vec3Lanes own(const Vec3Lanes& of_moving, const Vec3Lanes& of_fixed) {
  return {own(of_moving[0], of_fixed[0]), own(of_moving[1], of_fixed[1]),
          own(of_moving[2], of_fixed[2])};
}
/// A direction from the fixed to the moving body, turned so that it leads from what stands still to
/// what moves.
inline Double2 seen_from_still(Double2 x) { return times_sign(x, Double2{1, -1}); }

/// True if they are farther apart than `reach` along an axis of either body.
inline bool boxes_apart(const PlacedNode& moving, const PlacedNode& fixed, double reach) {
  Mask2 apart{0, 0};
  for (int k = 0; k < 3; ++k)
    apart |= abs(moving.centre[k] - fixed.centre[k]) - moving.half[k] - fixed.half[k] > reach;
  return any(apart);
}

/// Normal of a plane, in the world and in the frames of both bodies of a pair.
struct PlaneNormal {
  Vec3 world = Vec3::Zero(), in_fixed = Vec3::Zero(), in_moving = Vec3::Zero();

  PlaneNormal() = default;
  PlaneNormal(const Vec3& n, const PairFrames& frames);
  bool is_known() const { return world != Vec3::Zero(); }
};

/// The least and the largest n . (p - origin) of a node's points p, from its slab or its box; the
/// origin is that of the fixed body. @param n  not longer than 1. @param own  frame of its body.
std::pair<double, double> along(const PlacedNode& node, int own, const PlaneNormal& n);

/// Along the normal of the slab of the node that stands still.
struct SlabGaps {
  Double2 above, below;  // from the slab to what moves; negative: they overlap
  Double2 lower, upper;  // of what moves, about its centre
  Vec3Lanes normal;      // of the slab

  SlabGaps(const PlacedNode& moving, const PlacedNode& fixed);
};

/// True if they are farther apart than `reach` along the normal of either slab.
inline bool slabs_apart(const PlacedNode& moving, const PlacedNode& fixed, double reach) {
  const SlabGaps gaps(moving, fixed);
  return any((gaps.above > reach) | (gaps.below > reach));
}

}  // namespace trivet
