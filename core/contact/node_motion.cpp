#include "core/contact/node_motion.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace trivet {
namespace {

constexpr auto kRotation = Motion::Kind::Rotation;

struct Range {
  double lower, upper;
};

// Of n . x of a node about its centre: along the part of n in the slab's normal by the slab, along
// the rest by the box. n is in the node's own frame.
Range range_along(const PlacedNode& node, const Vec3& n) {
  const double c = n.dot(node.own.normal);
  const double beside = (n - c * node.own.normal).cwiseAbs().dot(node.own.half);
  const double box = n.cwiseAbs().dot(node.own.half);
  return {std::max(std::min(c * node.lower, c * node.upper) - beside, -box),
          std::min(std::max(c * node.lower, c * node.upper) + beside, box)};
}

double turn_until(const Approach& x, double horizon) {
  if (!positive_until(grown_box(x), kRotation, horizon) &&
      !positive_until(sphere_of_box(x), kRotation, horizon))
    return 0;
  return std::max(std::nextafter(horizon, kInfinity), box_until(x, kRotation));
}

}  // namespace

NodeMotion::NodeMotion(const Motion& of_moving, const Motion& of_fixed, double margin)
    : m_kind(of_moving.kind), m_margin(margin) {
  const auto side = [](const Motion& motion) {
    const Vec3& v = motion.axis;
    return Side{v, v.cwiseAbs().cwiseMax(1e-300).cwiseInverse()};
  };
  m_of_moving = side(of_moving);
  m_of_fixed = side(of_fixed);
}

double NodeMotion::apart_until(const PlacedNode& moving, const PlacedNode& fixed,
                               double horizon) const {
  return m_kind == kRotation ? turning_until(moving, fixed, horizon)
                             : sliding_until(moving, fixed, horizon);
}

double NodeMotion::sliding_until(const PlacedNode& moving, const PlacedNode& fixed,
                                 double horizon) const {
  double leave = kInfinity;
  double enter = boxes_slide(moving, fixed, m_of_moving, leave);
  if (enter > horizon || enter > leave) return enter > leave ? kInfinity : enter;
  enter = std::max(enter, boxes_slide(fixed, moving, m_of_fixed, leave));
  if (enter > horizon || enter > leave) return enter > leave ? kInfinity : enter;
  enter = std::max(enter, slab_slides(moving, fixed, m_of_moving));
  if (enter > horizon) return enter;
  return std::max(enter, slab_slides(fixed, moving, m_of_fixed));
}

double NodeMotion::boxes_slide(const PlacedNode& mover, const PlacedNode& still, const Side& side,
                               double& leave) const {
  double enter = 0;
  for (int k = 0; k < 3; ++k) {
    const double reach = mover.other.half[k] + still.own.half[k] + m_margin;
    const double d = mover.other.centre[k] - still.own.centre[k];
    const double x = side.direction[k] < 0 ? -d : d;
    enter = std::max(enter, (-reach - x) * side.inverse_speed[k]);
    leave = std::min(leave, (reach - x) * side.inverse_speed[k]);
  }
  return enter;
}

double NodeMotion::slab_slides(const PlacedNode& mover, const PlacedNode& still,
                               const Side& side) const {
  const Vec3& n = still.own.normal;
  const Range of_mover = range_along(mover, still.other.normal);
  const double along = n.dot(mover.other.centre - still.own.centre);
  const double speed = n.dot(side.direction);
  const double above = along + of_mover.lower - still.upper - m_margin;
  if (above > 0) return speed < 0 ? above / -speed : kInfinity;
  const double below = still.lower - of_mover.upper - along - m_margin;
  if (below > 0) return speed > 0 ? below / speed : kInfinity;
  return 0;
}

double NodeMotion::turning_until(const PlacedNode& moving, const PlacedNode& fixed,
                                 double horizon) const {
  // The rings that the spheres sweep about the axis, which of the fixed body points the other way.
  const double reach = moving.radius + fixed.radius + m_margin;
  if (std::abs(moving.height + fixed.height) > reach || std::abs(moving.ring - fixed.ring) > reach)
    return kInfinity;
  if (const double until = boxes_turn(moving, fixed, horizon); until > 0) return until;
  if (const double until = boxes_turn(fixed, moving, horizon); until > 0) return until;
  if (const double until = slab_turns(moving, fixed, horizon); until > 0) return until;
  return slab_turns(fixed, moving, horizon);
}

double NodeMotion::boxes_turn(const PlacedNode& mover, const PlacedNode& still,
                              double horizon) const {
  for (int k = 0; k < 3; ++k) {
    const double d = mover.other.centre[k] - still.own.centre[k], sign = d < 0 ? -1 : 1;
    const double gap = std::abs(d) - mover.other.half[k] - still.own.half[k] - m_margin;
    if (gap <= 0) continue;
    const double until = turn_until({gap,
                                     mover.other.half[k],
                                     mover.radius,
                                     {0, sign * mover.radial[k], sign * mover.tangent[k]}},
                                    horizon);
    if (until > 0) return until;
  }
  return 0;
}

double NodeMotion::slab_turns(const PlacedNode& mover, const PlacedNode& still,
                              double horizon) const {
  const Vec3& n = still.own.normal;
  const Range of_mover = range_along(mover, still.other.normal);
  const double along = n.dot(mover.other.centre - still.own.centre);
  const double above = along + of_mover.lower - still.upper - m_margin;
  const double below = still.lower - of_mover.upper - along - m_margin;
  if (above <= 0 && below <= 0) return 0;
  const double sign = above > 0 ? 1 : -1;
  return turn_until({std::max(above, below),
                     above > 0 ? -of_mover.lower : of_mover.upper,
                     mover.radius,
                     {0, sign * n.dot(mover.radial), sign * n.dot(mover.tangent)}},
                    horizon);
}

}  // namespace trivet
