#include "core/contact/node_motion.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/contact/node_gaps.h"

namespace trivet {
namespace {

constexpr auto kRotation = Motion::Kind::Rotation;

/// An Approach of each body, in the lane of the frame that it moves in: see node_gaps.h.
struct Approaches {
  Double2 gap, extent, radius;
  Double2 A, B;  // of the centre

  Approach of(int lane) const {
    return {gap[lane], extent[lane], radius[lane], {0, A[lane], B[lane]}};
  }
};

// positive_until() of turns.
Mask2 positive_until(Double2 f0, Double2 A, Double2 B, Double2 h) {
  // The quadratic of height.h in s is positive at zero and at the end, and has no root between.
  const Double2 leading = f0 - 2 * A, end = leading * h;
  return (f0 > 0.0) & ((end + 2 * B) * h + f0 > 0.0) &
         ((leading <= 0.0) | (B >= 0.0) | (-B >= end) | (B * B < f0 * leading));
}

// The first double after a finite x, which is +0 or more.
double after(double x) { return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) + 1); }

double turn_until(const Approaches& x, double horizon) {
  // Bounds on a turning box hold up to s = 1.
  const Double2 h = both(std::min(horizon, 1.0));
  const Mask2 beside = x.gap > 0.0;
  // As grown_box(), which mostly decides, and sphere_of_box().
  Mask2 apart = beside & positive_until(x.gap, x.A + kBend * x.radius, x.B - x.radius, h);
  if (!any(apart)) apart = beside & positive_until(x.gap + x.extent - x.radius, x.A, x.B, h);
  if (!any(apart)) return 0;
  // Nodes that are apart until the horizon wait for their bound; rounding may put it before the
  // horizon, so the next double is the least.
  return std::max(after(horizon), box_until(x.of(apart[kFixed] ? kFixed : kMoving), kRotation));
}

}  // namespace

NodeMotion::NodeMotion(const Motion& of_moving, const Motion& of_fixed, double margin)
    : m_kind(of_moving.kind), m_margin(margin) {
  for (int k = 0; k < 3; ++k) {
    // Times of entry are distances over speeds; a speed of zero becomes tiny, and its time larger
    // than any motion.
    m_direction[k] = Double2{of_moving.axis[k], of_fixed.axis[k]};
    m_inverse_speed[k] = 1.0 / max(abs(m_direction[k]), both(1e-300));
  }
}

double NodeMotion::apart_until(const PlacedNode& moving, const PlacedNode& fixed,
                               double horizon) const {
  return m_kind == kRotation ? turning_until(moving, fixed, horizon)
                             : sliding_until(moving, fixed, horizon);
}

double NodeMotion::sliding_until(const PlacedNode& moving, const PlacedNode& fixed,
                                 double horizon) const {
  Double2 enters = both(0), leaves = both(kInfinity);
  for (int k = 0; k < 3; ++k) {
    // The box moves past the slab of each axis between these two times.
    const Double2 reach = moving.half[k] + fixed.half[k] + m_margin;
    const Double2 d = seen_from_still(moving.centre[k] - fixed.centre[k]);
    const Double2 x = times_sign(d, m_direction[k]);
    enters = max(enters, (-reach - x) * m_inverse_speed[k]);
    leaves = min(leaves, (reach - x) * m_inverse_speed[k]);
  }
  // Both frames see the same motion, so the later entry and the earlier exit of either count.
  const double enter = std::max(enters[0], enters[1]), leave = std::min(leaves[0], leaves[1]);
  // It leaves one slab before it enters another: it passes by.
  if (enter > leave) return kInfinity;
  return enter > horizon ? enter : std::max(enter, slabs_slide(moving, fixed));
}

double NodeMotion::slabs_slide(const PlacedNode& moving, const PlacedNode& fixed) const {
  const SlabGaps gaps(moving, fixed);
  const Double2 above = gaps.above - m_margin, below = gaps.below - m_margin;
  const Double2 speed = dot(gaps.normal, m_direction);
  double until = 0;
  for (const int lane : {kFixed, kMoving}) {
    // Either lane alone proves that the nodes are apart; the later of both is kept.
    const double v = speed[lane];
    // A box above a slab stays apart until it has come down to it, and for good if it rises.
    if (above[lane] > 0)
      until = std::max(until, v < 0 ? above[lane] / -v : kInfinity);
    else if (below[lane] > 0)
      until = std::max(until, v > 0 ? below[lane] / v : kInfinity);
  }
  return until;
}

double NodeMotion::turning_until(const PlacedNode& moving, const PlacedNode& fixed,
                                 double horizon) const {
  // The rings that the spheres sweep about the axis, which of the fixed body points the other way.
  const double reach = moving.radius + fixed.radius + m_margin;
  if (std::abs(moving.height + fixed.height) > reach || std::abs(moving.ring - fixed.ring) > reach)
    return kInfinity;
  // The axes of both boxes come first, then the slabs of their faces.
  const double until = boxes_turn(moving, fixed, horizon);
  return until > 0 ? until : slabs_turn(moving, fixed, horizon);
}

double NodeMotion::boxes_turn(const PlacedNode& moving, const PlacedNode& fixed,
                              double horizon) const {
  const Double2 radius{moving.radius, fixed.radius};
  for (int k = 0; k < 3; ++k) {
    const Double2 d = moving.centre[k] - fixed.centre[k];
    // A gap along any axis of either box is a start: the turn has to close it first.
    const Double2 gap = abs(d) - moving.half[k] - fixed.half[k] - m_margin;
    if (!any(gap > 0.0)) continue;
    const Double2 side = seen_from_still(d);
    const Double2 radial{moving.radial[k], fixed.radial[k]};
    const Double2 tangent{moving.tangent[k], fixed.tangent[k]};
    const double until = turn_until({gap, others(moving.half[k], fixed.half[k]), radius,
                                     times_sign(radial, side), times_sign(tangent, side)},
                                    horizon);
    if (until > 0) return until;
  }
  return 0;
}

double NodeMotion::slabs_turn(const PlacedNode& moving, const PlacedNode& fixed,
                              double horizon) const {
  // Nodes that overlap along both slabs' normals prove nothing.
  const SlabGaps gaps(moving, fixed);
  const Double2 gap = max(gaps.above, gaps.below) - m_margin;
  if (!any(gap > 0.0)) return 0;
  const Double2 A = dot(gaps.normal, lanes(moving.radial, fixed.radial));
  const Double2 B = dot(gaps.normal, lanes(moving.tangent, fixed.tangent));
  // A node below the slab is mirrored, so that one formula holds for both sides.
  const Mask2 is_above = gaps.above > m_margin;
  return turn_until({gap, is_above ? -gaps.lower : gaps.upper, Double2{moving.radius, fixed.radius},
                     is_above ? A : -A, is_above ? B : -B},
                    horizon);
}

}  // namespace trivet
