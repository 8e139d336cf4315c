// The few bodies that make a part fall. Private.
#pragma once

#include <span>
#include <vector>

#include "ops/stability/contact_forces.h"

namespace trivet {

/// Bodies that topple even while all others of the part stand still: among those that move fastest
/// in the motion that proves that it does not stand. The motion of many bodies mostly begins with a
/// few that push the others, or fall from them. Where no few do, all that move.
/// @param forces  of the part, not balanced.
std::vector<Index> fewest_movers(const FreeBodies& part, double clearance,
                                 const PartForces& forces);

/// A proof that a part of many bodies does not stand, by the few of them that are the nearest to
/// what has changed, by steps from contact to contact: they do not even while all others stand
/// still.
/// @param changed  any objects, bodies of the part or not.
/// @return not balanced, without forces; `solved` is false where these few stand so.
PartForces disproof_by_few(const FreeBodies& part, std::span<const ObjectId> changed,
                           double clearance);

}  // namespace trivet
