// Private. Which convex parts of a scene for simulators overlap.
#pragma once

#include <functional>

#include "ops/simulation/simulation.h"

namespace trivet {

/// Overlaps of every two bodies that are not both fixed, and of each free body and the floor;
/// deepest first.
/// @param limit  of two bodies, metres; of the floor: of a body twice.
std::vector<PartOverlap> part_overlaps(const SimulationScene& scene,
                                       const std::function<double(size_t, size_t)>& limit);

/// Pairs of parts whose boxes come nearer than a thousandth of the scene's size, the floor
/// included.
size_t num_near_parts(const SimulationScene& scene);

}  // namespace trivet
