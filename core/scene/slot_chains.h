// Slots found by the hash of what is in them, and the first slot with nothing in it.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/types.h"

namespace trivet {

/// A hash table whose chains run through arrays with a place for every slot: only reserve()
/// allocates, so that a rollback cannot fail. The order of a chain means nothing.
class SlotChains {
 public:
  /// Makes room for slots 0 to num_slots - 1. Strong guarantee.
  void reserve(size_t num_slots);
  /// Puts the slot into the chain of this hash, out of the one that it was in.
  void set(Index slot, std::uint64_t hash) noexcept;
  /// Takes the slot out of its chain if it is in one.
  void erase(Index slot) noexcept;

  /// @param visitor  called with every slot of this hash.
  template <class Visitor>
  void visit(std::uint64_t hash, const Visitor& visitor) const {
    if (m_heads.empty()) return;
    for (Index slot = m_heads[bucket(hash)]; slot >= 0; slot = m_items[slot].next)
      if (m_items[slot].hash == hash) visitor(slot);
  }

 private:
  struct Item {
    std::uint64_t hash = 0;
    Index next = -1, previous = -1;  // previous -1: first in its chain
    bool in_chain = false;
  };
  size_t bucket(std::uint64_t hash) const { return hash & (m_heads.size() - 1); }
  void push(Index slot) noexcept;

  std::vector<Item> m_items;
  std::vector<Index> m_heads;  // a power of two
};

/// A set of slots as bits, and bits that say which words are not zero, and so on.
class SlotSet {
 public:
  /// Makes room for slots 0 to num_slots - 1. Strong guarantee.
  void reserve(size_t num_slots);
  void insert(Index slot) noexcept;
  void erase(Index slot) noexcept;
  /// The smallest; -1: the set is empty. Cost O(log n / 6).
  Index first() const noexcept;

 private:
  std::vector<std::vector<std::uint64_t>> m_levels;  // 64 words have one word in the next level
};

}  // namespace trivet
