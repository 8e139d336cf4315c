#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "core/motion/height.h"
#include "support/effort.h"
#include "support/random_shapes.h"

namespace trivet {
namespace {

constexpr auto kTurn = Motion::Kind::Rotation;
constexpr auto kSlide = Motion::Kind::Translation;

Motion any_motion(int index, test::Random& random) {
  return test::random_motion(index % 2 == 1, random.in_cube(3), 2, random);
}

TEST(Motion, MeasuresTranslationByLength) {
  const Motion m = Motion::translation(-Vec3::UnitZ(), 5);
  EXPECT_EQ(moved_point({1, 2, 3}, m, 0.5), Vec3(1, 2, 2.5));
  EXPECT_EQ(moved_point({1, 2, 3}, m, 0), Vec3(1, 2, 3));
}

TEST(Motion, MeasuresRightHandedTurnsByTangentOfHalfAngle) {
  const Motion m = Motion::rotation(Vec3(1, 0, 0), Vec3::UnitZ(), 1);
  EXPECT_LT((moved_point({2, 0, 7}, m, 1) - Vec3(1, 1, 7)).norm(), 1e-15);  // a quarter turn
  const double s = std::tan(0.5 * M_PI / 6);
  EXPECT_LT((moved_point({2, 0, 7}, m, s) - Vec3(1 + std::cos(M_PI / 6), 0.5, 7)).norm(), 1e-15);
}

TEST(Motion, KeepsPointsOnAxisBitForBit) {
  test::Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const Vec3 centre = random.in_cube(10);
    const Motion m = Motion::rotation(centre, Vec3::Unit(i % 3), 1);
    EXPECT_EQ(moved_point(centre, m, random.uniform(0, 1)), centre);
  }
}

TEST(Motion, KeepsTinyTurnsFarFromOrigin) {
  const Vec3 centre(1e6, 0, 0);
  const Motion m = Motion::rotation(centre, Vec3::UnitZ(), 1);
  const Vec3 p = centre + Vec3(1, 0, 0);
  EXPECT_NEAR(moved_point(p, m, 1e-14).y(), 2e-14, 1e-28);
}

TEST(Motion, MovesPointAndPoseAlike) {
  test::Random random(2);
  double worst = 0;
  for (int i = 0; i < 20000; ++i) {
    const Motion m = any_motion(i, random);
    const double time = random.uniform(0, m.limit);
    const Pose pose{random.rotation(), random.in_cube(3)};
    const UpAxis up = random.integer(0, 1) ? UpAxis::Y : UpAxis::Z;
    const double scale = random.uniform(0.5, 2);
    const Vec3 p = random.in_cube(1);
    const Vec3 by_point = moved_point(world_from_object(pose, up, scale).apply(p), m, time);
    const Vec3 by_pose = world_from_object(moved_pose(pose, m, time), up, scale).apply(p);
    worst = std::max(worst, (by_point - by_pose).norm());
  }
  EXPECT_LT(worst, 2e-14);
}

TEST(Motion, PreservesDistances) {
  test::Random random(3);
  for (int i = 0; i < 10000; ++i) {
    const Motion m = any_motion(i, random);
    const double time = random.uniform(0, m.limit);
    const Vec3 p = random.in_cube(3), q = random.in_cube(3);
    EXPECT_NEAR((moved_point(p, m, time) - moved_point(q, m, time)).norm(), (p - q).norm(), 2e-14);
  }
}

TEST(Motion, ComposesTurns) {
  test::Random random(4);
  for (int i = 0; i < 10000; ++i) {
    const Motion m = any_motion(1, random);
    const double first = random.uniform(0, 1), second = random.uniform(0, 0.9);
    const Vec3 p = random.in_cube(3);
    const Vec3 twice = moved_point(moved_point(p, m, first), m, second);
    EXPECT_LT((moved_point(p, m, compose_turns(first, second)) - twice).norm(), 2e-13);
  }
  EXPECT_EQ(compose_turns(0, 0.25), 0.25);
  EXPECT_EQ(compose_turns(0.25, 0), 0.25);
  EXPECT_EQ(compose_turns(1, 1), kInfinity);  // half a turn
  EXPECT_EQ(compose_turns(2, 1), kInfinity);
  EXPECT_EQ(compose_turns(0.5, kInfinity), kInfinity);
}

// --- heights ---------------------------------------------------------------------------------

using Real = long double;

Real height(const HeightFunction& f, Real angle) {
  const Real half = std::sin(angle / 2);  // cos - 1 without cancellation
  return f.f0 - 2 * f.A * half * half + f.B * std::sin(angle);
}

Real size_of(const HeightFunction& f) { return std::abs(f.f0) + std::abs(f.A) + std::abs(f.B); }

/// Every third one nearly grazes zero at its minimum, every third starts next to zero.
HeightFunction random_height(int index, test::Random& random) {
  HeightFunction f{random.uniform(0, 2), random.uniform(-1, 1), random.uniform(-1, 1)};
  if (index % 3 == 1) {
    const double lift = std::pow(10.0, random.uniform(-15, -1)) * random.integer(-1, 1);
    f.f0 = f.A + std::hypot(f.A, f.B) + lift;
  } else if (index % 3 == 2) {
    f.f0 = std::pow(10.0, random.uniform(-12, -1));
  }
  return f;
}

TEST(FirstZero, FindsFirstOfAllZeros) {
  constexpr unsigned kSeed = 5;
  constexpr int kSamples = 200;
  const int num = test::with_effort(100000);
  test::Random random(kSeed);
  int num_zeros = 0, num_wrong = 0;
  for (int i = 0; i < num && num_wrong < 5; ++i) {
    const HeightFunction f = random_height(i, random);
    if (f.f0 <= 0) continue;
    const double s = first_zero(f, kTurn);
    const Real tolerance = 4e-16L * size_of(f),
               end = std::isfinite(s) ? 2 * std::atan(Real(s)) : M_PI;
    bool right = s > 0;
    if (std::isfinite(s)) {
      ++num_zeros;
      right = right && std::abs(height(f, end)) <= tolerance;
    }
    for (int k = 1; k < kSamples && right; ++k) right = height(f, end * k / kSamples) > -tolerance;
    // The minimum on the way, which the samples may straddle.
    const Real lowest = std::atan2(-Real(f.B), -Real(f.A));
    if (lowest > 0 && lowest < end) right = right && height(f, lowest) > -tolerance;
    num_wrong += !right;
    EXPECT_TRUE(right) << std::hexfloat << "first_zero({" << f.f0 << ", " << f.A << ", " << f.B
                       << "}) = " << s;
  }
  std::printf("seed %u: %d of %d heights reach zero\n", kSeed, num_zeros, num);
  EXPECT_GT(num_zeros, 0.3 * num);
  EXPECT_LT(num_zeros, 0.8 * num);
}

TEST(PositiveUntil, AgreesWithFirstZero) {
  test::Random random(7);
  int num_clear = 0, num_compared = 0;
  for (int i = 0; i < 100000; ++i) {
    const HeightFunction f = random_height(i, random);
    const double horizon = i % 4 == 0 ? 1e300 : random.uniform(0, 1.2);
    for (const auto kind : {kTurn, kSlide}) {
      const double zero = first_zero(f, kind);
      const double end = kind == kTurn ? std::min(horizon, 1.0) : horizon;
      if (std::abs(zero - end) < 1e-6) continue;  // either result, to rounding
      // A graze: contact depends on rounding too.
      if (std::abs(f.B * f.B - f.f0 * (f.f0 - 2 * f.A)) < 1e-12 && kind == kTurn) continue;
      ++num_compared;
      num_clear += zero > end;
      EXPECT_EQ(positive_until(f, kind, horizon), zero > end)
          << std::hexfloat << f.f0 << ", " << f.A << ", " << f.B << " until " << horizon;
    }
  }
  EXPECT_GT(num_compared, 150000);
  EXPECT_GT(num_clear, 0.3 * num_compared);
  EXPECT_LT(num_clear, 0.8 * num_compared);
}

TEST(FirstZero, KeepsAllDigitsOfSmallTurns) {
  test::Random random(6);
  double worst = 0;
  for (int i = 0; i < 20000; ++i) {
    const Real angle = std::pow(Real(10), Real(random.uniform(-9, -1))), half = std::sin(angle / 2);
    HeightFunction f{0, random.uniform(-1, 1), random.uniform(-1, -0.1)};
    f.f0 = static_cast<double>(2 * f.A * half * half - f.B * std::sin(angle));
    if (height(f, angle / 2) < 0) continue;
    const Real s = first_zero(f, kTurn);
    worst = std::max(worst, static_cast<double>(std::abs(s / std::tan(angle / 2) - 1)));
  }
  EXPECT_LT(worst, 1e-14);
}

TEST(FirstZero, SolvesSpecialHeights) {
  EXPECT_EQ(first_zero({0, -1, -1}, kTurn), 0);
  EXPECT_EQ(first_zero({-1, 1, 1}, kTurn), 0);
  EXPECT_EQ(first_zero({1, 0, 0}, kTurn), kInfinity);
  EXPECT_EQ(first_zero({1, 0, 1}, kTurn), kInfinity);   // back to 1 after half a turn
  EXPECT_EQ(first_zero({1, 0, -1}, kTurn), 1);          // grazes after a quarter turn
  EXPECT_EQ(first_zero({1, 1, 0}, kTurn), 1);           // cos is 0 after a quarter turn
  EXPECT_EQ(first_zero({1, -5, 0}, kTurn), kInfinity);  // only rises
  EXPECT_DOUBLE_EQ(first_zero({1, 1, 1}, kTurn), std::tan(3 * M_PI / 8));  // up first, then down
}

TEST(FirstZero, SolvesTranslations) {
  EXPECT_EQ(first_zero({3, 0, -2}, kSlide), 1.5);
  EXPECT_EQ(first_zero({3, 0, 2}, kSlide), kInfinity);
  EXPECT_EQ(first_zero({3, 0, 0}, kSlide), kInfinity);
  EXPECT_EQ(first_zero({0, 0, -2}, kSlide), 0);
  EXPECT_EQ(first_zero({-1, 0, 2}, kSlide), 0);
}

}  // namespace
}  // namespace trivet
