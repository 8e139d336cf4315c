#include "core/io/gltf/meshopt_attributes.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <vector>

namespace trivet::gltf {
namespace {

using Byte = std::uint8_t;

constexpr size_t kGroup = 16, kMostOfBlock = 256, kBlockBytes = 8192, kLeastTail = 24;
enum class Control { Small, Large, Zeros, Literal };

std::uint32_t unzigzag(std::uint32_t v) { return (v >> 1) ^ (0u - (v & 1)); }

/// Reads deltas, block by block: bytes of a kind together, in groups of 16.
class Deltas {
 public:
  Deltas(std::string_view bytes, size_t stride) : m_bytes(bytes), m_stride(stride) {}

  /// Fills `out`, `count` bytes for each of the element's. False: damaged.
  bool read_block(size_t count, std::vector<Byte>& out) {
    out.assign(count * m_stride, 0);
    const std::string_view controls = take(m_stride / 4);
    for (size_t byte = 0; m_whole && byte < m_stride; ++byte) {
      const auto control =
          static_cast<Control>(static_cast<Byte>(controls[byte / 4]) >> (byte % 4 * 2) & 3);
      read_bytes(control, count, &out[byte * count]);
    }
    return m_whole;
  }
  bool at_end() const { return m_bytes.empty(); }

 private:
  std::string_view take(size_t count) {
    m_whole &= count <= m_bytes.size();
    if (!m_whole) return {};
    const std::string_view out = m_bytes.substr(0, count);
    m_bytes.remove_prefix(count);
    return out;
  }

  void read_bytes(Control control, size_t count, Byte* out) {
    if (control == Control::Zeros) return;
    if (control == Control::Literal) {
      if (const std::string_view literal = take(count); m_whole)
        std::memcpy(out, literal.data(), count);
      return;
    }
    const size_t num_groups = (count + kGroup - 1) / kGroup;
    const std::string_view header = take((num_groups + 3) / 4);
    for (size_t group = 0; m_whole && group < num_groups; ++group) {
      const int mode = static_cast<Byte>(header[group / 4]) >> (group % 4 * 2) & 3;
      constexpr int kBits[2][4] = {{0, 1, 2, 4}, {1, 2, 4, 8}};
      Byte deltas[kGroup] = {};
      read_group(kBits[static_cast<int>(control)][mode], deltas);
      const size_t first = group * kGroup;
      std::memcpy(out + first, deltas, std::min(kGroup, count - first));
    }
  }

  // A value with all its bits set stands for a byte behind the group.
  void read_group(int bits, Byte* out) {
    const std::string_view packed = take(kGroup * static_cast<size_t>(bits) / 8);
    if (!m_whole || bits == 0) return;
    const int per_byte = 8 / bits, mask = (1 << bits) - 1;
    for (size_t i = 0; m_whole && i < kGroup; ++i) {
      const int place = static_cast<int>(i) % per_byte;
      const int shift = bits == 1 ? place : (per_byte - 1 - place) * bits;
      const int value =
          static_cast<Byte>(packed[i / static_cast<size_t>(per_byte)]) >> shift & mask;
      out[i] = static_cast<Byte>(value);
      if (bits == 8 || value != mask) continue;
      if (const std::string_view more = take(1); m_whole) out[i] = static_cast<Byte>(more[0]);
    }
  }

  std::string_view m_bytes;
  const size_t m_stride;
  bool m_whole = true;
};

bool is_valid_channel(char mode) {
  const int low = mode & 15, high = static_cast<Byte>(mode) >> 4;
  return low == 2 || (low < 2 && high == 0);
}

// The next 4 bytes of an element, of those before and the deltas, by the mode of their channel.
std::uint32_t next_value(std::uint32_t before, std::uint32_t delta, Byte mode) {
  if ((mode & 15) == 2) return before ^ std::rotr(delta, mode >> 4);
  const int bits = (mode & 15) == 0 ? 8 : 16;
  const std::uint32_t mask = (1u << bits) - 1;
  std::uint32_t out = 0;
  for (int shift = 0; shift < 32; shift += bits)
    out |= (((before >> shift) + unzigzag(delta >> shift & mask)) & mask) << shift;
  return out;
}

}  // namespace

std::string decoded_attributes(std::string_view bytes, size_t count, size_t stride) {
  const size_t tail = stride + stride / 4, padded = std::max(tail, kLeastTail);
  if (bytes.size() < 1 + padded || bytes[0] != kAttributes1) return {};
  const std::string_view modes = bytes.substr(bytes.size() - stride / 4);
  if (!std::all_of(modes.begin(), modes.end(), is_valid_channel)) return {};
  std::vector<std::uint32_t> element(stride / 4);
  std::memcpy(element.data(), bytes.data() + bytes.size() - tail, stride);
  Deltas deltas(bytes.substr(1, bytes.size() - 1 - padded), stride);
  std::string out(count * stride, '\0');
  const size_t most = std::min(kBlockBytes / stride / kGroup * kGroup, kMostOfBlock);
  std::vector<Byte> block;
  for (size_t first = 0; first < count; first += most) {
    const size_t size = std::min(count - first, most);
    if (!deltas.read_block(size, block)) return {};
    for (size_t i = 0; i < size; ++i) {
      for (size_t c = 0; c < element.size(); ++c) {
        std::uint32_t delta = 0;
        for (size_t k = 4; k-- > 0;) delta = delta << 8 | block[(4 * c + k) * size + i];
        element[c] = next_value(element[c], delta, static_cast<Byte>(modes[c]));
      }
      std::memcpy(&out[(first + i) * stride], element.data(), stride);
    }
  }
  return deltas.at_end() ? out : std::string();
}

namespace {

// @tparam T  unsigned, of 8 or 16 bits.
template <class T>
void decode_colour(char* at) {
  using Signed = std::make_signed_t<T>;
  T in[4];
  std::memcpy(in, at, sizeof in);
  const int most = (1 << std::bit_width(unsigned{in[3]})) - 1;
  const int y = in[0], co = static_cast<Signed>(in[1]), cg = static_cast<Signed>(in[2]);
  const int alpha = in[3] & (most >> 1);
  const int rgba[4] = {y + co - cg, y + cg, y - co - cg, alpha << 1 | (alpha & 1)};
  constexpr int kMax = static_cast<T>(-1);
  const float scale = most > 0 ? kMax / static_cast<float>(most) : 0.0f;
  for (int c = 0; c < 4; ++c)
    in[c] = static_cast<T>(
        std::clamp(std::round(static_cast<float>(rgba[c]) * scale), 0.0f, float{kMax}));
  std::memcpy(at, in, sizeof in);
}

}  // namespace

void apply_colour_filter(std::string& bytes, size_t stride) {
  for (size_t i = 0; i + stride <= bytes.size(); i += stride)
    stride == 4 ? decode_colour<std::uint8_t>(&bytes[i]) : decode_colour<std::uint16_t>(&bytes[i]);
}

}  // namespace trivet::gltf
