#include <gtest/gtest.h>

#include <cmath>

#include "core/exact/orientation_stages.h"
#include "core/exact/predicates.h"
#include "integer_reference.h"

namespace trivet::test {
namespace {

constexpr unsigned kOrientationSeed = 20240611;

struct Four {
  Vec3 a, b, c, d;
};

enum class FourPoints {
  Random,
  Grid,            // tiny integers
  NearlyCoplanar,  // a few ulps from a plane
  Coplanar,        // exactly, far from the origin
  PowersOfTwo,     // each axis has its own exponent
  WildExponents,   // each coordinate has its own exponent
  NearlyCoplanarTiny,
  Repeated,
};
constexpr int kNumFourPoints = 8;

Vec3 combination(const Vec3& a, const Vec3& b, const Vec3& c, double s, double t) {
  return a + s * (b - a) + t * (c - a);
}

Four nearly_coplanar(Source& source) {
  Four p{source.point(-1, 1), source.point(-1, 1), source.point(-1, 1), {}};
  const double s = source.uniform(-2, 2);
  p.d = source.moved(combination(p.a, p.b, p.c, s, source.uniform(-2, 2)), 2);
  return p;
}

Four coplanar(Source& source) {
  Four p{
      source.grid_point(-999, 999), source.grid_point(-999, 999), source.grid_point(-999, 999), {}};
  const int s = source.integer(-9, 9);
  p.d = combination(p.a, p.b, p.c, s, source.integer(-9, 9));
  const Vec3 offset = source.grid_point(-1000000, 1000000);
  const double scale = std::ldexp(1.0, source.integer(-150, 150));
  for (Vec3* q : {&p.a, &p.b, &p.c, &p.d}) *q = scale * (*q + offset);
  return p;
}

void scale_axes(Source& source, Four& p, int lowest, int highest) {
  for (int k = 0; k < 3; ++k) {
    const int exponent = source.integer(lowest, highest);
    for (Vec3* q : {&p.a, &p.b, &p.c, &p.d}) (*q)[k] = std::ldexp((*q)[k], exponent);
  }
}

Vec3 wild_point(Source& source) {
  Vec3 p = source.point(-1, 1);
  for (double& x : p) x = std::ldexp(x, source.integer(-180, 180));
  return p;
}

Four make(Source& source, FourPoints kind) {
  Four p{source.point(-1, 1), source.point(-1, 1), source.point(-1, 1), source.point(-1, 1)};
  const auto grid = [&] { return source.grid_point(0, 3); };
  switch (kind) {
    case FourPoints::Random:
      break;
    case FourPoints::Grid:
      p = {grid(), grid(), grid(), grid()};
      break;
    case FourPoints::NearlyCoplanar:
      return nearly_coplanar(source);
    case FourPoints::Coplanar:
      return coplanar(source);
    case FourPoints::PowersOfTwo:
      scale_axes(source, p, -200, 230);
      break;
    case FourPoints::WildExponents:
      p = {wild_point(source), wild_point(source), wild_point(source), wild_point(source)};
      break;
    case FourPoints::NearlyCoplanarTiny:
      p = nearly_coplanar(source);
      scale_axes(source, p, -160, -120);
      break;
    case FourPoints::Repeated:
      p.d = source.integer(0, 1) ? p.a : p.b;
      p.c.x() = source.integer(0, 1) ? p.a.x() : p.c.x();
      break;
  }
  return p;
}

struct Tally {
  int cases = 0, exact = 0, zero = 0;
  void add(bool filtered, int sign) { ++cases, exact += !filtered, zero += sign == 0; }
};

void print(const char* name, const Tally& t) {
  std::printf("%s, seed %u: %d cases, %.1f %% exact stage, %.1f %% zero\n", name, kOrientationSeed,
              t.cases, 100.0 * t.exact / t.cases, 100.0 * t.zero / t.cases);
}

void expect_band(double fraction, double lower, double upper) {
  EXPECT_GE(fraction, lower);
  EXPECT_LE(fraction, upper);
}

}  // namespace

TEST(Orientation, FollowsSignConvention) {
  const Vec3 a(0, 0, 0), b(1, 0, 0), c(0, 1, 0);
  EXPECT_EQ(orient3d(a, b, c, Vec3(0.3, 0.3, -1)), 1);
  EXPECT_EQ(orient3d(a, b, c, Vec3(0.3, 0.3, 1)), -1);
  EXPECT_EQ(orient3d(a, b, c, Vec3(7, -5, 0)), 0);
  EXPECT_EQ(orient2d({0, 0}, {1, 0}, {0, 1}), 1);
  EXPECT_EQ(orient2d({0, 0}, {0, 1}, {1, 0}), -1);
  EXPECT_EQ(orient2d({1, 1}, {2, 2}, {-5, -5}), 0);
}

TEST(Orientation, Orient3dEqualsIntegers) {
  Source source(kOrientationSeed);
  Tally tallies[kNumFourPoints], all;
  for (int i = 0; i < 160000; ++i) {
    const int kind = i % kNumFourPoints;
    const auto [a, b, c, d] = make(source, static_cast<FourPoints>(kind));
    const int truth = reference_orient3d(a, b, c, d);
    const auto filtered = orient3d_filter(a, b, c, d);
    if (filtered) {
      ASSERT_EQ(*filtered, truth) << "kind " << kind << ", case " << i;
    }
    ASSERT_EQ(orient3d_exact(a, b, c, d), truth) << "kind " << kind << ", case " << i;
    ASSERT_EQ(orient3d(a, b, c, d), truth);
    ASSERT_EQ(orient3d(b, a, c, d), -truth);
    ASSERT_EQ(orient3d(b, c, d, a), -truth);
    tallies[kind].add(filtered.has_value(), truth);
    all.add(filtered.has_value(), truth);
  }
  print("orient3d", all);
  for (const Tally& t : tallies) print("  one kind", t);
  expect_band(1.0 * all.exact / all.cases, 0.3, 0.7);
  expect_band(1.0 * all.zero / all.cases, 0.2, 0.5);
  const auto& random = tallies[static_cast<int>(FourPoints::Random)];
  EXPECT_LE(random.exact, random.cases / 10000);
}

TEST(Orientation, Orient2dEqualsIntegers) {
  Source source(kOrientationSeed);
  Tally all;
  for (int i = 0; i < 120000; ++i) {
    auto [p, q, r, s] = make(source, static_cast<FourPoints>(i % kNumFourPoints));
    if (i % 3 == 0) {  // nearly collinear
      r = source.moved(Vec3(p + source.uniform(-2, 2) * (q - p)), 1);
    } else if (i % 3 == 1) {  // collinear, exactly on integers
      r = 2 * q - p;
    }
    const Vec2 a = p.head<2>(), b = q.head<2>(), c = r.head<2>();
    const int truth = reference_orient2d(a, b, c);
    const auto filtered = orient2d_filter(a, b, c);
    if (filtered) {
      ASSERT_EQ(*filtered, truth) << "case " << i;
    }
    ASSERT_EQ(orient2d_exact(a, b, c), truth) << "case " << i;
    ASSERT_EQ(orient2d(a, b, c), truth);
    ASSERT_EQ(orient2d(b, a, c), -truth);
    all.add(filtered.has_value(), truth);
  }
  print("orient2d", all);
  expect_band(1.0 * all.exact / all.cases, 0.3, 0.7);
  expect_band(1.0 * all.zero / all.cases, 0.05, 0.4);
}

// Extremes of the range promised in the header.
TEST(Orientation, IsExactAtEndsOfRange) {
  for (double scale : {1e-70, 1e70}) {
    const double up = std::nextafter(scale, kInfinity);
    const Vec3 a(scale, scale, scale), b(up, scale, scale), c(scale, up, scale), d(up, up, up);
    EXPECT_EQ(orient3d(a, b, c, d), -1) << scale;
    EXPECT_EQ(orient3d(a, b, c, Vec3(up, up, scale)), 0) << scale;
    EXPECT_EQ(orient2d(a.head<2>(), b.head<2>(), c.head<2>()), 1) << scale;
    EXPECT_EQ(orient2d(-a.head<2>(), b.head<2>(), d.head<2>()), 1) << scale;
  }
  const Vec3 tiny(1e-70, 0, 0);
  EXPECT_EQ(orient3d(Vec3(1e70, 0, 0), Vec3(0, 1e70, 0), Vec3(0, 0, 1e70), tiny), 1);
  EXPECT_EQ(orient3d(Vec3(0, 0, 0), Vec3(0, 1e70, 0), Vec3(0, 0, 1e70), tiny), -1);
}

}  // namespace trivet::test
