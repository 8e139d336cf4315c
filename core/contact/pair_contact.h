// First contact of two triangles, one of which moves: the one routine that decides.
//
// Method: kinetic separating planes. Two disjoint triangles have a plane between them. A plane that
// stands still, that moves along, or that is spanned by one edge of each keeps them apart until one
// of a few heights is zero, and each such height is f0 + A (cos - 1) + B sin (or f0 + B t): a
// quadratic in s = tan(angle / 2), solved in closed form. At that time the distance is measured; if
// it is not the target yet, the next plane is taken. A vertex-face contact needs one plane (its
// root is the classical one), an edge-edge contact a few, because their common normal turns.
//
// Departs from roots of coplanarity per vertex-face and edge-edge pair [Provot 1997, Redon 2002]
// because a root may be spurious, must be told from grazing, and fails for parallel edges and
// slivers; a plane between two convex sets proves, at every step, that nothing was passed. There
// are no degenerate cases left: distance is defined for every triangle.
#pragma once

#include "core/motion/motion.h"

namespace trivet {

/// Distance that motions keep, and its tolerances.
struct Clearance {
  double distance = 0;  // metres, > 0

  /// The distance at which a pair that starts `initial` apart stops.
  double target(double initial) const;
  /// No pair stops at a distance larger than this.
  double largest_stop() const;
};

struct PairContact {
  enum class Status {
    Free,      // not closer than the target up to the limit (or to `best`)
    Contact,   // at `time` the distance is the target, up to kTargetSlack of it
    Crossing,  // the triangles cross or touch at time 0
    Stalled,   // no plane leads on; free up to `time`, and treated as a contact there
  };
  Status status = Status::Free;
  double time = kInfinity;
  Vec3 point = Vec3::Zero();    // on the fixed triangle
  Vec3 normal = Vec3::UnitZ();  // unit, from the fixed to the moving triangle
  double gap = 0;
};

/// @param moving  world, at time 0. @param fixed  world.
/// @param best  gives up (Free) as soon as the first contact is proved to be later than this; the
///   result is otherwise independent of it (but for Stalled: met where the clearance is below 1e-8
///   of the triangles' size, see HardlyEverRunsOutOfPlanes).
PairContact first_contact(const Triangle& moving, const Triangle& fixed, const Motion& motion,
                          const Clearance& clearance, double best = kInfinity);

/// First time at which a point comes down to the floor z = 0, with the same rule for its target.
double first_floor_contact(const Vec3& p, const Motion& motion, const Clearance& clearance);

}  // namespace trivet
