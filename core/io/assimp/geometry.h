// Triangles of an assimp scene: all nodes, in the object frame.
#pragma once

#include <string>

#include "core/io/read_model.h"
#include "core/model/model.h"

struct aiScene;

namespace trivet {

/// Indices must be in range (check_faces). Fills mesh, face_material, corner_normals, num_nodes and
/// notes of `model`. Reads model.format.
///
/// Positions are float32 of the file times the product of the float32 node matrices, in double, in
/// a fixed order: other programs that read the file with assimp can reproduce them bit for bit.
///
/// @throws Error (BadInput): no triangle, more triangles than the limit, a coordinate that is not
///   finite or beyond 1e30.
void read_geometry(const aiScene& scene, const ImportLimits& limits, Model& model);

}  // namespace trivet
