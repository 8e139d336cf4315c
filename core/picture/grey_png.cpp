#include <png.h>

#include <memory>

#include "core/base/error.h"
#include "core/picture/image_files.h"

namespace trivet {
namespace {

constexpr int kCompression = 3;  // of 9; the rest gains a few percent in thrice the time

[[noreturn]] void fail(png_structp png, png_const_charp reason) {
  // libpng asks its user not to return: the file so far is dropped by what owns it.
  (void)png;
  throw Error(Error::Kind::Environment, "an image cannot be encoded as PNG: %1", reason);
}

void ignore(png_structp, png_const_charp) {}

void append(png_structp png, png_bytep data, png_size_t size) {
  static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<char*>(data), size);
}
void flush(png_structp) {}

struct Writer {
  png_structp png;
  png_infop info = nullptr;

  Writer() : png(png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, fail, ignore)) {
    if (png) info = png_create_info_struct(png);
    if (!info) throw Error(Error::Kind::Environment, "no memory to encode an image as PNG");
  }
  ~Writer() { png_destroy_write_struct(&png, &info); }
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;
};

std::string encode(int width, int height, int bits, int colour, const std::uint8_t* rows,
                   std::size_t row_bytes) {
  std::string out;
  Writer writer;
  png_set_write_fn(writer.png, &out, append, flush);
  png_set_IHDR(writer.png, writer.info, width, height, bits, colour, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_set_compression_level(writer.png, kCompression);
  png_set_filter(writer.png, 0, bits == 8 ? PNG_FILTER_NONE : PNG_FILTER_UP);
  png_write_info(writer.png, writer.info);
  for (int y = 0; y < height; ++y) png_write_row(writer.png, rows + row_bytes * y);
  png_write_end(writer.png, writer.info);
  return out;
}

std::string encode_16(int width, int height, int num_channels, int colour,
                      std::span<const std::uint16_t> values) {
  std::string bytes;  // big-endian
  bytes.reserve(2 * values.size());
  for (const std::uint16_t v : values) {
    bytes += static_cast<char>(v >> 8);
    bytes += static_cast<char>(v & 255);
  }
  return encode(width, height, 16, colour, reinterpret_cast<const std::uint8_t*>(bytes.data()),
                std::size_t{2} * num_channels * width);
}

}  // namespace

std::string encode_grey_png(int width, int height, std::span<const std::uint8_t> values) {
  return encode(width, height, 8, PNG_COLOR_TYPE_GRAY, values.data(), width);
}

std::string encode_grey_png(int width, int height, std::span<const std::uint16_t> values) {
  return encode_16(width, height, 1, PNG_COLOR_TYPE_GRAY, values);
}

std::string encode_rgb_png(int width, int height, std::span<const std::uint16_t> values) {
  return encode_16(width, height, 3, PNG_COLOR_TYPE_RGB, values);
}

}  // namespace trivet
