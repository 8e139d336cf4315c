// Values of the nodes that were met last. Private.
#pragma once

#include <array>
#include <optional>

#include "core/base/types.h"

namespace trivet {

/// Values of nodes of one body in several pairs of bodies: a traversal meets most nodes many times.
template <class Value, size_t kNumSlots>
class RecentNodes {
 public:
  /// The value of a node, constructed from `args` unless it is still there.
  /// @param pair  number of the pair of bodies, not negative.
  /// @return valid until the next call.
  template <class... Args>
  const Value& get(Index pair, Index node, const Args&... args) {
    Slot& slot = m_slots[static_cast<size_t>(node) % kNumSlots];
    if (slot.node != node || slot.pair != pair) {
      slot.value.emplace(args...);
      slot.node = node;
      slot.pair = pair;
    }
    return *slot.value;
  }

 private:
  struct Slot {
    Index pair = -1, node = -1;
    std::optional<Value> value;
  };
  std::array<Slot, kNumSlots> m_slots;
};

}  // namespace trivet
