// A dynamic bounding volume hierarchy over the boxes of a scene's objects: the broad phase.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/base/types.h"

namespace trivet {

/// A binary tree with one leaf per slot, height-balanced as an AVL tree [Adelson-Velsky, Landis
/// 1962]: at most 1.44 log2 n levels in whatever order boxes come. Insertion descends by the growth
/// of surface areas; rotations that keep the balance shrink them further [Kopta 2012].
///
/// No answer depends on the shape of the tree: boxes are united exactly, and callers sort what they
/// visit. Only reserve() allocates, so that a rollback cannot fail. Const functions are pure.
class ObjectTree {
 public:
  /// Extent of one box or of all below a node.
  struct Extent {
    Aabb box;                              // empty: overlaps nothing
    double smallest_diagonal = kInfinity;  // metres, > 0; infinity: there is none
    double leaning_reach = 0;  // metres, largest size of an object that leans; 0: there is none
    double coarse_size = 0;    // metres, largest coarse_size() of an object; 0: there is none

    void unite(const Extent& other);
  };

  /// Makes room for slots 0 to num_slots - 1. Strong guarantee.
  void reserve(size_t num_slots);
  /// Inserts a leaf, or moves it. A box with a NaN counts as empty. Cost O(log n).
  void set(Index slot, const Extent& extent) noexcept;
  /// Removes the leaf if there is one. Cost O(log n).
  void erase(Index slot) noexcept;

  bool contains(Index slot) const { return m_nodes[leaf_of(slot)].height >= 0; }
  const Extent& at(Index slot) const { return m_nodes[leaf_of(slot)].extent; }
  /// Extent of all leaves.
  Extent extent() const;
  /// Extent of all leaves but these; slots without a leaf are ignored. Cost O(k log n log(k log
  /// n)).
  Extent extent_without(std::span<const Index> slots) const;

  /// Calls visitor(slot) for every leaf whose extent is accepted, in an order that means nothing.
  /// @param accepts  decides on an Extent; accepting one implies accepting all that hold it.
  template <class Accepts, class Visitor>
  void visit(const Accepts& accepts, const Visitor& visitor) const;

  int height() const { return m_root < 0 ? -1 : m_nodes[m_root].height; }
  /// Deep validator, for tests. Cost O(n).
  bool is_valid() const;

 private:
  struct Node {
    Extent extent;
    Index parent = -1;  // of an inner node that is not in use: the next such node
    std::array<Index, 2> child{-1, -1};
    int height = -1;  // 0: leaf; -1: not in use
  };
  static constexpr int kMaxHeight = 64;  // of any tree whose slots Index can number
  static Index leaf_of(Index slot) { return 2 * slot; }

  void insert(Index leaf) noexcept;
  Index sibling_for(const Aabb& box) const noexcept;
  void replace_child(Index parent, Index old_child, Index new_child) noexcept;
  void set_child(Index parent, int which, Index child) noexcept;
  void update(Index inner) noexcept;
  void refit_from(Index inner) noexcept;
  Index balanced(Index inner) noexcept;
  void shrink_children(Index inner) noexcept;
  double gain_of_exchange(Index inner, int side, int k) const noexcept;
  bool is_valid_below(Index node, Index parent, int& num_inner) const;

  std::vector<Node> m_nodes;  // 2 per slot: its leaf, and an inner node for any use
  Index m_root = -1, m_free = -1;
};

template <class Accepts, class Visitor>
void ObjectTree::visit(const Accepts& accepts, const Visitor& visitor) const {
  if (m_root < 0) return;
  std::array<Index, kMaxHeight + 1> stack{m_root};
  for (int size = 1; size > 0;) {
    const Index id = stack[--size];
    const Node& node = m_nodes[id];
    if (!accepts(node.extent)) continue;
    if (node.height == 0) {
      visitor(id / 2);
    } else {
      stack[size++] = node.child[1];
      stack[size++] = node.child[0];
    }
  }
}

}  // namespace trivet
