// Corners on which a body stands on the floor, for simulators that find too few of them.
#pragma once

#include <vector>

#include "core/io/simulators/simulation_scene.h"

namespace trivet {

/// Corners of the support polygon: vertices of convex parts within a thousandth of the body's size
/// of its lowest one, the farthest of them in each of 16 directions of the plane. Empty for a body
/// that does not reach the floor at z = 0.
/// @return world frame, metres; at most 16, all different, in the order of the directions.
std::vector<Vec3> floor_corners(const SimulationModel& model, const Pose& world_from_link);

/// Ends of the edges on which convex parts stand on the floor: of each part whose vertices up to
/// z = `reach` are several on a line the outer two.
/// @param reach  metres.
/// @return world frame, metres; all different, in the order of the parts.
std::vector<Vec3> floor_edge_ends(const SimulationModel& model, const Pose& world_from_link,
                                  double reach);

}  // namespace trivet
