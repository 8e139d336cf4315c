// Radiance's picture files: .hdr, RGBE, by stb_image, of which nothing else is compiled:
// CMake defines what that takes.
#include <stb/stb_image.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string_view>

#include "core/base/bad_input.h"
#include "core/picture/image_files.h"

namespace trivet {
namespace {

constexpr std::size_t kMostHeaderBytes = std::size_t{1} << 20;
constexpr std::size_t kMostPixelsOfByte = 16;  // runs give 127 pixels for eight bytes
constexpr std::size_t kBytesOfPixel = 4;

/// A file that never ends for stb_image, whose reader would go round for ever on the zeros that it
/// gives itself beyond the end: ones are there, and are told.
class EndlessHdr {
 public:
  explicit EndlessHdr(std::string_view bytes) : m_bytes(bytes) {}
  bool ended_early() const { return m_ended_early; }

  static int read(void* self, char* to, int size) {
    return static_cast<EndlessHdr*>(self)->read(to, static_cast<std::size_t>(size));
  }
  static void skip(void* self, int size) {
    auto& file = *static_cast<EndlessHdr*>(self);
    file.m_bytes.remove_prefix(std::min(static_cast<std::size_t>(size), file.m_bytes.size()));
  }
  static int is_at_end(void* self) { return static_cast<EndlessHdr*>(self)->m_bytes.empty(); }

 private:
  // More than a pixel is read ahead, and may be less than was asked for.
  int read(char* to, std::size_t size) {
    const std::size_t count = std::min(size, m_bytes.size());
    std::memcpy(to, m_bytes.data(), count);
    m_bytes.remove_prefix(count);
    if (count == size || (count > 0 && size > kBytesOfPixel)) return static_cast<int>(count);
    m_ended_early = true;
    std::memset(to + count, 1, size - count);
    return static_cast<int>(size);
  }

  std::string_view m_bytes;
  bool m_ended_early = false;
};
constexpr stbi_io_callbacks kHdrCallbacks{EndlessHdr::read, EndlessHdr::skip,
                                          EndlessHdr::is_at_end};

void check_header(const std::string& bytes) {
  int width = 0, height = 0, channels = 0;
  const auto* const first = reinterpret_cast<const stbi_uc*>(bytes.data());
  const auto size = static_cast<int>(std::min(bytes.size(), kMostHeaderBytes));
  if (!stbi_info_from_memory(first, size, &width, &height, &channels))
    bad_input(
        "no Radiance image; accepted: #?RADIANCE or #?RGBE, FORMAT=32-bit_rle_rgbe, an empty line, "
        "-Y HEIGHT +X WIDTH");
  if (width < 1 || height < 1 || width > kMaxFloatImageSide || height > kMaxFloatImageSide ||
      std::int64_t{width} * height > kMaxFloatImagePixels)
    bad_input("an image of %1 x %2 pixels; accepted: up to %3 a side, %4 together", width, height,
              kMaxFloatImageSide, kMaxFloatImagePixels);
  // No small file asks for much memory.
  if (std::size_t(width) * std::size_t(height) / kMostPixelsOfByte > bytes.size())
    bad_input("no Radiance image: it ends early");
}

// All factors that the pixels were multiplied with, which stb_image leaves in them.
double exposure_of(std::string_view header) {
  constexpr std::string_view kExposure = "\nEXPOSURE=";
  double out = 1;
  header = header.substr(0, header.find("\n\n"));
  for (std::size_t at = header.find(kExposure); at != std::string_view::npos;
       at = header.find(kExposure, at + 1))
    out *= std::atof(std::string(header.substr(at + kExposure.size(), 64)).c_str());
  if (!(out > 1e-12 && out < 1e12))
    bad_input("a Radiance image with an exposure of %1", std::to_string(out));
  return out;
}

// (1, 1, 1, n) repeats a pixel in files that are older than packing by channel, and is no other's
// pixel: stb_image takes it for one.
void refuse_repeats(std::string_view bytes) {
  const std::size_t size_line = std::min(bytes.find("\n\n"), bytes.size() - 2) + 2;
  std::string_view pixels = bytes.substr(std::min(bytes.find('\n', size_line), bytes.size() - 1));
  pixels.remove_prefix(1);
  if (pixels.substr(0, 2) == "\2\2") return;
  for (; pixels.size() >= kBytesOfPixel; pixels.remove_prefix(kBytesOfPixel))
    if (pixels.substr(0, 3) == "\1\1\1")
      bad_input("a Radiance image that repeats pixels; accepted: packed by channel, or not packed");
}

}  // namespace

FloatImage decode_hdr(const std::string& bytes) {
  check_header(bytes);
  refuse_repeats(bytes);
  const double exposure = exposure_of(bytes);
  EndlessHdr file(bytes);
  FloatImage out;
  int channels = 0;
  const std::unique_ptr<float, decltype(&stbi_image_free)> pixels(
      stbi_loadf_from_callbacks(&kHdrCallbacks, &file, &out.width, &out.height, &channels, 3),
      stbi_image_free);
  if (file.ended_early()) bad_input("no Radiance image: it ends early");
  if (!pixels) bad_input("no Radiance image: %1", std::string(stbi_failure_reason()));
  out.rgb.assign(pixels.get(), pixels.get() + 3 * std::size_t(out.width) * std::size_t(out.height));
  if (exposure != 1)
    for (float& value : out.rgb) value = static_cast<float>(value / exposure);
  return out;
}

}  // namespace trivet
