// Values of the nodes that were met last. Private.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>

#include "core/base/types.h"

namespace trivet {

/// Number of a search of two trees: no other search of this thread has it.
inline std::uint64_t new_search() {
  thread_local std::uint64_t last = 0;
  return ++last;
}

/// A Memory of RecentNodes, made once per thread: clearing one takes as long as a small query.
template <class Memory>
Memory& memory_of_thread() {
  thread_local const std::unique_ptr<Memory> memory = std::make_unique<Memory>();
  return *memory;  // NOLINT(clang-analyzer-cplusplus.NewDelete): it lives as long as the thread
}

/// Values of nodes of one body in several searches: a search meets most nodes many times.
template <class Value, size_t kNumSlots>
class RecentNodes {
 public:
  /// The value of a node, constructed from `args` unless it is still there.
  /// @param search  see new_search(). @return valid until the next call.
  template <class... Args>
  const Value& get(std::uint64_t search, Index node, const Args&... args) {
    Slot& slot = m_slots[static_cast<size_t>(node) % kNumSlots];
    if (slot.node != node || slot.search != search) {
      slot.value.emplace(args...);
      slot.node = node;
      slot.search = search;
    }
    return *slot.value;
  }

 private:
  struct Slot {
    std::uint64_t search = 0;
    Index node = -1;
    std::optional<Value> value;
  };
  std::array<Slot, kNumSlots> m_slots;
};

}  // namespace trivet
