// A tree of boxes in double that follows what moves.
#pragma once

#include <span>
#include <vector>

#include "core/base/types.h"

namespace trivet::flex {

inline void grow(Aabb& box, double by) {
  box.lower.array() -= by;
  box.upper.array() += by;
}

/// Median splits along the longest side of the boxes' centres. The same whatever the order of
/// visits.
class BoxTree {
 public:
  BoxTree() = default;
  explicit BoxTree(std::span<const Aabb> boxes);
  /// New boxes in the same tree.
  void refit(std::span<const Aabb> boxes);
  /// Calls visit(item) for all items whose box meets `box`, closed, in the tree's order.
  template <class Visit>
  void visit(const Aabb& box, const Visit& call) const {
    if (m_nodes.empty()) return;
    // A median split halves the count at each level: a depth of 64 is never reached.
    int stack[64], depth = 0;
    stack[depth++] = 0;
    while (depth > 0) {
      const Node& node = m_nodes[stack[--depth]];
      if (!overlaps(node.box, box)) continue;
      // The first child lies behind its parent in memory; it is visited first.
      if (node.count == 0) {
        stack[depth++] = node.second;
        stack[depth++] = static_cast<int>(&node - m_nodes.data()) + 1;
      }
      for (int i = node.second; i < node.second + node.count; ++i)
        if (overlaps(m_boxes[m_items[i]], box)) call(m_items[i]);
    }
  }

 private:
  struct Node {
    Aabb box;
    int second = 0;  // child, or the first item
    int count = 0;   // of a leaf's items; 0: an inner node, whose first child follows it
  };
  void split(int first, int last);

  std::vector<Node> m_nodes;
  std::vector<int> m_items;
  std::vector<Aabb> m_boxes;
};

}  // namespace trivet::flex
