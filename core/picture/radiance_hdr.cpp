// Radiance's picture files: .hdr, RGBE. @see [Ward 1991] "Real pixels", Graphics Gems II
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <string_view>

#include "core/base/bad_input.h"
#include "core/picture/image_files.h"

namespace trivet {
namespace {

constexpr int kLeastPackedWidth = 8, kMostPackedWidth = 32767;
constexpr std::size_t kMostHeaderLines = 1000;

/// Reads bytes one after the other; refuses to read beyond the end.
class HdrBytes {
 public:
  explicit HdrBytes(const std::string& bytes) : m_bytes(bytes) {}

  std::string_view line() {
    const std::size_t end = m_bytes.find('\n', m_at);
    if (end == std::string::npos) bad_input("no Radiance image: its header has no end");
    const std::string_view out(m_bytes.data() + m_at, end - m_at);
    m_at = end + 1;
    return out;
  }
  std::uint8_t byte() {
    if (m_at >= m_bytes.size()) bad_input("no Radiance image: it ends early");
    return static_cast<std::uint8_t>(m_bytes[m_at++]);
  }
  std::size_t num_left() const { return m_bytes.size() - m_at; }
  std::uint8_t ahead(std::size_t n) const {
    return n < num_left() ? static_cast<std::uint8_t>(m_bytes[m_at + n]) : 0;
  }

 private:
  const std::string& m_bytes;
  std::size_t m_at = 0;
};

struct HdrHeader {
  int width = 0, height = 0;
  double exposure = 1;  // that all pixels were multiplied with
};

bool begins_with(std::string_view text, std::string_view begin) {
  return text.substr(0, begin.size()) == begin;
}

// "-Y 512 +X 1024": rows from above, from left to right.
void read_size(std::string_view line, HdrHeader& out) {
  const std::string text(line);
  char* end = nullptr;
  const long height = begins_with(text, "-Y ") ? std::strtol(text.c_str() + 3, &end, 10) : 0;
  const std::string_view rest = end ? std::string_view(end) : std::string_view();
  const long width = begins_with(rest, " +X ") ? std::strtol(end + 4, nullptr, 10) : 0;
  if (height < 1 || width < 1)
    bad_input("an image of size \"%1\"; accepted: -Y HEIGHT +X WIDTH, rows from above", text);
  if (width > kMaxFloatImageSide || height > kMaxFloatImageSide ||
      std::int64_t{width} * height > kMaxFloatImagePixels)
    bad_input("an image of %1 x %2 pixels; accepted: up to %3 a side, %4 together",
              std::to_string(width), std::to_string(height), kMaxFloatImageSide,
              kMaxFloatImagePixels);
  out.width = static_cast<int>(width), out.height = static_cast<int>(height);
}

HdrHeader read_header(HdrBytes& bytes) {
  HdrHeader out;
  if (!begins_with(bytes.line(), "#?")) bad_input("no Radiance image: it does not begin with #?");
  for (std::size_t i = 0; i < kMostHeaderLines; ++i) {
    const std::string line(bytes.line());
    if (line.empty() || line == "\r") {
      read_size(bytes.line(), out);
      return out;
    }
    if (begins_with(line, "FORMAT=") && !begins_with(line, "FORMAT=32-bit_rle_rgbe"))
      bad_input("a Radiance image of %1; accepted: FORMAT=32-bit_rle_rgbe", line);
    if (begins_with(line, "EXPOSURE=")) out.exposure *= std::atof(line.c_str() + 9);
  }
  bad_input("no Radiance image: its header has no end");
}

using Rgbe = std::array<std::uint8_t, 4>;

// Four channels, each as runs of equal bytes and of others.
void read_packed_row(HdrBytes& bytes, std::vector<Rgbe>& row) {
  for (std::size_t c = 0; c < 4; ++c)
    for (std::size_t x = 0; x < row.size();) {
      const std::size_t code = bytes.byte();
      const bool same = code > 128;
      const std::size_t count = same ? code - 128 : code;
      if (count == 0 || count > row.size() - x)
        bad_input("no Radiance image: a run beyond its row");
      const std::uint8_t first = bytes.byte();
      for (std::size_t i = 0; i < count; ++i) row[x + i][c] = same || i == 0 ? first : bytes.byte();
      x += count;
    }
}

// Pixels one by one; (1, 1, 1, n) repeats the one before, and says more of its count when repeated.
void read_plain_row(HdrBytes& bytes, std::vector<Rgbe>& row) {
  int shift = 0;
  for (std::size_t x = 0; x < row.size();) {
    Rgbe pixel{};
    for (std::uint8_t& value : pixel) value = bytes.byte();
    if (pixel[0] != 1 || pixel[1] != 1 || pixel[2] != 1) {
      row[x++] = pixel, shift = 0;
      continue;
    }
    const std::size_t count = shift > 16 ? row.size() : std::size_t{pixel[3]} << shift;
    if (x == 0 || count > row.size() - x) bad_input("no Radiance image: a run beyond its row");
    std::fill_n(row.begin() + static_cast<std::ptrdiff_t>(x), count, row[x - 1]);
    x += count, shift += 8;
  }
}

void read_row(HdrBytes& bytes, std::vector<Rgbe>& row) {
  const auto width = static_cast<int>(row.size());
  const bool packed = kLeastPackedWidth <= width && width <= kMostPackedWidth &&
                      bytes.ahead(0) == 2 && bytes.ahead(1) == 2 &&
                      (bytes.ahead(2) << 8 | bytes.ahead(3)) == width;
  if (!packed) return read_plain_row(bytes, row);
  for (int i = 0; i < 4; ++i) bytes.byte();
  read_packed_row(bytes, row);
}

}  // namespace

FloatImage decode_hdr(const std::string& text) {
  HdrBytes bytes(text);
  const HdrHeader header = read_header(bytes);
  if (!(header.exposure > 1e-12 && header.exposure < 1e12))
    bad_input("a Radiance image with an exposure of %1", std::to_string(header.exposure));
  // A run gives at most 127 bytes for two: no small file asks for much memory.
  if (std::size_t(header.width) * std::size_t(header.height) / 128 > bytes.num_left())
    bad_input("no Radiance image: it ends early");
  FloatImage out{header.width, header.height, {}};
  out.rgb.reserve(3 * std::size_t(header.width) * std::size_t(header.height));
  std::vector<Rgbe> row(static_cast<std::size_t>(header.width));
  for (int y = 0; y < header.height; ++y) {
    read_row(bytes, row);
    for (const Rgbe& pixel : row) {
      const double unit = pixel[3] == 0 ? 0 : std::ldexp(1 / header.exposure, pixel[3] - (128 + 8));
      for (std::size_t c = 0; c < 3; ++c) out.rgb.push_back(static_cast<float>(pixel[c] * unit));
    }
  }
  return out;
}

FloatImage decode_float_image(const std::string& bytes) {
  return bytes.compare(0, 2, "#?") == 0 ? decode_hdr(bytes) : decode_exr(bytes);
}

}  // namespace trivet
