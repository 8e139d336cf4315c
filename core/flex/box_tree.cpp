#include "core/flex/box_tree.h"

#include <algorithm>
#include <numeric>

namespace trivet::flex {
namespace {

constexpr int kLeafItems = 4;

}  // namespace

BoxTree::BoxTree(std::span<const Aabb> boxes) : m_boxes(boxes.begin(), boxes.end()) {
  m_items.resize(boxes.size());
  std::iota(m_items.begin(), m_items.end(), 0);
  if (!m_items.empty()) split(0, static_cast<int>(m_items.size()));
}

void BoxTree::split(int first, int last) {
  const size_t id = m_nodes.size();
  m_nodes.emplace_back();
  // The node holds all boxes of its items; their centres tell where to cut.
  Aabb box, centres;
  for (int i = first; i < last; ++i) {
    box.extend(m_boxes[m_items[i]]);
    centres.extend(m_boxes[m_items[i]].centre());
  }
  m_nodes[id] = {box, first, last - first};
  if (last - first <= kLeafItems) return;
  // Items are halved along the widest direction of their centres, ties by number: the same tree on
  // every machine.
  int axis = 0;
  (centres.upper - centres.lower).maxCoeff(&axis);
  const int middle = (first + last) / 2;
  const auto centre = [&](int item) {
    return m_boxes[item].lower[axis] + m_boxes[item].upper[axis];
  };
  std::nth_element(
      m_items.begin() + first, m_items.begin() + middle, m_items.begin() + last,
      [&](int a, int b) { return centre(a) != centre(b) ? centre(a) < centre(b) : a < b; });
  // The first child follows its parent; the second one's place is known when the first is whole.
  split(first, middle);
  m_nodes[id].second = static_cast<int>(m_nodes.size());
  m_nodes[id].count = 0;
  split(middle, last);
}

void BoxTree::refit(std::span<const Aabb> boxes) {
  m_boxes.assign(boxes.begin(), boxes.end());
  // Children come behind their parents, so that one pass from the end fits all boxes anew.
  for (size_t i = m_nodes.size(); i-- > 0;) {
    Node& node = m_nodes[i];
    node.box = {};
    for (int k = node.second; k < node.second + node.count; ++k)
      node.box.extend(m_boxes[m_items[k]]);
    if (node.count > 0) continue;
    node.box.extend(m_nodes[i + 1].box);
    node.box.extend(m_nodes[node.second].box);
  }
}

}  // namespace trivet::flex
