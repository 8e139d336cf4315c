// Numbers with their noun, for people.
#pragma once

#include <cstddef>
#include <string>

namespace trivet {

/// "1 object", "2 objects". @param noun  one whose plural has an s.
inline std::string count_of(std::size_t count, const std::string& noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

}  // namespace trivet
