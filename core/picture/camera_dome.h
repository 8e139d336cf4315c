// Cameras all around a scene.
#pragma once

#include <cstdint>
#include <vector>

#include "core/picture/scene.h"

namespace trivet {

struct DomeOptions {
  int count = 1;                             // cameras
  std::uint64_t seed = 1;                    // another seed, other cameras
  double radius = 0;                         // metres from the scene's middle; 0: all of it is seen
  double lowest_deg = 15, highest_deg = 75;  // elevations, -90 to 90
  double fov_deg = 30;                       // from the lower to the upper edge, 1 to 170
};

/// Cameras on a sphere about the middle of the scene, looking there: even by area between two
/// elevations, the same bits for a seed on any machine; the first k of them are those of count k.
/// @param aspect  width / height of the pictures.
/// @throws Error (BadInput) naming the option that is out of range.
std::vector<Camera> camera_dome(const PictureScene& scene, double aspect,
                                const DomeOptions& options);

}  // namespace trivet
