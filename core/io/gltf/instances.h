// Meshes of a glTF asset as its nodes place them. Private: exposes the JSON library.
#pragma once

#include <vector>

#include "core/io/gltf/document.h"
#include "core/io/mesh/node_product.h"

namespace trivet {

struct GltfInstance {
  int node = 0;
  Affine object_from_mesh;
};

/// The node's own transform, of the float32 values of its numbers, computed in float32. A rotation
/// of another length than 1 is brought to it.
/// @throws Error (BadInput): not of numbers, or not of as many as there have to be; a rotation of
///   length 0; a matrix whose last row is not 0 0 0 1.
Matrix4 node_matrix(const GltfJson& node);

/// Brings the node's rotation to length 1, as float32. @return false: it is not there, or has it.
bool make_rotation_unit(GltfJson& node);

struct GltfTree {
  std::vector<GltfInstance> instances;  // nodes with meshes: depth first, children in order
  std::vector<int> nodes;               // all, in the same order
};
/// The tree below these nodes, transforms included. @throws Error (BadInput): no tree.
GltfTree gltf_tree(const GltfJson& root, const std::vector<int>& roots);

}  // namespace trivet
