#include "core/contact/slab_motion.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "core/contact/approach.h"

namespace trivet {

double SlabMotion::clear_until(const NodeSlab& a, const NodeSlab& b, const PlacedBvh::Box& box_a,
                               const PlacedBvh::Box& box_b, double until, double horizon) const {
  if (motion.kind == Motion::Kind::Translation) return sliding_until(a, b, box_a, box_b, until);
  return turns_clear(a, b, box_a, box_b, until, horizon) ? kInfinity : until;
}

double SlabMotion::sliding_until(const NodeSlab& a, const NodeSlab& b, const PlacedBvh::Box& box_a,
                                 const PlacedBvh::Box& box_b, double until) const {
  const Vec3 d = box_a.centre - box_b.centre;
  for (const Vec3& n : {a.normal, b.normal}) {
    const SlabRange of_a = a.along(n, box_a.half), of_b = b.along(n, box_b.half);
    const double along = n.dot(d), speed = n.dot(motion.axis);
    const double above = along + of_a.lower - of_b.upper - margin;
    const double below = of_b.lower - of_a.upper - along - margin;
    if (above > 0)
      until = std::max(until, first_zero({above, 0, speed}, motion.kind));
    else if (below > 0)
      until = std::max(until, first_zero({below, 0, -speed}, motion.kind));
  }
  return until;
}

// At the time `until` the bodies are turned so far that slabs tell more than boxes. There, all is
// seen from the moving body: the fixed one is turned back.
bool SlabMotion::turns_clear(const NodeSlab& a, NodeSlab b, const PlacedBvh::Box& box_a,
                             const PlacedBvh::Box& box_b, double until, double horizon) const {
  const double h = std::min(horizon, 1.0), rest = (h - until) / (1 + h * until);
  const Vec3 p = box_a.centre - motion.centre, q = turned_back(box_b.centre - motion.centre, until);
  b.normal = turned_back(b.normal, until);
  return stays_beside(b.normal, p, q, a.along(b.normal, box_a.half),
                      b.along(b.normal, box_b.radius), box_a.radius, 1, rest) ||
         stays_beside(a.normal, q, p, b.along(a.normal, box_b.radius),
                      a.along(a.normal, box_a.half), box_b.radius, -1, rest);
}

// Returns whether a point set at p, which turns (by `sense`: on or back), stays on its side of one
// at rest at q, along n; their ranges and the radius are about p and q.
bool SlabMotion::stays_beside(const Vec3& n, const Vec3& p, const Vec3& q, const SlabRange& of_p,
                              const SlabRange& of_q, double radius, double sense,
                              double rest) const {
  const double along = n.dot(p - q);
  const double above = along + of_p.lower - of_q.upper - margin;
  const double below = of_q.lower - of_p.upper - along - margin;
  if (above <= 0 && below <= 0) return false;
  const double side = above > 0 ? 1 : -1;
  const double radial = n.dot(p) - motion.axis.dot(p) * motion.axis.dot(n);
  const double tangent = sense * n.dot(motion.axis.cross(p));
  return positive_until(
      grown_box({std::max(above, below), 0, radius, {0, side * radial, side * tangent}}),
      motion.kind, rest);
}

Vec3 SlabMotion::turned_back(const Vec3& v, double s) const {
  const double w = 2 * s / (1 + s * s);
  const Vec3 tangent = motion.axis.cross(v);
  return v - w * tangent + w * s * motion.axis.cross(tangent);
}

}  // namespace trivet
