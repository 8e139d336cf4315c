// Colours of faces as a whole, for views without textures.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/picture/scene.h"

namespace trivet {

/// sRGB and opacity of each face: the base colour of its material, times the mean of its texture
/// and of its vertex colours.   Cost: decoding of all images.   Thread-safe.
std::vector<std::array<std::uint8_t, 4>> face_colours(const PictureMesh& mesh);

}  // namespace trivet
