// Lines along which cables start.
#pragma once

#include <vector>

#include "core/base/types.h"

namespace trivet {

double length_of(const std::vector<Vec3>& path);
/// num_segments + 1 points from end to end, evenly spaced along the path.
std::vector<Vec3> resampled(const std::vector<Vec3>& path, int num_segments);
/// A path between the same ends that has this length, or as close to it as these allow: one that is
/// too short is lifted to an arch, one that is too long pulled straight.
std::vector<Vec3> cable_path_of_length(const std::vector<Vec3>& path, double length);

}  // namespace trivet
