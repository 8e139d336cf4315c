#include <png.h>

#include <cstring>

#include "core/base/bad_input.h"
#include "core/io/textures/decoded_image.h"

namespace trivet {
namespace {

constexpr png_alloc_size_t kMaxChunkBytes = 8 << 20;  // of texts and profiles

// libpng asks its user not to return.
[[noreturn]] void fail_decoding(png_structp, png_const_charp reason) {
  bad_input("is a damaged PNG: %1", reason);
}
void ignore_warning(png_structp, png_const_charp) {}

void take_bytes(png_structp png, png_bytep out, size_t count) {
  auto& rest = *static_cast<std::string_view*>(png_get_io_ptr(png));
  if (count > rest.size()) fail_decoding(png, "it ends early");
  std::memcpy(out, rest.data(), count);
  rest.remove_prefix(count);
}

struct PngReader {
  png_structp png =
      png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, fail_decoding, ignore_warning);
  png_infop info = png ? png_create_info_struct(png) : nullptr;
  PngReader() {
    if (!info) fail_decoding(nullptr, "libpng cannot start");
  }
  ~PngReader() { png_destroy_read_struct(&png, &info, nullptr); }
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;
};

/// Everything to four channels of 8 bits. Gamma and profiles are left alone, as glTF wants.
void expand_to_rgba(png_structp png, png_infop info) {
  png_set_expand(png);
  png_set_scale_16(png);
  png_set_gray_to_rgb(png);
  png_set_add_alpha(png, 0xff, PNG_FILLER_AFTER);
  png_set_interlace_handling(png);
  png_read_update_info(png, info);
}

}  // namespace

DecodedImage decode_png(std::string_view bytes) {
  const PngReader reader;
  png_set_user_limits(reader.png, kMaxImageSide, kMaxImageSide);
  png_set_chunk_cache_max(reader.png, 64);
  png_set_chunk_malloc_max(reader.png, kMaxChunkBytes);
  png_set_read_fn(reader.png, &bytes, take_bytes);
  png_read_info(reader.png, reader.info);
  const std::int64_t width = png_get_image_width(reader.png, reader.info);
  const std::int64_t height = png_get_image_height(reader.png, reader.info);
  check_image_size(width, height);
  expand_to_rgba(reader.png, reader.info);
  if (png_get_rowbytes(reader.png, reader.info) != static_cast<size_t>(4 * width))
    fail_decoding(reader.png, "its rows have another length than its width says");
  DecodedImage out{static_cast<int>(width), static_cast<int>(height), {}};
  out.rgba.resize(static_cast<size_t>(4 * width * height));
  std::vector<png_bytep> rows;
  rows.reserve(static_cast<size_t>(height));
  for (std::int64_t y = 0; y < height; ++y) rows.push_back(out.rgba.data() + 4 * width * y);
  png_read_image(reader.png, rows.data());
  png_read_end(reader.png, nullptr);
  return out;
}

}  // namespace trivet
