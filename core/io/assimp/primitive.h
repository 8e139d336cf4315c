// Meshes of assimp as primitives of glTF. Private: it shows assimp and the JSON library.
#pragma once

#include <assimp/mesh.h>

#include <cmath>

#include "core/io/gltf/builder.h"

namespace trivet {

/// Points and lines are left out.
bool has_triangles(const aiMesh& mesh);

/// The triangles of a mesh with normals, texture coordinates and colours; equal corners are stored
/// once. @param normals_count  false: smooth normals take the place of the file's.
GltfJson primitive_of_assimp(const aiMesh& mesh, bool normals_count, GltfBuilder& builder);

inline float finite_or_zero(float value) { return std::isfinite(value) ? value : 0; }

}  // namespace trivet
