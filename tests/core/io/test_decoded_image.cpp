// Image files as texels, against known ones; damaged, hostile and huge files.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "core/base/error.h"
#include "core/base/image.h"
#include "core/io/base64.h"
#include "core/io/colour.h"
#include "core/io/textures/texture_image.h"
#include "core/picture/image_files.h"
#include "core/picture/png.h"

namespace trivet {
namespace {

// 16 x 16, quality 95: the left half (200, 40, 40), the right one (40, 40, 200).
std::string two_halves_jpeg() {
  return decoded_base64(
      "/9j/4AAQSkZJRgABAQAAAQABAAD/2wBDAAIBAQEBAQIBAQECAgICAgQDAgICAgUEBAMEBgUGBgYFBgYGBwkIBgcJBwYG"
      "CAsICQoKCgoKBggLDAsKDAkKCgr/2wBDAQICAgICAgUDAwUKBwYHCgoKCgoKCgoKCgoKCgoKCgoKCgoKCgoKCgoKCgoK"
      "CgoKCgoKCgoKCgoKCgoKCgoKCgr/wAARCAAQABADAREAAhEBAxEB/8QAFQABAQAAAAAAAAAAAAAAAAAABwj/xAAUEAEA"
      "AAAAAAAAAAAAAAAAAAAA/8QAFQEBAQAAAAAAAAAAAAAAAAAACQf/xAAUEQEAAAAAAAAAAAAAAAAAAAAA/9oADAMBAAIR"
      "AxEAPwCX0TKABzWCLPAUy6Ac1gi3/9k=");
}

// 4 x 2, lossless.
constexpr std::array<std::uint8_t, 32> kFewTexels{
    255, 0, 0, 255, 0,  255, 0,  255, 0,  0,  255, 255, 255, 255, 255, 128,
    0,   0, 0, 255, 10, 20,  30, 255, 40, 50, 60,  0,   70,  80,  90,  255};
std::string few_texels_webp() {
  return decoded_base64(
      "UklGRkoAAABXRUJQVlA4TD4AAAAvA0AAED9AmG20g7jv/C2nQSZtk38e6t/"
      "lCLJtdpHdn3IEkzR1+djlBQiRsUP695maQSBAxmKUOFAjov+BDQ==");
}
std::string few_texels_png() { return encode_png({4, 2, {kFewTexels.begin(), kFewTexels.end()}}); }

std::string reason_of(const std::string& bytes) {
  try {
    decode_image(bytes);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), Error::Kind::BadInput);
    return error.what();
  }
  return "accepted";
}

std::uint32_t crc_of(std::string_view bytes) {
  std::uint32_t crc = ~0u;
  for (const char c : bytes) {
    crc ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ (crc & 1 ? 0xedb88320u : 0);
  }
  return ~crc;
}

void put_big_endian(std::string& bytes, size_t at, std::uint32_t value, int count = 4) {
  for (int i = 0; i < count; ++i)
    bytes[at + static_cast<size_t>(i)] = static_cast<char>(value >> (8 * (count - 1 - i)));
}

// The small PNG, but with another size in its header.
std::string png_of_size(std::uint32_t width, std::uint32_t height) {
  std::string bytes = few_texels_png();
  put_big_endian(bytes, 16, width);
  put_big_endian(bytes, 20, height);
  put_big_endian(bytes, 29, crc_of(std::string_view(bytes).substr(12, 17)));
  return bytes;
}

TEST(DecodedImage, HasTexelsOfPngAndWebp) {
  for (const std::string& bytes : {few_texels_png(), few_texels_webp()}) {
    const DecodedImage image = decode_image(bytes);
    EXPECT_EQ(image.width, 4);
    EXPECT_EQ(image.height, 2);
    EXPECT_TRUE(
        std::equal(kFewTexels.begin(), kFewTexels.end(), image.rgba.begin(), image.rgba.end()))
        << image_kind(bytes);
  }
}

TEST(DecodedImage, HasTexelsOfJpeg) {
  const DecodedImage image = decode_image(two_halves_jpeg());
  ASSERT_EQ(image.width, 16);
  ASSERT_EQ(image.height, 16);
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x) {
      const std::uint8_t* const p = image.rgba.data() + 4 * (16 * y + x);
      EXPECT_NEAR(p[0], x < 8 ? 200 : 40, 3);
      EXPECT_NEAR(p[1], 40, 3);
      EXPECT_NEAR(p[2], x < 8 ? 40 : 200, 3);
      EXPECT_EQ(p[3], 255);
    }
}

TEST(DecodedImage, ExpandsGreyAnd16Bits) {
  const std::array<std::uint8_t, 2> bytes{7, 200};
  EXPECT_EQ(decode_image(encode_grey_png(2, 1, bytes)).rgba,
            (std::vector<std::uint8_t>{7, 7, 7, 255, 200, 200, 200, 255}));
  const std::array<std::uint16_t, 3> words{0, 0x8080, 0xffff};
  EXPECT_EQ(decode_image(encode_rgb_png(1, 1, words)).rgba,
            (std::vector<std::uint8_t>{0, 128, 255, 255}));
}

TEST(DecodedImage, RefusesOtherKindsByName) {
  EXPECT_EQ(reason_of(std::string("\xabKTX 20\xbb\r\n\x1a\n")),
            "is of the kind KTX2; accepted: PNG, JPEG, WebP");
  EXPECT_NE(reason_of("DDS |").find("DDS"), std::string::npos);
  EXPECT_NE(reason_of("").find("unknown"), std::string::npos);
}

TEST(DecodedImage, RefusesHugeImagesBeforeDecoding) {
  EXPECT_NE(reason_of(png_of_size(16385, 1)), "accepted");
  EXPECT_NE(reason_of(png_of_size(16384, 16384)).find("16384 x 16384 texels"), std::string::npos);
  EXPECT_NE(reason_of(png_of_size(0x7fffffff, 0x7fffffff)), "accepted");
  std::string jpeg = two_halves_jpeg();
  const size_t frame = jpeg.find("\xff\xc0");
  put_big_endian(jpeg, frame + 5, 65000, 2);
  put_big_endian(jpeg, frame + 7, 65000, 2);
  EXPECT_NE(reason_of(jpeg).find("65000 x 65000 texels"), std::string::npos);
}

// A damaged file is decoded or refused; the sanitizers see to the rest.
TEST(DecodedImage, SurvivesDamage) {
  std::mt19937 random(5);
  int num_refused = 0, num_accepted = 0;
  for (const std::string& whole : {few_texels_png(), few_texels_webp(), two_halves_jpeg()}) {
    for (size_t size = 0; size < whole.size(); ++size)
      EXPECT_NE(reason_of(whole.substr(0, size)), "") << image_kind(whole) << " cut at " << size;
    for (int round = 0; round < 400; ++round) {
      std::string damaged = whole;
      for (unsigned hits = 1 + random() % 3; hits-- > 0;)
        damaged[random() % damaged.size()] = static_cast<char>(random());
      reason_of(damaged) == "accepted" ? ++num_accepted : ++num_refused;
    }
    EXPECT_NE(reason_of(whole.substr(0, whole.size() / 2)), "accepted") << image_kind(whole);
  }
  EXPECT_GT(num_refused, 300);
  EXPECT_GT(num_accepted, 50);
}

DecodedImage random_image(int width, int height, std::mt19937& random) {
  DecodedImage image{width, height, {}};
  for (int i = 0; i < 4 * width * height; ++i)
    image.rgba.push_back(static_cast<std::uint8_t>(random()));
  return image;
}

// Mean over the area of texel (x, y) of a level of width x height, in doubles.
std::array<double, 4> mean_over_area(const DecodedImage& image, int x, int y, int width, int height,
                                     bool srgb) {
  std::array<double, 4> sum{};
  double area = 0, seen = 0;
  for (int j = 0; j < image.height; ++j)
    for (int i = 0; i < image.width; ++i) {
      const auto overlap = [](int at, int size, int coarse, int fine) {
        const double begin = double(at) * fine / size, end = double(at + 1) * fine / size;
        return std::max(0.0, std::min(end, coarse + 1.0) - std::max(begin, double(coarse)));
      };
      const double weight = overlap(x, width, i, image.width) * overlap(y, height, j, image.height);
      if (weight <= 0) continue;
      const std::uint8_t* const p = image.rgba.data() + 4 * (j * image.width + i);
      const double share = srgb ? p[3] : 1;
      for (size_t k = 0; k < 3; ++k)
        sum[k] += weight * share * (srgb ? linear_from_srgb(float(p[k]) / 255) : p[k]);
      sum[3] += weight * p[3];
      area += weight, seen += weight * share;
    }
  for (size_t k = 0; k < 3; ++k) {
    sum[k] /= seen;
    if (srgb) sum[k] = 255 * srgb_from_linear(static_cast<float>(sum[k]));
  }
  sum[3] /= area;
  return sum;
}

TEST(TextureImage, HalvesByAreaInLinearLight) {
  std::mt19937 random(7);
  for (const auto& [width, height] : {std::pair(2, 2), {5, 3}, {7, 1}, {1, 9}, {6, 13}, {16, 8}})
    for (const bool srgb : {false, true}) {
      const DecodedImage image = random_image(width, height, random);
      const TextureImage texture = make_texture_image(image, srgb);
      ASSERT_GT(texture.levels.size(), 1u);
      const DecodedImage& half = texture.levels[1];
      EXPECT_EQ(half.width, std::max(width / 2, 1));
      EXPECT_EQ(half.height, std::max(height / 2, 1));
      for (int y = 0; y < half.height; ++y)
        for (int x = 0; x < half.width; ++x) {
          const auto expected = mean_over_area(image, x, y, half.width, half.height, srgb);
          for (int k = 0; k < 4; ++k)
            EXPECT_NEAR(half.rgba[size_t(4 * (y * half.width + x) + k)], expected[size_t(k)], 1.3)
                << width << " x " << height << (srgb ? " sRGB" : "");
        }
      EXPECT_EQ(texture.levels.back().rgba.size(), 4u);
    }
}

TEST(TextureImage, AveragesBlackAndWhiteAsLight) {
  const DecodedImage checker{2, 1, {0, 0, 0, 255, 255, 255, 255, 255}};
  EXPECT_EQ(make_texture_image(checker, true).levels.back().rgba[0], 188);
  EXPECT_EQ(make_texture_image(checker, false).levels.back().rgba[0], 128);
}

TEST(TextureImage, KeepsColourOfWhatIsSeen) {
  const DecodedImage leaf{2, 1, {0, 255, 0, 255, 255, 0, 255, 0}};  // magenta is cut out
  const TextureImage texture = make_texture_image(leaf, true);
  EXPECT_TRUE(texture.has_alpha);
  EXPECT_EQ(texture.levels.back().rgba, (std::vector<std::uint8_t>{0, 255, 0, 128}));
}

TEST(TextureImage, DropsLevelsAboveTheLargestSide) {
  std::mt19937 random(9);
  const TextureImage texture = make_texture_image(random_image(64, 16, random), true, 20);
  EXPECT_EQ(texture.levels.front().width, 16);
  EXPECT_EQ(texture.levels.front().height, 4);
  size_t bytes = 0;
  for (const DecodedImage& level : texture.levels) bytes += level.rgba.size();
  EXPECT_EQ(texture.num_bytes(), bytes);
}

}  // namespace
}  // namespace trivet
