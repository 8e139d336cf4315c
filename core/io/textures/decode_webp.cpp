#include <webp/decode.h>

#include "core/base/bad_input.h"
#include "core/io/textures/decoded_image.h"

namespace trivet {

DecodedImage decode_webp(std::string_view bytes) {
  const auto* const data = reinterpret_cast<const std::uint8_t*>(bytes.data());
  WebPBitstreamFeatures features;
  if (WebPGetFeatures(data, bytes.size(), &features) != VP8_STATUS_OK)
    bad_input("is a damaged WebP: its header cannot be read");
  check_image_size(features.width, features.height);
  if (features.has_animation) bad_input("is an animated WebP; accepted: single pictures");
  DecodedImage out{features.width, features.height, {}};
  out.rgba.resize(size_t{4} * features.width * features.height);
  if (!WebPDecodeRGBAInto(data, bytes.size(), out.rgba.data(), out.rgba.size(), 4 * features.width))
    bad_input("is a damaged WebP");
  return out;
}

}  // namespace trivet
