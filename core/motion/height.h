// Heights of points over planes during a motion, one of which moves. Inline: the innermost loops.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/motion/motion.h"

namespace trivet {

/// Height of a point over a plane during a motion, when the plane is fixed or moves along: f0 + A
/// (cos - 1) + B sin for a rotation, f0 + B t for a translation.
struct HeightFunction {
  double f0, A, B;
};

/// Product f0 + p . R q - p . q, R turning about the unit axis.
inline HeightFunction turning_product(double f0, const Vec3& axis, const Vec3& p, const Vec3& q) {
  return {f0, p.dot(q) - axis.dot(p) * axis.dot(q), p.dot(axis.cross(q))};
}

/// Height n . x of a moving point x over a fixed plane with normal n; f0 is its value at the start.
/// x is relative to a point on the axis.
inline HeightFunction height_of_moving_point(double f0, const Vec3& n, const Vec3& x,
                                             const Motion& motion) {
  if (motion.kind == Motion::Kind::Translation) return {f0, 0, n.dot(motion.axis)};
  return turning_product(f0, motion.axis, n, x);
}

/// Height of a fixed point x over a moving plane.
inline HeightFunction height_over_moving_plane(double f0, const Vec3& n, const Vec3& x,
                                               const Motion& motion) {
  if (motion.kind == Motion::Kind::Translation) return {f0, 0, -n.dot(motion.axis)};
  return turning_product(f0, motion.axis, x, n);
}

/// First time > 0 at which a height that starts at f0 > 0 is 0; 0 if f0 <= 0; infinity if there is
/// none.
inline double first_zero(const HeightFunction& f, Motion::Kind kind) {
  if (f.f0 <= 0) return 0;
  if (kind == Motion::Kind::Translation) return f.B < 0 ? f.f0 / -f.B : kInfinity;
  // (f0 - 2A) s^2 + 2B s + f0 = 0, the stable form of its smallest positive root.
  const double leading = f.f0 - 2 * f.A;
  const double discriminant = f.B * f.B - f.f0 * leading;
  if (discriminant < 0) return kInfinity;
  const double root = std::sqrt(discriminant);
  if (f.B < 0) return f.f0 / (root - f.B);
  return leading < 0 ? (root + f.B) / -leading : kInfinity;
}

/// True if first_zero(f, kind) > horizon, to rounding, without a root. A rotation's horizon may be
/// larger than 1 and counts as 1.
inline bool positive_until(const HeightFunction& f, Motion::Kind kind, double horizon) {
  if (f.f0 <= 0) return false;
  if (kind == Motion::Kind::Translation) return f.B >= 0 || f.f0 > -f.B * horizon;
  const double h = std::min(horizon, 1.0), leading = f.f0 - 2 * f.A;
  if ((leading * h + 2 * f.B) * h + f.f0 <= 0) return false;
  // Positive at both ends: a root in between requires the parabola's minimum in between.
  return leading <= 0 || f.B >= 0 || -f.B >= leading * h || f.B * f.B < f.f0 * leading;
}

}  // namespace trivet
