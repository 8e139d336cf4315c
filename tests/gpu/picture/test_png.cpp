// Pictures as PNG files decode to the same pixels.
#include <gtest/gtest.h>
#include <png.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "core/base/error.h"
#include "core/base/image.h"
#include "core/picture/png.h"

namespace trivet {
namespace {

Image test_image(bool opaque) {
  Image image{7, 5, {}};
  for (int i = 0; i < 7 * 5; ++i)
    for (const int value : {i * 7, 255 - i, i * i % 256, opaque ? 255 : i * 5})
      image.rgba.push_back(static_cast<std::uint8_t>(value));
  return image;
}

std::vector<std::uint8_t> decode(const std::string& png) {
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  if (!png_image_begin_read_from_memory(&header, png.data(), png.size())) return {};
  header.format = PNG_FORMAT_RGBA;
  std::vector<std::uint8_t> rgba(PNG_IMAGE_SIZE(header));
  if (!png_image_finish_read(&header, nullptr, rgba.data(), 0, nullptr)) return {};
  return rgba;
}

TEST(Png, RoundTripsPixels) {
  for (const bool opaque : {false, true}) {
    const Image image = test_image(opaque);
    EXPECT_EQ(decode(encode_png(image)), image.rgba);
  }
}

TEST(Png, WritesAtomically) {
  const auto folder =
      std::filesystem::temp_directory_path() / ("trivet_png_" + std::to_string(::getpid()));
  std::filesystem::create_directory(folder);
  const Image image = test_image(true);
  write_png(image, (folder / "picture.png").string());
  std::ifstream file(folder / "picture.png", std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(file)), {});
  EXPECT_EQ(decode(bytes), image.rgba);
  try {
    write_png(image, (folder / "picture.png" / "picture.png").string());
    ADD_FAILURE() << "written into a file as if it were a folder";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), Error::Kind::Environment);
    EXPECT_NE(std::string(error.what()).find("picture.png/picture.png"), std::string::npos);
  }
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace trivet
