#include "core/scene/slot_chains.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace trivet {

void SlotChains::reserve(size_t num_slots) {
  if (m_items.size() < num_slots) m_items.resize(num_slots);
  if (num_slots <= m_heads.size()) return;
  std::vector<Index> heads(std::bit_ceil(num_slots), -1);
  m_heads.swap(heads);
  for (size_t slot = 0; slot < m_items.size(); ++slot)
    if (m_items[slot].in_chain) push(static_cast<Index>(slot));
}

void SlotChains::set(Index slot, std::uint64_t hash) noexcept {
  Item& item = m_items[slot];
  if (item.in_chain && item.hash == hash) return;
  erase(slot);
  item.hash = hash;
  item.in_chain = true;
  push(slot);
}

void SlotChains::push(Index slot) noexcept {
  Item& item = m_items[slot];
  Index& head = m_heads[bucket(item.hash)];
  item.previous = -1;
  item.next = head;
  if (head >= 0) m_items[head].previous = slot;
  head = slot;
}

void SlotChains::erase(Index slot) noexcept {
  Item& item = m_items[slot];
  if (!item.in_chain) return;
  (item.previous < 0 ? m_heads[bucket(item.hash)] : m_items[item.previous].next) = item.next;
  if (item.next >= 0) m_items[item.next].previous = item.previous;
  item = {};
}

void SlotSet::reserve(size_t num_slots) {
  size_t num_words = std::max<size_t>(1, (num_slots + 63) / 64);
  for (size_t level = 0;; ++level, num_words = (num_words + 63) / 64) {
    if (level == m_levels.size()) {
      // A new top level sums up the one below, which had a single word until now.
      std::vector<std::uint64_t> words(num_words);
      if (level > 0 && m_levels[level - 1][0] != 0) words[0] = 1;
      m_levels.push_back(std::move(words));
    } else if (m_levels[level].size() < num_words) {
      m_levels[level].resize(num_words);
    }
    if (num_words <= 1) return;
  }
}

void SlotSet::insert(Index slot) noexcept {
  size_t bit = slot;
  for (std::vector<std::uint64_t>& words : m_levels) {
    words[bit / 64] |= std::uint64_t{1} << bit % 64;
    bit /= 64;
  }
}

void SlotSet::erase(Index slot) noexcept {
  size_t bit = slot;
  for (std::vector<std::uint64_t>& words : m_levels) {
    words[bit / 64] &= ~(std::uint64_t{1} << bit % 64);
    if (words[bit / 64] != 0) return;
    bit /= 64;
  }
}

Index SlotSet::first() const noexcept {
  if (m_levels.empty() || m_levels.back()[0] == 0) return -1;
  size_t at = 0;
  for (auto level = m_levels.rbegin(); level != m_levels.rend(); ++level)
    at = 64 * at + std::countr_zero((*level)[at]);
  return static_cast<Index>(at);
}

}  // namespace trivet
