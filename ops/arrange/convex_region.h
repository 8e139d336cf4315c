// Convex polygons of the plane: where an object may be, seen from above, and outlines of objects.
#pragma once

#include <vector>

#include "core/base/types.h"

namespace trivet {

/// Points p with normal . p <= bound.
struct HalfPlane {
  Vec2 normal;
  double bound;
};

class ConvexRegion {
 public:
  ConvexRegion() = default;  // empty
  ConvexRegion(const Vec2& lower, const Vec2& upper);

  /// Keeps what is in the half plane, too [Sutherland 1974].
  void clip(const HalfPlane& half_plane);
  bool empty() const { return m_corners.empty(); }
  const std::vector<Vec2>& corners() const { return m_corners; }  // counter-clockwise
  Vec2 lower() const;
  Vec2 upper() const;
  /// The nearest point of it; not of an empty one.
  Vec2 nearest(const Vec2& p) const;

 private:
  std::vector<Vec2> m_corners;
};

/// Greatest p . direction of the points; not of none.
double extent(const std::vector<Vec2>& points, const Vec2& direction);

/// Distance of two convex polygons, counter-clockwise; 0: they overlap. By all pairs of edges.
/// @param enough  if it is no more than this, the result may be anything from it up to this.
double distance(const std::vector<Vec2>& a, const std::vector<Vec2>& b, double enough = 0);

}  // namespace trivet
