// Polygons of an assimp scene as triangles.
#pragma once

#include <cstdint>

struct aiScene;

namespace trivet {

/// Replaces faces of more than three corners by triangles without overlap; indices must be in range
/// (check_faces). @return the number of polygons that cross themselves and became fans.
std::int64_t triangulate_polygons(aiScene& scene);

}  // namespace trivet
