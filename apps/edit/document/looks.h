// How objects are shown in this window: hidden, not selectable, in a colour. Not part of the scene:
// neither undone nor saved.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "core/scene/support.h"

namespace trivet::edit {

using LookColour = std::array<float, 3>;  // sRGB, 0 to 1

struct Look {
  bool hidden = false;          // still in the scene: others touch it
  bool not_selectable = false;  // tools pass through it, but PUT puts on it
  std::optional<LookColour> colour;
  friend bool operator==(const Look&, const Look&) = default;
};

class Looks {
 public:
  /// The default one unless it was changed.
  Look of(ObjectId id) const;
  void change(ObjectId id, const Look& look);
  std::vector<ObjectId> hidden() const;
  /// The hidden ones, too.
  std::vector<ObjectId> not_selectable() const;
  friend bool operator==(const Looks&, const Looks&) = default;

 private:
  using Key = std::pair<std::uint32_t, std::uint32_t>;  // slot, generation
  std::map<Key, Look> m_looks;
};

}  // namespace trivet::edit
