// 64-bit hash of numbers and strings, the same on every machine. Not cryptographic.
#pragma once

#include <bit>
#include <cstdint>
#include <string>
#include <string_view>

namespace trivet {

/// 16 hexadecimal digits.
inline std::string hash_text(std::uint64_t value) {
  std::string out(16, '0');
  for (int i = 0; i < 16; ++i) out[i] = "0123456789abcdef"[value >> (60 - 4 * i) & 15];
  return out;
}

class Hash {
 public:
  explicit Hash(std::uint64_t start = 0) : m_value(start) {}

  Hash& add(std::uint64_t bits) {
    constexpr std::uint64_t kPrime = 0x9E3779B97F4A7C15u;  // odd, 2^64 / golden ratio
    m_value = (m_value ^ bits) * kPrime;
    m_value ^= m_value >> 32;
    return *this;
  }
  /// Bitwise, except that -0 equals 0.
  Hash& add(double number) { return add(std::bit_cast<std::uint64_t>(number + 0.0)); }
  Hash& add(std::string_view text) {
    add(std::uint64_t{text.size()});
    for (const char c : text) add(std::uint64_t{static_cast<unsigned char>(c)});
    return *this;
  }

  std::uint64_t value() const { return m_value; }
  std::string text() const { return hash_text(m_value); }

 private:
  std::uint64_t m_value;
};

}  // namespace trivet
