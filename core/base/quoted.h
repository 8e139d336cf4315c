// Quoting of names in messages.
#pragma once

#include <string>

namespace trivet {

/// "name", with the quotes.
inline std::string quoted(const std::string& name) {
  std::string out(1, '"');
  out += name;
  return out += '"';
}

}  // namespace trivet
