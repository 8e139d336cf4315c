// Time until which boxes of a moving body stay clear of something fixed, along one axis. Private.
#pragma once

#include <algorithm>

#include "core/motion/height.h"

namespace trivet {

/// Approach of a moving box to something fixed, along one axis.
struct Approach {
  double gap;             // between the boxes along the axis, less the largest stop
  double extent;          // of the moving box along the axis, to one side
  double radius;          // of its sphere
  HeightFunction centre;  // A and B of its centre; f0 is not used
};

/// A turning box stays within two bounds: itself grown by the chord 2 sin(angle / 2) times the
/// radius (for s <= 1 that chord is at most 2 s + 2 kBend s^2, over 1 + s^2), and its sphere.
inline constexpr double kBend = 0.41425;
inline HeightFunction grown_box(const Approach& x) {
  return {x.gap, x.centre.A + kBend * x.radius, x.centre.B - x.radius};
}
inline HeightFunction sphere_of_box(const Approach& x) {
  return {x.gap + x.extent - x.radius, x.centre.A, x.centre.B};
}

/// Until then they are apart.
inline double box_until(const Approach& x, Motion::Kind kind) {
  if (x.gap <= 0) return 0;
  if (kind == Motion::Kind::Translation) return first_zero({x.gap, 0, x.centre.B}, kind);
  return std::max(first_zero(grown_box(x), kind), first_zero(sphere_of_box(x), kind));
}

}  // namespace trivet
