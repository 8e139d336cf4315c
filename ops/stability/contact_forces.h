// Contact forces inside friction cones that balance a connected part of the scene.
// [Whiting 2009, 3: static equilibrium of rigid blocks as a program over contact forces, what is
// missing penalised; here with linear costs, so that the prices are a motion.]
#pragma once

#include <span>
#include <vector>

#include "ops/stability/free_bodies.h"

namespace trivet {

struct PartForces {
  bool solved = false;          // else the rest means nothing
  std::vector<double> missing;  // of each body: force and torque / size, in parts of its weight,
                                // beyond what residual_tolerance() leaves open
  std::vector<bool> moves;      // each body: in the motion that proves the lack of balance
  std::vector<VirtualMotion> motions;  // of each body: that one; see ObjectStability::motion
  std::vector<Vec3> forces;            // newtons, of each touch, on its body `on`
  double residual = 0;                 // sum of `missing`

  bool balanced() const;  // nothing is missing of any body
};

/// The forces that leave the least missing, by linear programming over friction pyramids of 8
/// edges. Contacts are known to a few clearances, so that torque of residual_tolerance() x the sum
/// of all pushes on a body may be missing. Against two contacts a hair apart that could hold
/// anything by pressing against each other: all friction at a body is at most 10 times the weight
/// that it carries, all pushes at most 20 times.
/// @param part  one connected part, its bodies and touches alone; those of `more` that lower what
/// is
///   missing join the touches (column generation). @param clearance  metres.
/// @param factor  of all coefficients of friction.
PartForces contact_forces(FreeBodies& part, double clearance, double factor = 1);

/// Each body's weight with all that lies on it by the touches, directly or not, in newtons. Limits
/// of friction and pushes are in parts of it.
std::vector<double> carried_weights(const FreeBodies& part);

/// Part of a body's weight that may be missing: rounding below this.
inline constexpr double kMayBeMissing = 1e-6;

/// Most friction at a body, and most pushes, the parts along the normals, in weights that it
/// carries.
inline constexpr double kFrictionLimit = 10, kPushLimit = 20;

/// Whom a touch may carry: its body `on`, its body `from`.
struct MayCarry {
  bool on = true, from = true;
};

/// Forces that balance a part, as contact_forces() did, and push up as little as can be where
/// touches are not meant to: friction leaves many open, and these are those of known supports, as
/// far as they suffice.
/// @param may  for each touch. @return newtons, of each touch, on its body `on`; empty: not solved.
std::vector<Vec3> forces_of_carriers(const FreeBodies& part, double clearance,
                                     std::span<const MayCarry> may);

/// True if forces that leave nothing missing of any body are found by the dual simplex method, in a
/// part of the time. False: contact_forces() knows.
bool quickly_balanced(const FreeBodies& part, double clearance, double factor = 1);

/// Distance by which all weights may be shifted together, sideways, in the worst of 8 directions,
/// while nothing is missing. @return metres, at most the largest body's size; negative: something
/// is missing without any shift.
double shift_margin(const FreeBodies& part, double clearance);

}  // namespace trivet
