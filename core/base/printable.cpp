#include "core/base/printable.h"

#include <algorithm>

namespace trivet {
namespace {

unsigned byte(std::string_view text, size_t at) {
  return at < text.size() ? static_cast<unsigned char>(text[at]) : 0;
}

bool continues(std::string_view text, size_t at) { return (byte(text, at) & 0xc0) == 0x80; }

// Tabs, and characters that end lines of terminals and logs.
bool is_white_space(std::string_view character) {
  return character == "\n" || character == "\r" || character == "\t" ||
         character == "\xe2\x80\xa8" || character == "\xe2\x80\xa9";
}

// U+0000 to U+001F and U+007F to U+009F.
bool is_control(std::string_view character) {
  const unsigned first = byte(character, 0);
  if (character.size() == 1) return first < 0x20 || first == 0x7f;
  return character.size() == 2 && first == 0xc2 && byte(character, 1) < 0xa0;
}

}  // namespace

size_t utf8_length(std::string_view text, size_t at) {
  const unsigned first = byte(text, at), second = byte(text, at + 1);
  if (at >= text.size()) return 0;
  if (first < 0x80) return 1;
  if (first < 0xc2 || first > 0xf4 || !continues(text, at + 1)) return 0;
  if (first < 0xe0) return 2;
  // Longer than need be, halves of surrogates, beyond U+10FFFF.
  if ((first == 0xe0 && second < 0xa0) || (first == 0xed && second > 0x9f) ||
      (first == 0xf0 && second < 0x90) || (first == 0xf4 && second > 0x8f))
    return 0;
  if (!continues(text, at + 2)) return 0;
  if (first < 0xf0) return 3;
  return continues(text, at + 3) ? 4 : 0;
}

bool is_utf8(std::string_view text) {
  for (size_t at = 0; at < text.size();) {
    const size_t length = utf8_length(text, at);
    if (length == 0) return false;
    at += length;
  }
  return true;
}

std::string printable(std::string_view text, size_t most) {
  std::string out;
  for (size_t at = 0; at < text.size();) {
    const size_t length = utf8_length(text, at);
    if (out.size() + std::max<size_t>(length, 1) > most) return out + "...";
    const std::string_view character = text.substr(at, length);
    if (is_white_space(character))
      out += ' ';
    else if (length == 0 || is_control(character))
      out += '?';
    else
      out += character;
    at += std::max<size_t>(length, 1);
  }
  return out;
}

}  // namespace trivet
