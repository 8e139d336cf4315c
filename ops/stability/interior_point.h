// Contact forces of many bodies, by an interior-point method. Private.
#pragma once

#include "ops/stability/contact_forces.h"

namespace trivet {

/// Motion: where forces do not balance, a motion that proves it and comes within a hundredth of the
/// optimum's will do, which takes two thirds of the steps. Nearly all bodies take part, most
/// slowly.
enum class Sought { Optimum, Motion };

/// The answer of contact_forces() to the same linear program over all contacts, `more` among them,
/// by the primal-dual method of Mehrotra [1992]: some 15 steps where forces balance, 35 where not.
/// Its equations couple bodies that touch alone, and their blocks are factorised. For 100 bodies it
/// takes a 25th to an 80th of the time of CLP's simplex method. Either answer is proved:
///   balanced: the limits are asked, and what is missing is summed up anew, of these very forces;
///   not balanced: the motions prove it by weak duality, see ForceProgram::least_missing().
/// @return `solved` is false where neither was found, as where hardly more than kMayBeMissing is;
/// `forces` are of each touch, and then of each one of `more`.
PartForces forces_by_interior_point(const FreeBodies& part, double clearance, double factor = 1,
                                    Sought sought = Sought::Optimum);

/// True if this motion of all bodies proves by weak duality that more is missing than may be: no
/// forces of touches balance the part.
bool proves_lack_of_balance(const std::vector<VirtualMotion>& motions, const FreeBodies& part,
                            double clearance, double factor = 1);

/// For more than so many bodies it takes less time than the simplex method: for 24 a fifth.
inline constexpr size_t kManyBodies = 8;

/// forces_by_interior_point() of many bodies, and contact_forces() of few and of what that leaves
/// open.
PartForces quickest_forces(FreeBodies& part, double clearance, double factor = 1,
                           Sought sought = Sought::Optimum);

}  // namespace trivet
