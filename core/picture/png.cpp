#include "core/picture/png.h"

#include <png.h>

#include "core/base/error.h"
#include "core/io/atomic_file.h"

namespace trivet {
namespace {

bool is_opaque(const Image& image) {
  for (std::size_t i = 3; i < image.rgba.size(); i += 4)
    if (image.rgba[i] != 255) return false;
  return true;
}

std::vector<std::uint8_t> without_alpha(const Image& image) {
  std::vector<std::uint8_t> rgb;
  rgb.reserve(image.rgba.size() / 4 * 3);
  for (std::size_t i = 0; i < image.rgba.size(); i += 4)
    rgb.insert(rgb.end(), image.rgba.begin() + i, image.rgba.begin() + i + 3);
  return rgb;
}

}  // namespace

std::string encode_png(const Image& image) {
  const bool opaque = is_opaque(image);
  const std::vector<std::uint8_t> rgb = opaque ? without_alpha(image) : std::vector<std::uint8_t>{};
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  header.width = image.width;
  header.height = image.height;
  header.format = opaque ? PNG_FORMAT_RGB : PNG_FORMAT_RGBA;
  png_alloc_size_t bytes = PNG_IMAGE_PNG_SIZE_MAX(header);
  std::string png(bytes, '\0');
  if (!png_image_write_to_memory(&header, png.data(), &bytes, 0,
                                 opaque ? rgb.data() : image.rgba.data(), 0, nullptr))
    throw Error(Error::Kind::Environment,
                "the picture of %1 x %2 pixels cannot be encoded as PNG: %3", image.width,
                image.height, header.message);
  png.resize(bytes);
  return png;
}

void write_png(const Image& image, const std::string& path) {
  write_file_atomically(path, encode_png(image));
}

}  // namespace trivet
