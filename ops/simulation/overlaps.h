// Private. Which convex parts of a scene for simulators overlap.
#pragma once

#include "ops/simulation/simulation.h"

namespace trivet {

/// Of every two bodies that are not both fixed, and of each free body and the floor; deepest first.
std::vector<PartOverlap> part_overlaps(const SimulationScene& scene);

}  // namespace trivet
