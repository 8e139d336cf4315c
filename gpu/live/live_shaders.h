// Private to gpu: the shaders of live views, GLSL 3.30. Positions are in the picture frame.
#pragma once

#include <string>

namespace trivet::live_shaders {

std::string object_vertex();
std::string object_fragment();
std::string empty_fragment();
std::string floor_vertex();
std::string floor_fragment();
std::string backdrop_fragment();
std::string mask_fragment();
std::string outline_fragment();
std::string overlay_vertex();
std::string overlay_fragment();

}  // namespace trivet::live_shaders
