#include "core/io/textures/decoded_image.h"

#include "core/base/bad_input.h"

namespace trivet {

std::string image_kind(std::string_view bytes) {
  const auto has = [&](size_t at, std::string_view text) {
    return bytes.size() >= at + text.size() && bytes.substr(at, text.size()) == text;
  };
  if (has(0, "\x89PNG\r\n\x1a\n")) return "PNG";
  if (has(0, "\xff\xd8\xff")) return "JPEG";
  if (has(0, "RIFF") && has(8, "WEBP")) return "WebP";
  if (has(0, "\xabKTX 20")) return "KTX2";
  if (has(0, "DDS ")) return "DDS";
  if (has(4, "ftypavif")) return "AVIF";
  if (has(0, "BM")) return "BMP";
  if (has(0, "GIF8")) return "GIF";
  if (has(0, "II*") || has(0, "MM")) return "TIFF";
  return "unknown";
}

void check_image_size(std::int64_t width, std::int64_t height) {
  const auto side_is_good = [](std::int64_t side) { return side >= 1 && side <= kMaxImageSide; };
  if (side_is_good(width) && side_is_good(height) && width * height <= kMaxImageTexels) return;
  bad_input("has %1 x %2 texels; accepted: 1 to %3 each way, at most %4 Mi together", width, height,
            kMaxImageSide, kMaxImageTexels >> 20);
}

DecodedImage decode_image(std::string_view bytes) {
  const std::string kind = image_kind(bytes);
  if (kind == "PNG") return decode_png(bytes);
  if (kind == "JPEG") return decode_jpeg(bytes);
  if (kind == "WebP") return decode_webp(bytes);
  bad_input("is of the kind %1; accepted: PNG, JPEG, WebP", kind);
}

}  // namespace trivet
