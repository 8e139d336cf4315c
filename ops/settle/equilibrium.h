// Can these contacts hold this weight?
#pragma once

#include <vector>

#include "core/contact/contact.h"
#include "ops/settle/linear_program.h"

namespace trivet {

/// Steepest contact that counts as carrying on its own: vertical force lies in the friction cone of
/// kSettlingFriction. Settling assumes nearly perfect friction [Shinya 1995, 5.3]; truly perfect
/// friction would let two contacts a hair apart hold anything by pressing against each other.
inline constexpr double kSettlingFriction = 5.0;
inline constexpr double kCarryingNormalZ = 0.2;
/// Largest friction coefficient assumed for an object that cannot sink any further.
inline constexpr double kLargestFriction = 10.0;

/// A contact and Coulomb's coefficient of the two surfaces.
struct FrictionContact : ContactPoint {
  double friction = 0;
};

/// Distance of the centre inside the convex hull of the points, both seen from above.
/// @return metres; negative outside; -infinity without points.
double hull_margin(const std::vector<Vec2>& points, const Vec2& centre);

/// The margin of the contacts that carry: their normal's z is at least `min_normal_z`.
double carrying_margin(const std::vector<ContactPoint>& contacts, const Vec3& centre,
                       double min_normal_z = kCarryingNormalZ);

/// The margin of contacts that can carry a vertical force: it lies in their friction cones.
double friction_margin(const std::vector<FrictionContact>& contacts, const Vec3& centre);

/// Least sum of missing force (in weights) and missing torque (in weights x `size`), by linear
/// programming (CLP) over friction pyramids of 8 edges inside the cones. All friction together is
/// at most 10 weights. Of many contacts a sample comes first; others join as long as they lower the
/// sum (column generation), so that a further contact never raises it.
/// @param size  metres, of the object. @param enough  any sum up to this will do.
/// @return 0: equilibrium; infinity: no contact.
double equilibrium_residual(const std::vector<ContactPoint>& contacts, const Vec3& centre,
                            double size, double friction, double enough = 0);
/// The same, each contact with its own friction.
double friction_residual(const std::vector<FrictionContact>& contacts, const Vec3& centre,
                         double size, double enough = 0);

/// friction_residual(), and how fast it falls, to first order, with the coefficient of all
/// contacts.
struct Shortfall {
  double missing = kInfinity, gain = 0;
};
/// @param basis  of the last program of the same contacts at another friction; see LinearProgram.
Shortfall friction_shortfall(const std::vector<FrictionContact>& contacts, const Vec3& centre,
                             double size, double enough, LinearProgram::Basis* basis = nullptr);

/// These contacts, all with the same friction.
std::vector<FrictionContact> with_friction(const std::vector<ContactPoint>& contacts,
                                           double friction);

/// True if friction_residual() is at most `enough`. What a few contacts clearly cannot hold is told
/// without a program.
bool forces_balance(const std::vector<FrictionContact>& contacts, const Vec3& centre, double size,
                    double enough);

/// A lower bound of friction_residual(), by weak duality: a slide, or a turn about one contact or a
/// line through two, at which the centre sinks and no force of a contact works against it, shows
/// that forces do not hold it. O(n^3); 0: none was found.
/// @param enough  any bound above this will do.
double least_missing(const std::vector<FrictionContact>& contacts, const Vec3& centre, double size,
                     double enough = kInfinity);

/// The residual of equilibrium_residual() that contacts known to a few clearances leave open.
double residual_tolerance(double size, double clearance);

/// True if the centre is inside the hull of the contacts that carry, or contact forces balance.
bool is_balanced(const std::vector<ContactPoint>& contacts, const Vec3& centre, double size,
                 double clearance);

/// At most about `limit` contacts with (nearly) the same span of forces: per direction of normal
/// the convex hull of the points, then the points farthest from each other.
std::vector<ContactPoint> reduced(const std::vector<ContactPoint>& contacts, size_t limit);
std::vector<FrictionContact> reduced(const std::vector<FrictionContact>& contacts, size_t limit);

}  // namespace trivet
