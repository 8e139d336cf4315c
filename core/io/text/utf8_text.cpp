#include "core/io/text/utf8_text.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string_view>

namespace trivet {
namespace {

enum class ByteOrder { Little, Big };

// Number of the first bytes, even or odd ones, that are zero.
size_t num_zeros(std::string_view bytes, size_t first) {
  size_t count = 0;
  for (size_t i = first; i < std::min<size_t>(bytes.size(), 64); i += 2) count += bytes[i] == 0;
  return count;
}

// Text of ASCII letters has a zero in each pair; files without a mark are told by them.
std::optional<ByteOrder> utf16_order(std::string_view bytes) {
  if (bytes.starts_with("\xff\xfe")) return ByteOrder::Little;
  if (bytes.starts_with("\xfe\xff")) return ByteOrder::Big;
  const size_t pairs = std::min<size_t>(bytes.size(), 64) / 2;
  if (pairs < 4) return std::nullopt;
  const size_t even = num_zeros(bytes, 0), odd = num_zeros(bytes, 1);
  if (even == 0 && odd == pairs) return ByteOrder::Little;
  if (odd == 0 && even == pairs) return ByteOrder::Big;
  return std::nullopt;
}

void append_utf8(std::string& out, std::uint32_t code) {
  const auto tail = [&](int shift) { out += static_cast<char>(0x80 | (code >> shift & 0x3f)); };
  if (code < 0x80) {
    out += static_cast<char>(code);
  } else if (code < 0x800) {
    out += static_cast<char>(0xc0 | code >> 6), tail(0);
  } else if (code < 0x10000) {
    out += static_cast<char>(0xe0 | code >> 12), tail(6), tail(0);
  } else {
    out += static_cast<char>(0xf0 | code >> 18), tail(12), tail(6), tail(0);
  }
}

// By its mark only.
std::optional<ByteOrder> utf32_order(std::string_view bytes) {
  using namespace std::string_view_literals;
  if (bytes.starts_with("\xff\xfe\0\0"sv)) return ByteOrder::Little;
  if (bytes.starts_with("\0\0\xfe\xff"sv)) return ByteOrder::Big;
  return std::nullopt;
}

std::string utf8_of_utf32(std::string_view bytes, ByteOrder order) {
  std::string out;
  out.reserve(bytes.size() / 4);
  for (size_t i = 4; i + 4 <= bytes.size(); i += 4) {
    std::uint32_t code = 0;
    for (size_t k = 0; k < 4; ++k)
      code = code << 8 |
             static_cast<unsigned char>(bytes[order == ByteOrder::Big ? i + k : i + 3 - k]);
    append_utf8(out, code < 0x110000 ? code : '?');
  }
  return out;
}

class Utf16 {
 public:
  Utf16(std::string_view bytes, ByteOrder order) : m_bytes(bytes), m_order(order) {}

  // Lone surrogates become "?".
  std::string as_utf8() const {
    std::string out;
    out.reserve(m_bytes.size() / 2);
    for (size_t i = 0; i < m_bytes.size() / 2; ++i) {
      std::uint32_t code = unit(i);
      if (i == 0 && code == 0xfeff) continue;
      if (code >= 0xd800 && code < 0xe000) {
        const std::uint32_t low = i + 1 < m_bytes.size() / 2 ? unit(i + 1) : 0;
        const bool pair = code < 0xdc00 && low >= 0xdc00 && low < 0xe000;
        code = pair ? 0x10000 + ((code - 0xd800) << 10) + (low - 0xdc00) : '?';
        i += pair;
      }
      append_utf8(out, code);
    }
    return out;
  }

 private:
  std::uint32_t unit(size_t i) const {
    const auto first = static_cast<unsigned char>(m_bytes[2 * i]);
    const auto second = static_cast<unsigned char>(m_bytes[2 * i + 1]);
    return m_order == ByteOrder::Little ? first | second << 8u : second | first << 8u;
  }

  std::string_view m_bytes;
  ByteOrder m_order;
};

}  // namespace

std::string utf8_text(std::string bytes) {
  if (const auto order = utf32_order(bytes)) return utf8_of_utf32(bytes, *order);
  if (const auto order = utf16_order(bytes)) return Utf16(bytes, *order).as_utf8();
  if (bytes.starts_with("\xef\xbb\xbf")) bytes.erase(0, 3);
  return bytes;
}

}  // namespace trivet
