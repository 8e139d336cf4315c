// Base colours of surfaces for files that know one image a material, and nothing of transforms.
#pragma once

#include <array>
#include <string>

#include "core/io/textures/surface_look.h"

namespace trivet {

/// The image times a colour, linear, as a PNG file. @param opaque  alpha is left out.
std::string base_colour_png(const TextureImage& image, const std::array<float, 3>& colour,
                            bool opaque);

/// Where the image is looked up, v from below, as OBJ, PLY and USD count.
Eigen::Vector2f upward_coordinates(const TextureUse& use, const Eigen::Vector2f& uv);

}  // namespace trivet
