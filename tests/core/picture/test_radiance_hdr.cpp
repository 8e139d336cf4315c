// Radiance files: known pixels in both packings, and files that are none.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/base/error.h"
#include "core/picture/image_files.h"

namespace trivet {
namespace {

class RadianceHdr : public ::testing::Test {
 protected:
  void SetUp() override {
    try {
      decode_hdr("");
    } catch (const Error& error) {
      if (error.kind() == Error::Kind::Environment) GTEST_SKIP() << error.what();
    }
  }
};

std::string header(int width, int height, const std::string& more = "") {
  return "#?RADIANCE\n# by hand\n" + more + "FORMAT=32-bit_rle_rgbe\n\n-Y " +
         std::to_string(height) + " +X " + std::to_string(width) + "\n";
}

std::string rgbe(int r, int g, int b, int e) {
  return {static_cast<char>(r), static_cast<char>(g), static_cast<char>(b), static_cast<char>(e)};
}

TEST_F(RadianceHdr, PlainPixelsAreShareOfTwoToTheExponent) {
  const FloatImage image = decode_hdr(header(2, 2) + rgbe(128, 64, 0, 129) + rgbe(255, 1, 2, 128) +
                                      rgbe(9, 9, 9, 0) + rgbe(128, 128, 128, 138));
  ASSERT_EQ(image.width, 2);
  ASSERT_EQ(image.height, 2);
  const std::vector<float> expected{1, 0.5f, 0, 255 / 256.0f, 1 / 256.0f, 2 / 256.0f,
                                    0, 0,    0, 512,          512,        512};
  EXPECT_EQ(image.rgb, expected);
}

// Two rows of eight, packed by channel.
std::string packed_rows() {
  std::string packed{2, 2, 0, 8};
  packed += std::string{char(128 + 8), 10};                   // red: a run
  packed += std::string{8, 1, 2, 3, 4, 5, 6, 7, 8};           // green: as they are
  packed += std::string{char(128 + 3), 7, 5, 1, 1, 1, 1, 9};  // blue: both
  packed += std::string{char(128 + 8), char(136)};            // exponents
  packed += std::string{2, 2, 0, 8};
  for (const int value : {20, 30, 40, 136}) packed += std::string{char(128 + 8), char(value)};
  return packed;
}

TEST_F(RadianceHdr, RunsGiveTheSamePixels) {
  const FloatImage image = decode_hdr(header(8, 2) + packed_rows());
  for (int x = 0; x < 8; ++x) {
    EXPECT_EQ(image.rgb[3 * x], 10);
    EXPECT_EQ(image.rgb[3 * x + 1], x + 1);
    EXPECT_EQ(image.rgb[3 * x + 2], x < 3 ? 7 : x < 7 ? 1 : 9);
    EXPECT_EQ(image.rgb[24 + 3 * x], 20);
    EXPECT_EQ(image.rgb[24 + 3 * x + 2], 40);
  }
}

TEST_F(RadianceHdr, ExposureIsTakenBack) {
  const std::string pixel = rgbe(128, 128, 128, 129);
  EXPECT_EQ(decode_hdr(header(1, 1, "EXPOSURE=4\n") + pixel).rgb[0], 0.25f);
  EXPECT_EQ(decode_hdr(header(1, 1, "EXPOSURE=4\nEXPOSURE=0.5\n") + pixel).rgb[0], 0.5f);
  EXPECT_THROW(decode_hdr(header(1, 1, "EXPOSURE=0\n") + pixel), Error);
  EXPECT_THROW(decode_hdr(header(1, 1, "EXPOSURE=nan\n") + pixel), Error);
}

TEST_F(RadianceHdr, RefusesWhatIsNone) {
  const std::string pixel = rgbe(1, 2, 3, 128);
  const std::string good = header(2, 1) + pixel + pixel;
  EXPECT_EQ(decode_hdr(good).rgb.size(), 6u);
  for (size_t size = 0; size < good.size(); ++size)
    EXPECT_THROW(decode_hdr(good.substr(0, size)), Error) << size;
  EXPECT_THROW(decode_hdr("#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 1\n" + pixel), Error);
  EXPECT_THROW(decode_hdr("#?RADIANCE\n\n+X 1 -Y 1\n" + pixel), Error);
  EXPECT_THROW(decode_hdr("#?RADIANCE\n\n-Y -1 +X 1\n" + pixel), Error);
  EXPECT_THROW(decode_hdr(header(100000, 100000)), Error);
  EXPECT_THROW(decode_hdr(header(16384, 4096)), Error) << "a small file asks for much memory";
  EXPECT_THROW(decode_hdr(header(2, 1) + rgbe(1, 1, 1, 2)), Error) << "nothing to repeat";
  EXPECT_THROW(decode_hdr(header(2, 1) + pixel + rgbe(1, 1, 1, 9)), Error);
  EXPECT_THROW(decode_hdr(header(8, 1) + std::string{2, 2, 0, 8, char(128 + 9), 1}), Error);
  EXPECT_THROW(decode_hdr(header(8, 1) + std::string{2, 2, 0, 8, 0, 0, 0, 0}), Error);
}

TEST_F(RadianceHdr, RowsThatEndEarlyAreRefusedAtEveryByte) {
  const std::string good = header(8, 2) + packed_rows();
  EXPECT_EQ(decode_hdr(good + "more").rgb.size(), 48u);
  for (size_t size = 0; size < good.size(); ++size)
    EXPECT_THROW(decode_hdr(good.substr(0, size)), Error) << size;
}

// Bytes that are zero, one, many or random: an image of the size it says, or an error.
TEST_F(RadianceHdr, MutantsNeitherCrashNorHang) {
  const std::string plain = header(9, 3, "EXPOSURE=2\n") + std::string(4 * 27, 'a');
  std::mt19937 random(5);
  int num_read = 0, num_refused = 0;
  for (const std::string& good : {header(8, 2) + packed_rows(), plain})
    for (int i = 0; i < 4000; ++i) {
      std::string bytes = good;
      for (int k = 0; k <= i % 3; ++k) {
        const int values[] = {0, 1, 2, 127, 128, 129, 255, int(random() % 256)};
        bytes[random() % bytes.size()] = static_cast<char>(values[random() % 8]);
      }
      if (i % 5 == 0) bytes.resize(random() % bytes.size());
      try {
        const FloatImage image = decode_hdr(bytes);
        EXPECT_EQ(image.rgb.size(), 3u * size_t(image.width) * size_t(image.height));
        ++num_read;
      } catch (const Error& error) {
        EXPECT_EQ(error.kind(), Error::Kind::BadInput) << error.what();
        ++num_refused;
      }
    }
  EXPECT_GT(num_read, 800);
  EXPECT_GT(num_refused, 800);
}

TEST_F(RadianceHdr, EitherKindIsKnownByItsFirstBytes) {
  EXPECT_EQ(decode_float_image(header(1, 1) + rgbe(128, 0, 0, 129)).rgb[0], 1);
  EXPECT_THROW(decode_float_image("v/1 no image"), Error);
}

}  // namespace
}  // namespace trivet
