#include "core/io/gltf/instances.h"

#include <array>
#include <cmath>

#include "core/base/bad_input.h"
#include "core/base/printable.h"
#include "core/base/quoted.h"

namespace trivet {
namespace {

// As many floats as `out` has, which stays where the node does not have the member.
template <size_t N>
bool read_floats(const GltfJson& node, const char* key, std::array<float, N>& out) {
  const GltfJson& given = member(node, key);
  if (given.is_null()) return false;
  const auto wrong = [&] {
    bad_input("%1: a node's %2 has not %3 numbers", quoted(printable(name_of(node), 100)), key, N);
  };
  if (!given.is_array() || given.size() != N) wrong();
  for (size_t i = 0; i < N; ++i) {
    if (!given[i].is_number()) wrong();
    out[i] = static_cast<float>(given[i].get<double>());
  }
  return true;
}

bool is_unit(const std::array<float, 4>& q) {
  constexpr double kWithin = 1e-5;  // of the square: more than float32 and seven digits lose
  double squared = 0;
  for (const float part : q) squared += static_cast<double>(part) * static_cast<double>(part);
  return std::abs(squared - 1) <= kWithin;
}

std::array<float, 4> as_unit(const GltfJson& node, std::array<float, 4> q) {
  if (is_unit(q)) return q;
  double squared = 0;
  for (const float part : q) squared += static_cast<double>(part) * static_cast<double>(part);
  if (!(squared > 0 && std::isfinite(squared)))
    bad_input("%1: a node's rotation has no length; accepted: a quaternion of length 1",
              quoted(printable(name_of(node), 100)));
  for (float& part : q) part = static_cast<float>(static_cast<double>(part) / std::sqrt(squared));
  return q;
}

// In this order of operations, as readers in float32 do.
std::array<std::array<float, 3>, 3> rotation_of(const std::array<float, 4>& q) {
  const auto [x, y, z, w] = q;
  return {{{1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)},
           {2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)},
           {2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)}}};
}

}  // namespace

Matrix4 node_matrix(const GltfJson& node) {
  Matrix4 out = identity_matrix4();
  if (std::array<float, 16> m; read_floats(node, "matrix", m)) {
    for (size_t i = 0; i < 16; ++i) out[i % 4][i / 4] = m[i];
    if (out[3] != std::array<double, 4>{0, 0, 0, 1})
      bad_input("%1: a node's matrix has not 0 0 0 1 as its last row",
                quoted(printable(name_of(node), 100)));
    return out;
  }
  std::array<float, 3> translation{}, scale{1, 1, 1};
  std::array<float, 4> rotation{0, 0, 0, 1};
  read_floats(node, "translation", translation);
  read_floats(node, "rotation", rotation);
  read_floats(node, "scale", scale);
  const auto turned = rotation_of(as_unit(node, rotation));
  for (size_t r = 0; r < 3; ++r) {
    for (size_t c = 0; c < 3; ++c) out[r][c] = turned[r][c] * scale[c];
    out[r][3] = translation[r];
  }
  return out;
}

bool make_rotation_unit(GltfJson& node) {
  std::array<float, 4> rotation{};
  if (!read_floats(node, "rotation", rotation) || is_unit(rotation)) return false;
  node["rotation"] = as_unit(node, rotation);
  return true;
}

GltfTree gltf_tree(const GltfJson& root, const std::vector<int>& roots) {
  GltfTree tree;
  std::vector<bool> seen(member(root, "nodes").size(), false);
  std::vector<std::pair<int, Matrix4>> open;  // no recursion: a hostile file may nest deeply
  for (auto it = roots.rbegin(); it != roots.rend(); ++it)
    open.emplace_back(*it, identity_matrix4());
  while (!open.empty()) {
    const auto [id, object_from_parent] = open.back();
    open.pop_back();
    const GltfJson& node = element(root, "nodes", GltfJson(static_cast<unsigned>(id)));
    if (seen[static_cast<size_t>(id)])
      bad_input("its nodes do not form a tree: two have node %1 among their children", id);
    seen[static_cast<size_t>(id)] = true;
    const Matrix4 object_from_node = product(object_from_parent, node_matrix(node));
    tree.nodes.push_back(id);
    if (node.contains("mesh")) tree.instances.push_back({id, affine_of(object_from_node)});
    const GltfJson& children = member(node, "children");
    for (size_t i = children.size(); i-- > 0;) {
      const auto child = index_from(children[i]);
      element(root, "nodes", children[i]);
      open.emplace_back(static_cast<int>(child), object_from_node);
    }
  }
  return tree;
}

}  // namespace trivet
