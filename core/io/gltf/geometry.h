// Triangles of a glTF asset. Private: exposes the JSON library.
#pragma once

#include <vector>

#include "core/io/gltf/document.h"

namespace trivet {

/// Fills mesh, face_material, corner_normals, materials, num_nodes and notes of `model` by what is
/// below these nodes. The asset is plain (plain_gltf). Skins and morph targets are at rest.
///
/// Positions are float32 of the file times the product of the float32 node matrices, in double, in
/// a fixed order: other programs that do the same get the same bits.
///
/// @throws Error (BadInput): no triangle, more than the limit; with the mesh and the primitive,
/// data
///   that is not there, ids out of range, coordinates that are not finite or beyond 1e30.
void read_gltf_geometry(const GltfDocument& document, const std::vector<int>& roots,
                        const ImportLimits& limits, Model& model);

}  // namespace trivet
