// Image files of models as texels. Untrusted: bounded in size and memory, damaged ones are errors.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace trivet {

inline constexpr int kMaxImageSide = 16384;                             // texels
inline constexpr std::int64_t kMaxImageTexels = std::int64_t{1} << 26;  // 256 MiB decoded

/// Texels as the file has them, whatever colour space it claims: 8 bits, straight alpha.
struct DecodedImage {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;  // width x height x 4, rows from above
};

/// "PNG", "JPEG", "WebP", "KTX2", "DDS", "AVIF", "BMP", "GIF" or "TIFF" by the first bytes; else
/// "unknown".
std::string image_kind(std::string_view bytes);

/// Decodes PNG by libpng, JPEG by libjpeg-turbo, WebP by libwebp (the first picture).
/// @throws Error (BadInput) with the reason: another kind, damaged, more than the limits above.
DecodedImage decode_image(std::string_view bytes);

/// @throws Error (BadInput) for sizes that are no picture's or above the limits.
void check_image_size(std::int64_t width, std::int64_t height);

DecodedImage decode_png(std::string_view bytes);
DecodedImage decode_jpeg(std::string_view bytes);
DecodedImage decode_webp(std::string_view bytes);

}  // namespace trivet
