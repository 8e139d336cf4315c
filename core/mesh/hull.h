// Convex hull of points.
#pragma once

#include <span>
#include <vector>

#include "core/base/types.h"

namespace trivet {

/// Boundary of a solid convex hull.
struct ConvexHull {
  std::vector<Index> vertices;    // ids into the points, ascending; empty if there is no solid hull
  std::vector<Index3> triangles;  // in no particular orientation
};

/// Hull of points in any position: empty if there are fewer than 4, or all lie in one plane to
/// within rounding. Points within rounding of the hull may be left out. Qhull [Barber
/// 1996].   Cost O(n log n).   Thread-safe.
ConvexHull convex_hull(std::span<const Vec3> points);

}  // namespace trivet
