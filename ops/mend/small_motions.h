// Small motions of many bodies at once, as near to given ones as conditions allow. Private.
#pragma once

#include <vector>

#include "ops/stability/free_bodies.h"

namespace trivet {

/// A body's shift, and its turn by the metres that a point at half its size moves.
using SmallMotion = Eigen::Matrix<double, 6, 1>;

/// `pose`, moved: the turn is about the body's centre of mass.
Pose moved_by(const FreeBody& body, const Pose& pose, const SmallMotion& motion);

/// The motion that moves `pose` to `to`, which is turned by less than half a turn.
SmallMotion motion_to(const FreeBody& body, const Pose& pose, const Pose& to);

/// A condition on the small motions of two bodies, or of one and what stays.
struct MotionRow {
  Index on = 0, from = BodyContact::kGround;
  SmallMotion of_on = SmallMotion::Zero(), of_from = SmallMotion::Zero();
  double least = 0;       // metres that they are to come apart at least; negative: may approach
  double least_push = 0;  // negative: up to so much, in metres, it pulls them to just as far
  double push = 0;        // multiplier

  /// Two bodies come apart at a point, along the way of `on`.
  static MotionRow apart(const std::vector<FreeBody>& bodies, Index on, Index from,
                         const Vec3& point, const Vec3& way);
  double squared_norm() const { return of_on.squaredNorm() + of_from.squaredNorm(); }
  /// Metres that they come apart.
  double of(const std::vector<SmallMotion>& motions) const;
};

/// The motions nearest to `aims`, by the sum of squares, that meet all rows; where rows contradict
/// each other, each gives way a little. By relaxation of their multipliers [Hildreth 1957], which
/// start from those in the rows; every few sweeps all that push are solved for at once
/// (multiplier_step.h). Cost O(rows) for each sweep, and of a sparse factor.
/// @param still  metres: smaller changes end it. @param soft  by which part of its multiplier each
/// row gives way: it bounds multipliers of rows that contradict each other.
std::vector<SmallMotion> nearest_motions(std::vector<MotionRow>& rows,
                                         std::vector<SmallMotion> aims, double still,
                                         double soft = 1e-6);

}  // namespace trivet
