// Private to gpu: the shaders of pictures, GLSL 3.30.
//
// Once: `floor_light` measures the light on the floor around the objects. Per sub-pixel view:
// `shadow` draws the depth of all casters from each light, `surface` draws the camera's view into a
// G-buffer, `light` shades it, and the floor, and adds the result to the sum; `develop` turns the
// sum into sRGB over the background.
#pragma once

#include <string>

namespace trivet::picture_shaders {

inline std::string version() { return "#version 330 core\n"; }
/// Largest distance of a smooth surface outside its triangles, frame.
inline std::string max_bulge() { return "const float kMaxBulge = 0.0025;\n"; }

/// Shaders of textured meshes differ from those of others.
enum class Surfaces { Plain, Textured };

/// Vertex inputs of an UploadedMesh, for every shader that draws one; for textured ones with
/// pass_details(), to be called with the placing matrix.
std::string mesh_inputs(Surfaces surfaces = Surfaces::Plain);
/// For fragment shaders of textured meshes: textured_base(), is_discarded(), textured_polish(),
/// textured_emission(), bent_normal().
std::string surface_details();
/// place_in_map(): where a point is in a shadow map.
std::string shadow_lookup();
/// film() bends what is too bright below white; srgb_from_linear().
std::string tone();

std::string surface_vertex(Surfaces surfaces);
/// @param see_through  discards pixels at random by 1 - alpha, so that views average to alpha.
std::string surface_fragment(bool see_through, Surfaces surfaces);
std::string shadow_vertex(Surfaces surfaces = Surfaces::Plain);
std::string shadow_fragment(bool see_through, Surfaces surfaces = Surfaces::Plain);
std::string whole_target_vertex();  // a triangle that covers the target
std::string floor_light_fragment();
/// @param emits  adds the light of surfaces.
std::string light_fragment(bool emits);
std::string develop_fragment();

}  // namespace trivet::picture_shaders
