// Sideways relations that poses mean: what stands beside what, and what leans on what.
#pragma once

#include <vector>

#include "ops/mend/intent.h"

namespace trivet {

/// Objects that an object meets sideways, in the scene's order: within the tolerance of the intent,
/// and neither its support, nor its container, nor on it or in it.
struct IntendedNeighbours {
  std::vector<ObjectId> beside;
  std::vector<ObjectId> leans_on;  // on the side to which it would tip; it is not level
};

/// @param o  an object of the intent. Cost: eight exact tests of a shifted pose.
IntendedNeighbours intended_neighbours(const Scene& scene, const Intent& intent,
                                       const ObjectIntent& o);

}  // namespace trivet
