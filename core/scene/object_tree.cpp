#include "core/scene/object_tree.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace trivet {
namespace {

// Half the surface; 0 when empty.
double area(const Aabb& box) {
  if (box.empty()) return 0;
  const Vec3 d = box.upper - box.lower;
  return d.x() * d.y() + d.y() * d.z() + d.z() * d.x();
}

Aabb united(Aabb a, const Aabb& b) {
  a.extend(b);
  return a;
}

// Twice the distance of the centres, along the axes.
double distance(const Aabb& a, const Aabb& b) {
  return (a.lower + a.upper - b.lower - b.upper).cwiseAbs().sum();
}

// One bit pattern per box: unions do not depend on their order even in the sign of zero.
Aabb normalised(const Aabb& box) {
  if (box.empty()) return {};
  return {box.lower.array() + 0.0, box.upper.array() + 0.0};
}

bool same(const ObjectTree::Extent& a, const ObjectTree::Extent& b) {
  return a.box.lower == b.box.lower && a.box.upper == b.box.upper &&
         a.smallest_diagonal == b.smallest_diagonal && a.leaning_reach == b.leaning_reach &&
         a.coarse_size == b.coarse_size;
}

}  // namespace

void ObjectTree::Extent::unite(const Extent& other) {
  box.extend(other.box);
  smallest_diagonal = std::min(smallest_diagonal, other.smallest_diagonal);
  leaning_reach = std::max(leaning_reach, other.leaning_reach);
  coarse_size = std::max(coarse_size, other.coarse_size);
}

void ObjectTree::reserve(size_t num_slots) {
  const size_t before = m_nodes.size();
  // Room is made before anything is inserted, so that inserting never allocates.
  if (before >= 2 * num_slots) return;
  m_nodes.resize(2 * num_slots);
  for (size_t inner = before + 1; inner < m_nodes.size(); inner += 2)
    m_nodes[inner].parent = std::exchange(m_free, static_cast<Index>(inner));
}

void ObjectTree::set(Index slot, const Extent& extent) noexcept {
  const Extent now{normalised(extent.box),
                   extent.smallest_diagonal > 0 ? extent.smallest_diagonal : kInfinity,
                   extent.leaning_reach, extent.coarse_size};
  Node& leaf = m_nodes[leaf_of(slot)];
  // An object that did not move costs nothing.
  if (leaf.height == 0 && same(leaf.extent, now)) return;
  erase(slot);
  leaf.extent = now;
  insert(leaf_of(slot));
}

void ObjectTree::insert(Index leaf) noexcept {
  m_nodes[leaf].height = 0;
  m_nodes[leaf].parent = -1;
  if (m_root < 0) {
    m_root = leaf;
    return;
  }
  // The leaf joins the sibling whose box grows least by it.
  const Index sibling = sibling_for(m_nodes[leaf].extent.box);
  const Index inner = std::exchange(m_free, m_nodes[m_free].parent);
  replace_child(m_nodes[sibling].parent, sibling, inner);
  set_child(inner, 0, sibling);
  set_child(inner, 1, leaf);
  refit_from(inner);
}

// Always a leaf: the tree stays balanced then by single rotations.
Index ObjectTree::sibling_for(const Aabb& box) const noexcept {
  Index at = m_root;
  while (m_nodes[at].height > 0) {
    const auto cost = [&](Index child) {
      const Aabb& there = m_nodes[child].extent.box;
      return std::make_pair(area(united(there, box)) - area(there), distance(there, box));
    };
    const auto& child = m_nodes[at].child;
    at = cost(child[1]) < cost(child[0]) ? child[1] : child[0];
  }
  return at;
}

void ObjectTree::erase(Index slot) noexcept {
  Node& leaf = m_nodes[leaf_of(slot)];
  if (leaf.height < 0) return;
  leaf.height = -1;
  leaf.extent = {};
  const Index parent = std::exchange(leaf.parent, -1);
  if (parent < 0) {
    m_root = -1;
    return;
  }
  // The sibling takes the place of the parent, which becomes free.
  const auto& child = m_nodes[parent].child;
  const Index sibling = child[child[0] == leaf_of(slot) ? 1 : 0];
  const Index above = m_nodes[parent].parent;
  replace_child(above, parent, sibling);
  m_nodes[parent] = {};
  m_nodes[parent].parent = std::exchange(m_free, parent);
  refit_from(above);
}

void ObjectTree::set_child(Index parent, int which, Index child) noexcept {
  m_nodes[parent].child[which] = child;
  m_nodes[child].parent = parent;
}

// @param parent  -1: `old_child` is the root.
void ObjectTree::replace_child(Index parent, Index old_child, Index new_child) noexcept {
  if (parent < 0) {
    m_root = new_child;
    m_nodes[new_child].parent = -1;
  } else {
    set_child(parent, m_nodes[parent].child[0] == old_child ? 0 : 1, new_child);
  }
}

void ObjectTree::update(Index inner) noexcept {
  Node& node = m_nodes[inner];
  const Node &a = m_nodes[node.child[0]], &b = m_nodes[node.child[1]];
  node.height = 1 + std::max(a.height, b.height);
  node.extent = a.extent;
  node.extent.unite(b.extent);
}

void ObjectTree::refit_from(Index inner) noexcept {
  while (inner >= 0) {
    // Every node on the way up is balanced, renewed and shrunk.
    inner = balanced(inner);
    update(inner);
    shrink_children(inner);
    inner = m_nodes[inner].parent;
  }
}

// Lifts the taller child where one is taller by two: with its taller child it takes the node's
// place, its other child comes below the node. The order of children means nothing, so that double
// rotations are never needed.
// @return the node that is there now.
Index ObjectTree::balanced(Index inner) noexcept {
  const auto height = [&](Index node) { return m_nodes[node].height; };
  const auto [a, b] = m_nodes[inner].child;
  if (std::abs(height(a) - height(b)) < 2) return inner;
  const int tall = height(b) > height(a) ? 1 : 0;
  const Index up = tall ? b : a, low = tall ? a : b;
  // One grandchild goes below the node in place of the lifted child: the lower one, or at equal
  // heights the one that makes the smaller box there.
  auto [stays, goes] = m_nodes[up].child;
  const auto area_with_low = [&](Index node) {
    return area(united(m_nodes[low].extent.box, m_nodes[node].extent.box));
  };
  if (height(goes) > height(stays) ||
      (height(goes) == height(stays) && area_with_low(stays) < area_with_low(goes)))
    std::swap(stays, goes);
  replace_child(m_nodes[inner].parent, inner, up);
  set_child(inner, tall, goes);
  update(inner);
  set_child(up, 0, inner);
  set_child(up, 1, stays);
  return up;
}

// Exchanges a child with a child of the other where that makes the other's box smallest, as long as
// all heights stay balanced and the node keeps its own.
void ObjectTree::shrink_children(Index inner) noexcept {
  double best_gain = 0;
  // The best of four exchanges is taken, if any makes a box smaller.
  int best_side = 0, best_grandchild = 0;
  for (int side = 0; side < 2; ++side)
    for (int k = 0; k < 2; ++k)
      if (const double gain = gain_of_exchange(inner, side, k); gain > best_gain)
        best_gain = gain, best_side = side, best_grandchild = k;
  if (!(best_gain > 0)) return;
  const Index alone = m_nodes[inner].child[best_side];
  const Index other = m_nodes[inner].child[1 - best_side];
  set_child(inner, best_side, m_nodes[other].child[best_grandchild]);
  set_child(other, best_grandchild, alone);
  update(other);
}

// Surface gained when a child comes below the other in exchange for that one's child k; 0: it may
// not.
double ObjectTree::gain_of_exchange(Index inner, int side, int k) const noexcept {
  const Node& alone = m_nodes[m_nodes[inner].child[side]];
  const Node& other = m_nodes[m_nodes[inner].child[1 - side]];
  if (other.height == 0) return 0;
  const Node &comes = m_nodes[other.child[k]], &remains = m_nodes[other.child[1 - k]];
  // The exchange may change no height by more than the tree allows.
  const int height = 1 + std::max(alone.height, remains.height);
  const bool balanced = std::abs(alone.height - remains.height) < 2 &&
                        std::abs(comes.height - height) < 2 &&
                        1 + std::max(comes.height, height) == m_nodes[inner].height;
  if (!balanced) return 0;
  return area(other.extent.box) - area(united(alone.extent.box, remains.extent.box));
}

ObjectTree::Extent ObjectTree::extent() const {
  return m_root < 0 ? Extent{} : m_nodes[m_root].extent;
}

ObjectTree::Extent ObjectTree::extent_without(std::span<const Index> slots) const {
  std::vector<Index> opened;  // nodes with something below that does not count
  for (const Index slot : slots)
    if (contains(slot))
      for (Index node = leaf_of(slot); node >= 0; node = m_nodes[node].parent)
        opened.push_back(node);
  if (opened.empty()) return extent();
  std::sort(opened.begin(), opened.end());
  opened.erase(std::unique(opened.begin(), opened.end()), opened.end());
  // Opened nodes are replaced by their children that do count; all others count as a whole.
  Extent out;
  for (const Index node : opened)
    if (m_nodes[node].height > 0)
      for (const Index child : m_nodes[node].child)
        if (!std::binary_search(opened.begin(), opened.end(), child))
          out.unite(m_nodes[child].extent);
  return out;
}

bool ObjectTree::is_valid() const {
  int num_inner = 0;
  if (m_root >= 0 && !is_valid_below(m_root, -1, num_inner)) return false;
  size_t num_leaves = 0, num_free = 0;
  for (size_t leaf = 0; leaf < m_nodes.size(); leaf += 2) num_leaves += m_nodes[leaf].height == 0;
  for (Index node = m_free; node >= 0; node = m_nodes[node].parent) ++num_free;
  return static_cast<size_t>(num_inner) == std::max<size_t>(num_leaves, 1) - 1 &&
         num_free + num_inner == m_nodes.size() / 2;
}

bool ObjectTree::is_valid_below(Index id, Index parent, int& num_inner) const {
  const Node& node = m_nodes[id];
  if (node.parent != parent || node.height < 0) return false;
  if (node.height == 0) return id % 2 == 0;
  const Node &a = m_nodes[node.child[0]], &b = m_nodes[node.child[1]];
  Extent both = a.extent;
  both.unite(b.extent);
  ++num_inner;
  return id % 2 == 1 && same(node.extent, both) &&
         node.height == 1 + std::max(a.height, b.height) && std::abs(a.height - b.height) < 2 &&
         is_valid_below(node.child[0], id, num_inner) &&
         is_valid_below(node.child[1], id, num_inner);
}

}  // namespace trivet
