// Pictures in memory and as PNG files.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace trivet {

/// Rows from top to bottom, pixels from left to right, sRGB, straight alpha.
struct Image {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;  // width x height x 4

  const std::uint8_t* pixel(int x, int y) const {
    return rgba.data() + 4 * (static_cast<std::size_t>(y) * width + x);
  }
};

/// Encodes a PNG file; without an alpha channel if every pixel is opaque.
/// @throws Error (Environment) with libpng's reason.
std::string encode_png(const Image& image);

/// Writes a PNG file atomically: the path holds either the old content or the whole picture.
/// @throws Error (Environment) if it cannot be written.
void write_png(const Image& image, const std::string& path);

}  // namespace trivet
