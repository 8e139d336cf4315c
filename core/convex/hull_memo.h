// Hulls that many trees of one mesh share.
#pragma once

#include <array>
#include <map>
#include <utility>
#include <vector>

#include "core/convex/hull_tree.h"

namespace trivet {

/// Remembers what HullTree made of faces of one mesh, in one frame, with one shell: the same faces
/// give the same again, so that trees of many scenes need each hull once. One thread at a time.
class HullMemo {
 public:
  using Faces = std::vector<Index>;
  using Halves = std::array<Faces, 2>;

  template <class Make>
  HullTree::Node node(const Faces& faces, const PartThickness& thickness, const Make& make) {
    return remembered(m_nodes, std::pair(thickness, faces), make);
  }
  template <class Make>
  Halves halves(const Faces& faces, const Make& make) {
    return remembered(m_halves, faces, make);
  }
  template <class Make>
  double filled_part(Index root, const Make& make) {
    return remembered(m_filled, root, make);
  }

 private:
  static constexpr std::size_t kMostKept = 4096;  // of each kind: more are forgotten at once

  template <class Key, class Value, class Make>
  static Value remembered(std::map<Key, Value>& known, const Key& key, const Make& make) {
    const auto found = known.find(key);
    if (found != known.end()) return found->second;
    Value value = make();
    if (known.size() >= kMostKept) known.clear();
    return known.emplace(key, std::move(value)).first->second;
  }

  std::map<std::pair<PartThickness, Faces>, HullTree::Node> m_nodes;
  std::map<Faces, Halves> m_halves;
  std::map<Index, double> m_filled;
};

}  // namespace trivet
