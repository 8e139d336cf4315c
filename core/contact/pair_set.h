// Pairs of features that were tried: neighbouring faces share their vertices. Private.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/types.h"

namespace trivet {

/// A set of pairs of indices, by open addressing.
class PairSet {
 public:
  /// @return whether it is new.
  bool insert(Index a, Index b) {
    if (2 * (m_count + 1) > m_slots.size()) grow();
    return place((static_cast<std::uint64_t>(static_cast<std::uint32_t>(a)) << 32 |
                  static_cast<std::uint32_t>(b)) +
                 1);
  }

 private:
  static constexpr size_t kFirstSize = 64;  // a power of two, as all sizes

  bool place(std::uint64_t key) {
    const size_t mask = m_slots.size() - 1;
    size_t at = (key * 0x9e3779b97f4a7c15u >> 32) & mask;
    while (m_slots[at] != 0) {
      if (m_slots[at] == key) return false;
      at = (at + 1) & mask;
    }
    m_slots[at] = key;
    ++m_count;
    return true;
  }

  void grow() {
    std::vector<std::uint64_t> old(m_slots.empty() ? kFirstSize : 2 * m_slots.size(), 0);
    old.swap(m_slots);
    m_count = 0;
    for (const std::uint64_t key : old)
      if (key != 0) place(key);
  }

  std::vector<std::uint64_t> m_slots;  // 0: free
  size_t m_count = 0;
};

}  // namespace trivet
