// Meshes of assimp as primitives of glTF. Private: it shows assimp and the JSON library.
#pragma once

#include <assimp/mesh.h>

#include "core/io/gltf/builder.h"
#include "core/io/gltf/row_set.h"

namespace trivet {

/// Points and lines are left out.
bool has_triangles(const aiMesh& mesh);

/// The triangles of a mesh with normals, texture coordinates and colours; equal corners are stored
/// once.
GltfJson primitive_of_assimp(const aiMesh& mesh, GltfBuilder& builder);

}  // namespace trivet
