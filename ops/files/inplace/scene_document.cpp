#include "ops/files/inplace/scene_document.h"

#include <algorithm>

#include "core/base/error.h"

namespace trivet {
namespace {

[[noreturn]] void fail(const Sentence& reason) { throw Error(Error::Kind::BadInput, reason); }

const GltfJson& node_at(const GltfJson& root, int node) {
  return element(root, "nodes", GltfJson(static_cast<unsigned>(node)));
}

bool has_mesh(const GltfJson& root, int node) { return node_at(root, node).contains("mesh"); }

// A group: it has a mesh, or its children with meshes have none below them.
bool is_group(const GltfJson& root, const NodeTree& tree, int node) {
  if (has_mesh(root, node)) return true;
  for (const int child : tree.nodes[static_cast<size_t>(node)].children)
    for (const int below : tree.nodes[static_cast<size_t>(child)].children)
      if (tree.nodes[static_cast<size_t>(below)].has_mesh_below) return false;
  return true;
}

// Skips nodes into which exporters put the whole scene.
std::vector<int> without_wrappers(const GltfJson& root, const NodeTree& tree) {
  std::vector<int> level = tree.roots;
  while (true) {
    std::vector<int> shown;
    for (const int node : level)
      if (tree.nodes[static_cast<size_t>(node)].has_mesh_below) shown.push_back(node);
    if (shown.size() != 1 || has_mesh(root, shown.front())) return shown;
    const std::vector<int>& below = tree.nodes[static_cast<size_t>(shown.front())].children;
    // A wrapper has several things in it, or one that has.
    level = below;
  }
}

}  // namespace

NodeTree node_tree(const GltfJson& root) {
  NodeTree tree;
  tree.nodes.resize(member(root, "nodes").size());
  tree.roots = scene_roots(root);
  std::vector<bool> seen(tree.nodes.size(), false);
  std::vector<int> stack(tree.roots.rbegin(), tree.roots.rend());
  while (!stack.empty()) {
    const int node = stack.back();
    stack.pop_back();
    if (seen[static_cast<size_t>(node)]) fail("its nodes are no tree");
    seen[static_cast<size_t>(node)] = true;
    tree.order.push_back(node);
    TreeNode& entry = tree.nodes[static_cast<size_t>(node)];
    entry.world = local_transform(node_at(root, node));
    if (entry.parent >= 0)
      entry.world = composed(tree.nodes[static_cast<size_t>(entry.parent)].world, entry.world);
    for (const GltfJson& child : member(node_at(root, node), "children")) {
      const int id = static_cast<int>(index_from(child));
      node_at(root, id);
      entry.children.push_back(id);
      tree.nodes[static_cast<size_t>(id)].parent = node;
    }
    stack.insert(stack.end(), entry.children.rbegin(), entry.children.rend());
  }
  for (auto it = tree.order.rbegin(); it != tree.order.rend(); ++it) {
    TreeNode& entry = tree.nodes[static_cast<size_t>(*it)];
    entry.has_mesh_below |= has_mesh(root, *it);
    if (entry.parent >= 0)
      tree.nodes[static_cast<size_t>(entry.parent)].has_mesh_below |= entry.has_mesh_below;
  }
  return tree;
}

std::vector<int> object_nodes(const GltfJson& root, const NodeTree& tree, SceneRule rule) {
  if (rule == SceneRule::Roots) return without_wrappers(root, tree);
  std::vector<int> out;
  if (rule == SceneRule::Meshes) {
    for (const int node : tree.order)
      if (has_mesh(root, node)) out.push_back(node);
    return out;
  }
  std::vector<int> stack(tree.roots.rbegin(), tree.roots.rend());
  while (!stack.empty()) {
    const int node = stack.back();
    stack.pop_back();
    const TreeNode& entry = tree.nodes[static_cast<size_t>(node)];
    if (!entry.has_mesh_below) continue;
    if (is_group(root, tree, node))
      out.push_back(node);
    else
      stack.insert(stack.end(), entry.children.rbegin(), entry.children.rend());
  }
  return out;
}

std::set<int> animated_nodes(const GltfJson& root) {
  std::set<int> out;
  for (const GltfJson& animation : member(root, "animations"))
    for (const GltfJson& channel : member(animation, "channels")) {
      const GltfJson& target = member(channel, "target");
      if (const GltfJson& node = member(target, "node");
          !node.is_null() && member(target, "path") != "weights")
        out.insert(static_cast<int>(index_from(node)));
    }
  return out;
}

}  // namespace trivet
