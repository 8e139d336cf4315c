// Support surfaces: where things can be set down on an object, level by level.
#pragma once

#include <vector>

#include "core/contact/body.h"

namespace trivet {

/// Steepest face that carries what is set down: 15 degrees from the horizontal.
inline constexpr double kSupportCosine = 0.96592582628906829;

struct SupportSurface {
  double height = 0;                                // mean z over the area, metres
  double lowest = 0, highest = 0;                   // z
  double area = 0;                                  // of the faces, square metres
  Vec2 lower = Vec2::Zero(), upper = Vec2::Zero();  // bounding rectangle seen from above
  std::vector<Vec2> outline;  // convex hull seen from above, counter-clockwise
  /// Height above the surface to the next face of the same object, over half of it or more;
  /// infinity: open above.
  double head_room = kInfinity;

  Vec2 centre() const { return 0.5 * (lower + upper); }
};

/// Upward faces, clustered by edges that they share; clusters of one height (to 1/1024 of the
/// body's size) that touch are one. Left out: less than 5 % of the area of all faces seen from
/// above, and what has less than 1/256 of the body's size above it (faces inside overlapping
/// parts). Faces of meshes that are not closed and oriented count whichever side is up.
/// @return from the lowest to the highest; of one height by x, then y.
///   Cost O(n log n).   Thread-safe.
std::vector<SupportSurface> support_surfaces(const Body& body);

}  // namespace trivet
