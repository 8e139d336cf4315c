// Regions that objects are to lie in, seen from above.
#pragma once

#include <vector>

#include "core/base/sentence.h"
#include "core/contact/body.h"

namespace trivet {

/// True of at least 3 corners of a convex polygon, counter-clockwise; in words, what is accepted.
bool is_convex_region(const std::vector<Vec2>& corners);
inline constexpr const char* kConvexRegion =
    TRIVET_SENTENCE("at least 3 corners [x, y] of a convex polygon, counter-clockwise");

/// The corners of a region: of the rectangle, where two opposite ones are given.
std::vector<Vec2> region_of(const std::vector<Vec2>& corners);

/// A convex polygon of the plane, or all of it.
class PlaceRegion {
 public:
  PlaceRegion() = default;  // all of it
  /// @param corners  see is_convex_region(); none: all of it.
  explicit PlaceRegion(const std::vector<Vec2>& corners);

  bool is_all() const { return m_sides.empty(); }
  bool holds(const Vec2& point) const;
  /// All vertices of it. Cost O(vertices x corners).
  bool holds(const Body& body) const;
  /// Region of a point that moves with the body, for the body to be in this one.
  PlaceRegion of_point(const Vec2& point, const Body& body) const;
  /// Corners of a box that contains it; infinite: all of it. Of one where nothing is, the lower may
  /// be beyond the upper.
  const Vec2& lower() const { return m_lower; }
  const Vec2& upper() const { return m_upper; }

 private:
  struct Side {
    Vec2 outwards;
    double bound;  // outwards . p <= bound
  };
  std::vector<Side> m_sides;
  Vec2 m_lower = Vec2::Constant(-kInfinity), m_upper = Vec2::Constant(kInfinity);
};

}  // namespace trivet
