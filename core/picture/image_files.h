// Image files of numbers: 8- and 16-bit PNG, float32 OpenEXR; Radiance's are read.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace trivet {

/// One value per pixel, rows from above; no colour space. Fast rather than small.
/// @param values  width x height. @throws Error (Environment) with libpng's reason.
std::string encode_grey_png(int width, int height, std::span<const std::uint8_t> values);
std::string encode_grey_png(int width, int height, std::span<const std::uint16_t> values);
/// Three values per pixel.
std::string encode_rgb_png(int width, int height, std::span<const std::uint16_t> values);

/// One value per pixel in channel Z; or three, in channels X, Y and Z. Compressed losslessly.
/// @param values  width x height x channels.
/// @throws Error (Environment) in a build without OpenEXR, or with its reason.
std::string encode_exr(int width, int height, int num_channels, std::span<const float> values);

/// Linear light, three values per pixel, rows from above.
struct FloatImage {
  int width = 0, height = 0;
  std::vector<float> rgb;
};
inline constexpr int kMaxFloatImageSide = 16384;
inline constexpr std::int64_t kMaxFloatImagePixels = std::int64_t{1} << 26;

/// Channels R, G and B of an OpenEXR file; channel Y alone is grey. Untrusted: bounded in size.
/// Values that are not finite or below zero are 0.
/// @throws Error: BadInput for what is no such image; Environment in a build without OpenEXR.
FloatImage decode_exr(const std::string& bytes);

/// A Radiance file (.hdr) of RGBE, rows from above, packed by channel or not packed; its EXPOSURE
/// is taken back. Untrusted: bounded in size.
/// @throws Error: BadInput for what is no such image; Environment in a build without stb_image.
FloatImage decode_hdr(const std::string& bytes);
/// Either of the two, by its first bytes. @throws Error as they do.
FloatImage decode_float_image(const std::string& bytes);

}  // namespace trivet
