// Closest points of points, segments and triangles, as weights of their ends and corners.
#pragma once

#include <algorithm>

#include "core/base/types.h"

namespace trivet::flex {

/// Share of b in the point of the segment ab that is closest to p.
inline double closest_on_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 along = b - a;
  const double squared_length = along.squaredNorm();
  return squared_length > 0 ? std::clamp((p - a).dot(along) / squared_length, 0.0, 1.0) : 0;
}

/// Weights of a, b and c in the point of the triangle that is closest to p [Ericson 2005, 5.1.5].
/// A weight is zero exactly where the corner or edge opposite is closest.
Vec3 closest_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c);

/// Shares of the second ends in the closest points of two segments; of parallel ones in the middle
/// of the first.
struct SegmentShares {
  double s = 0, t = 0;
};
SegmentShares closest_on_segments(const Vec3& p0, const Vec3& p1, const Vec3& q0, const Vec3& q1);

}  // namespace trivet::flex
