// Textures ready to be looked up: smaller copies of an image, each half as wide and high.
#pragma once

#include "core/io/textures/decoded_image.h"

namespace trivet {

/// Larger images are drawn from a smaller copy: memory of renderers, 64 MiB and a third each.
inline constexpr int kMaxTextureSide = 4096;

struct TextureImage {
  std::string name;
  bool srgb = false;                 // colour, else numbers
  bool has_alpha = false;            // some texel is not opaque
  std::vector<DecodedImage> levels;  // from the finest to a single texel

  size_t num_bytes() const;
};

/// Sides are halved, rounding down, as OpenGL expects it. A texel is the mean over the area that
/// it covers: of linear light if `srgb`, weighted by alpha, so that what is cut out leaves no
/// colour at edges.
/// @param max_side  levels above are dropped.
TextureImage make_texture_image(DecodedImage image, bool srgb, int max_side = kMaxTextureSide);

/// Value of an 8-bit sRGB component, linear, 0 to 1.
float linear_from_srgb_byte(std::uint8_t value);

}  // namespace trivet
