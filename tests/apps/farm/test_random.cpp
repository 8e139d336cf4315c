// The numbers that scenes are drawn with.
#include <gtest/gtest.h>

#include <cmath>

#include "apps/farm/recipe/decisions.h"
#include "apps/farm/recipe/sha256.h"

namespace trivet::farm {
namespace {

// Random123's kat_vectors.
TEST(Philox, GivesKnownAnswers) {
  constexpr std::uint32_t kAll = 0xFFFFFFFF;
  EXPECT_EQ(philox({0, 0}, {0, 0, 0, 0}),
            (PhiloxBlock{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
  EXPECT_EQ(philox({kAll, kAll}, {kAll, kAll, kAll, kAll}),
            (PhiloxBlock{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
  EXPECT_EQ(philox({0xa4093822, 0x299f31d0}, {0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}),
            (PhiloxBlock{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

// FIPS 180-2, appendix B.
TEST(Sha256, GivesKnownAnswers) {
  EXPECT_EQ(sha256_hex("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256_hex(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  Sha256 in_parts;
  in_parts.add("a");
  in_parts.add("bc");
  EXPECT_EQ(hex(in_parts.digest()), sha256_hex("abc"));
}

TEST(Decision, IsAFunctionOfKeySceneAndName) {
  const std::uint64_t first = Decision({1, 2}, 3, "cup/scale").bits();
  EXPECT_EQ(Decision({1, 2}, 3, "cup/scale").bits(), first);
  EXPECT_NE(Decision({1, 3}, 3, "cup/scale").bits(), first);
  EXPECT_NE(Decision({1, 2}, 4, "cup/scale").bits(), first);
  EXPECT_NE(Decision({1, 2}, 3 + (std::uint64_t{1} << 32), "cup/scale").bits(), first);
  EXPECT_NE(Decision({1, 2}, 3, "cup/model").bits(), first);
  Decision decision({1, 2}, 3, "cup/scale");
  decision.bits();
  EXPECT_NE(decision.bits(), first);
}

// Values of a program of its own (Python). Old batches are made again only as long as they stay.
TEST(Decision, KeepsItsValues) {
  EXPECT_EQ(Decision({1, 2}, 3, "cup/scale").bits(), 0xe2bdb5403e776874ull);
  EXPECT_EQ(Decision({1, 2}, 3, "cup/scale").unit(), 0x1.c57b6a807ceedp-1);
  const Rotation r = Decision({1, 2}, 3, "cup/rotation").any_rotation();
  EXPECT_EQ(r.w, 0x1.741500edcc16fp-1);
}

// Counts of 60,000 draws: bands of 5 standard deviations.
TEST(Decision, DrawsEvenly) {
  constexpr int kDraws = 60'000;
  Decision decision({7, 8}, 9, "even");
  std::array<int, 6> counts{}, weighted{};
  double sum = 0, squares = 0;
  for (int i = 0; i < kDraws; ++i) {
    const int drawn = decision.count({-2, 3});
    ASSERT_TRUE(-2 <= drawn && drawn <= 3);
    ++counts[static_cast<size_t>(drawn + 2)];
    ++weighted[decision.weighted({1, 0.5, 2.5})];
    const double x = decision.within({-1, 1});
    ASSERT_TRUE(-1 <= x && x <= 1);
    sum += x;
    squares += x * x;
  }
  const auto near = [&](double count, double share) {
    return std::abs(count - kDraws * share) < 5 * std::sqrt(kDraws * share * (1 - share));
  };
  for (const int count : counts) EXPECT_TRUE(near(count, 1.0 / 6)) << count;
  EXPECT_TRUE(near(weighted[0], 0.25)) << weighted[0];
  EXPECT_TRUE(near(weighted[1], 0.125)) << weighted[1];
  EXPECT_TRUE(near(weighted[2], 0.625)) << weighted[2];
  EXPECT_NEAR(sum / kDraws, 0, 5 * std::sqrt(1.0 / 3 / kDraws));
  EXPECT_NEAR(squares / kDraws, 1.0 / 3, 5 * std::sqrt(4.0 / 45 / kDraws));
}

// Uniform rotations: the square of a quaternion's component is 1/4 in the mean, 1/8 its square.
TEST(Decision, TurnsEvenly) {
  constexpr int kDraws = 20'000;
  Decision decision({7, 8}, 9, "turns");
  std::array<double, 4> squares{};
  double yaw_square = 0, radius_square = 0;
  for (int i = 0; i < kDraws; ++i) {
    const Rotation r = decision.any_rotation();
    const std::array<double, 4> c{r.w, r.x, r.y, r.z};
    double length = 0;
    for (size_t j = 0; j < 4; ++j) {
      squares[j] += c[j] * c[j];
      length += c[j] * c[j];
    }
    ASSERT_NEAR(length, 1, 1e-15);
    const Rotation yaw = decision.yaw();
    ASSERT_NEAR(yaw.w * yaw.w + yaw.z * yaw.z, 1, 1e-15);
    ASSERT_EQ(yaw.x, 0);
    yaw_square += yaw.w * yaw.w;
    const Vec2 p = decision.in_disc();
    ASSERT_LE(p.squaredNorm(), 1);
    radius_square += p.squaredNorm();
  }
  for (const double square : squares)
    EXPECT_NEAR(square / kDraws, 0.25, 5 * std::sqrt((1.0 / 8 - 1.0 / 16) / kDraws));
  EXPECT_NEAR(yaw_square / kDraws, 0.5, 5 * std::sqrt(1.0 / 8 / kDraws));
  EXPECT_NEAR(radius_square / kDraws, 0.5, 5 * std::sqrt(1.0 / 12 / kDraws));
}

}  // namespace
}  // namespace trivet::farm
