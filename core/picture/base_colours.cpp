#include "core/picture/base_colours.h"

#include <cmath>

#include "core/io/colour.h"
#include "core/picture/png.h"

namespace trivet {
namespace {

using ByteTable = std::array<std::uint8_t, 256>;

ByteTable times(float colour) {
  ByteTable out;
  for (int v = 0; v < 256; ++v) {
    const auto byte = static_cast<std::uint8_t>(v);
    const float product = std::clamp(colour * linear_from_srgb_byte(byte), 0.0f, 1.0f);
    out[v] = colour == 1 ? byte
                         : static_cast<std::uint8_t>(std::lround(255 * srgb_from_linear(product)));
  }
  return out;
}

}  // namespace

std::string base_colour_png(const TextureImage& image, const std::array<float, 3>& colour,
                            bool opaque) {
  const DecodedImage& level = image.levels.front();
  Image out{level.width, level.height, level.rgba};
  const std::array<ByteTable, 3> tables{times(colour[0]), times(colour[1]), times(colour[2])};
  for (std::size_t i = 0; i < out.rgba.size(); ++i)
    if (i % 4 != 3)
      out.rgba[i] = tables[i % 4][out.rgba[i]];
    else if (opaque)
      out.rgba[i] = 255;
  return encode_png(out);
}

Eigen::Vector2f upward_coordinates(const TextureUse& use, const Eigen::Vector2f& uv) {
  const auto& t = use.transform;
  const float v = t[1][0] * uv.x() + t[1][1] * uv.y() + t[1][2];
  return {t[0][0] * uv.x() + t[0][1] * uv.y() + t[0][2], 1 - v};
}

}  // namespace trivet
