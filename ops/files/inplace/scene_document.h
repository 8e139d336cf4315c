// The nodes of a glTF scene as a tree with transforms. Private: it shows the JSON library.
#pragma once

#include <set>

#include "ops/files/inplace/gltf_transform.h"
#include "ops/files/inplace/scene_objects.h"

namespace trivet {

/// A node's parent and where it is in the world of the file (y up).
struct TreeNode {
  int parent = -1;
  Affine world;
  bool has_mesh_below = false;  // or itself
  std::vector<int> children;
};

/// The tree of the scene that is shown; nodes outside have no transform and no mesh below.
/// `order` has parents before their children. @throws Error (BadInput): no tree.
struct NodeTree {
  std::vector<TreeNode> nodes;
  std::vector<int> roots, order;
};
NodeTree node_tree(const GltfJson& root);

/// The nodes that are objects by the rule, in the order of the tree.
std::vector<int> object_nodes(const GltfJson& root, const NodeTree& tree, SceneRule rule);

/// Nodes whose transforms are animated.
std::set<int> animated_nodes(const GltfJson& root);

}  // namespace trivet
