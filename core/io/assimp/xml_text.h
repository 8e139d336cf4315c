// Elements of XML found in text, for what assimp does not tell. No parser: assimp reads the file.
#pragma once

#include <algorithm>
#include <cctype>
#include <string_view>

namespace trivet {

/// The next beginning of an element with this whole name, from `at` on; npos: none.
inline size_t find_element(std::string_view text, std::string_view begin, size_t at) {
  for (at = text.find(begin, at); at != text.npos; at = text.find(begin, at + 1)) {
    const size_t end = at + begin.size();
    const bool longer = end < text.size() && std::isalnum(static_cast<unsigned char>(text[end]));
    if (!longer) return at;
  }
  return text.npos;
}

/// The value of an attribute of the element that begins at the front of `text`; empty: none.
inline std::string_view attribute_of(std::string_view text, std::string_view name) {
  text = text.substr(0, text.find('>'));
  size_t at = text.find(name);
  if (at == text.npos) return "";
  at = text.find_first_of("\"'", at);
  if (at == text.npos) return "";
  return text.substr(at + 1, text.find(text[at], at + 1) - at - 1);
}

}  // namespace trivet
