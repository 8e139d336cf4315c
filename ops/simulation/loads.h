// Private. How heavily objects of a scene for simulators are laden.
#pragma once

#include <map>

#include "core/io/simulators/simulation_scene.h"
#include "ops/files/foreign/open_scene.h"

namespace trivet {

/// The largest mass that a free body carries, in its own masses; 0: none carries anything. What
/// lies on several bodies is shared evenly among those below it.
/// @param body_of  of the scene's objects.
double heaviest_load(const Scene& scene, const std::map<ObjectId, size_t, SlotOrder>& body_of,
                     const std::vector<SimulationBody>& bodies);

}  // namespace trivet
