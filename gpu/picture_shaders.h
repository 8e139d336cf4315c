// Private to gpu: the shaders of pictures, GLSL 3.30.
//
// Per sub-pixel view: `shadow` draws the depth of all casters from each light, `surface` draws what
// the camera sees into a G-buffer, `light` shades it, and the floor, and adds that to the sum;
// `develop` turns the sum into sRGB over the background.
#pragma once

#include <string>

namespace trivet::picture_shaders {

std::string surface_vertex();
/// @param see_through  drops pixels at random by 1 - alpha, so that views average to alpha.
std::string surface_fragment(bool see_through);
std::string shadow_vertex();
std::string shadow_fragment(bool see_through);
std::string whole_target_vertex();  // a triangle that covers the target
std::string light_fragment();
std::string develop_fragment();

}  // namespace trivet::picture_shaders
