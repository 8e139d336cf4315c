// Pictures in memory.
#pragma once

#include <cstddef>
#include <cstdint>
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

}  // namespace trivet
