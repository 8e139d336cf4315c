// Names the bodies that make a part fall. Private.
#pragma once

#include <vector>

#include "ops/stability/contact_forces.h"

namespace trivet {

/// Bodies that topple even while all others of the part stand still: among those that move fastest
/// in the motion that proves that it does not stand. The motion of many bodies mostly begins with a
/// few that push the others, or fall from them. Where no few do, all that move.
/// @param forces  of the part, not balanced.
std::vector<Index> fewest_movers(const FreeBodies& part, double clearance,
                                 const PartForces& forces);

}  // namespace trivet
