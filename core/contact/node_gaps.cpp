#include "core/contact/node_gaps.h"

#include <algorithm>

namespace trivet {

PlaneNormal::PlaneNormal(const Vec3& n, const PairFrames& frames)
    : world(n),
      in_fixed(frames.fixed.direction(n)),
      in_moving(frames.fixed_from_moving.transpose() * in_fixed) {}

std::pair<double, double> along(const PlacedNode& node, int own, const PlaneNormal& n) {
  const Vec3& in_own = own == kFixed ? n.in_fixed : n.in_moving;
  const Vec3 normal = lane(node.normal, own), half = lane(node.half, own);
  // The part of n along the slab's normal reaches as far as the slab, the rest as far as the box.
  const double c = in_own.dot(normal), box = in_own.cwiseAbs().dot(half);
  const double beside = (in_own - c * normal).cwiseAbs().dot(half);
  const auto [low, high] = std::minmax({c * node.lower, c * node.upper});
  const double centre = n.in_fixed.dot(node.centre_in(kFixed));
  return {centre + std::max(low - beside, -box), centre + std::min(high + beside, box)};
}

// Reach of what moves: along the part of the normal in its own slab's normal that of its slab,
// along the rest that of its box. Computed in its own frame, which is the other lane.
SlabGaps::SlabGaps(const PlacedNode& moving, const PlacedNode& fixed)
    : normal(own(moving.normal, fixed.normal)) {
  // Both directions are computed at once: every quantity has a lane for each frame.
  const Vec3Lanes theirs = others(moving.normal, fixed.normal), half = own(moving.half, fixed.half);
  const Double2 c = dot(theirs, normal);
  // The part along the moving slab's own normal is as thin as that slab; the rest is as wide as its
  // box.
  const Double2 beside = dot(abs(theirs - c * normal), half), box = dot(abs(theirs), half);
  const Double2 slab_lower{fixed.lower, moving.lower}, slab_upper{fixed.upper, moving.upper};
  const Double2 low = c * slab_lower, high = c * slab_upper;
  lower = swapped(max(min(low, high) - beside, -box));
  // The tighter of slab and box counts at each end; lanes change places as the reach was computed
  // in the mover's own frame.
  upper = swapped(min(max(low, high) + beside, box));
  const Double2 along = seen_from_still(dot(normal, moving.centre - fixed.centre));
  above = along + lower - slab_upper;
  below = slab_lower - upper - along;
}

}  // namespace trivet
