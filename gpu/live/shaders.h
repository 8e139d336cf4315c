// Private to gpu: the shaders of live views, GLSL 3.30. Positions are in the picture frame.
#pragma once

#include <string>

#include "gpu/picture/shaders.h"

namespace trivet::live_shaders {

std::string object_vertex(picture_shaders::Surfaces surfaces);
std::string object_fragment(picture_shaders::Surfaces surfaces);
std::string empty_fragment();
/// Shadows of textured objects: nothing where they are cut out.
std::string cut_fragment();
std::string floor_vertex();
std::string floor_fragment();
std::string backdrop_fragment();
std::string mask_fragment();
std::string outline_fragment();
std::string overlay_vertex();
std::string overlay_fragment();

}  // namespace trivet::live_shaders
