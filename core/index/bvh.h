// Bounding volume hierarchy (BVH): a binary tree of boxes over the triangles of one mesh, built
// once, in object space.
#pragma once

#include <vector>

#include "core/mesh/mesh.h"

namespace trivet {

/// Largest number of nodes from the root to a leaf: traversals may size their stacks by it.
inline constexpr int kMaxBvhDepth = 64;

/// Largest number of faces in a leaf.
inline constexpr Index kMaxLeafFaces = 4;

/// Node of 32 bytes. Boxes are float32, rounded outwards. Nodes are numbered depth-first: the first
/// child of an inner node is the next one.
struct BvhNode {
  std::array<float, 3> lower, upper;
  Index second_child = 0;  // inner node: id of the second child; leaf: id of the first face slot
  Index num_faces = 0;     // 0: inner node

  bool is_leaf() const { return num_faces > 0; }
  Aabb box() const {
    return {Vec3(lower[0], lower[1], lower[2]), Vec3(upper[0], upper[1], upper[2])};
  }
};

/// Slab that holds the faces of a node: lower <= normal . (p - centre of the node's box) <= upper
/// for all their points p, rounded outwards. A piece of a smooth surface is much thinner than its
/// box, whatever its orientation [Gottschalk 1996].
struct BvhSlab {
  std::array<float, 3> normal{};  // of the faces together; length 1 or a little less; 0: none
  float lower = 0, upper = 0;
};

struct Bvh {
  std::vector<BvhNode> nodes;  // empty for a mesh without triangles
  std::vector<Index> faces;    // face slots, leaf by leaf
  std::vector<BvhSlab> slabs;  // of the nodes

  size_t size_bytes() const {
    return nodes.size() * sizeof(BvhNode) + faces.size() * sizeof(Index) +
           slabs.size() * sizeof(BvhSlab);
  }
};

/// Builds by the surface-area heuristic, in bins [Wald 2007], with median splits where that would
/// go deeper than kMaxBvhDepth. Faces in a leaf ascend. The tree is the same whatever the number of
/// threads, and no answer of Trivet depends on it.
/// @throws std::bad_alloc when memory ends. Cost O(n log n), of large meshes on several cores.
/// Thread-safe.
Bvh build_bvh(const Mesh& mesh);

}  // namespace trivet
