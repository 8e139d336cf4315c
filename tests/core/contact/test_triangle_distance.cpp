#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "core/contact/triangle_distance.h"
#include "reference_distance.h"
#include "support/effort.h"
#include "support/random_shapes.h"

namespace trivet {
namespace {

using Features = ClosestPoints::Features;
using test::extent;

double distance_to(const Vec3& p, const Triangle& t) {
  return static_cast<double>(test::reference_distance({p, p, p}, t));
}

/// Compares the distance with the reference and checks that the points are on the triangles.
/// @return the error, relative to the coordinates.
double error_of(const Triangle& a, const Triangle& b) {
  const ClosestPoints c = closest_points(a, b);
  const double truth = static_cast<double>(test::reference_distance(a, b)), size = extent(a, b);
  double error = std::abs(c.distance - truth);
  if (c.features == Features::Crossing) {
    EXPECT_EQ(c.distance, 0);
  } else {
    error = std::max({error, std::abs((c.point_a - c.point_b).norm() - c.distance),
                      distance_to(c.point_a, a), distance_to(c.point_b, b)});
  }
  return error / size;
}

TEST(ClosestPoints, AgreeWithLeastSquaresOverAllFeatures) {
  constexpr unsigned kSeed = 11;
  const int num_pairs = test::with_effort(60000);
  test::Random random(kSeed);
  double worst_round = 0, worst_needle = 0;
  int num_crossing = 0, num_features[5] = {}, num_wrong = 0;
  for (int i = 0; i < num_pairs && num_wrong < 5; ++i) {
    const auto [a, b] = test::random_pair(i, random);
    const double error = error_of(a, b);
    const ClosestPoints c = closest_points(a, b);
    num_crossing += c.distance == 0;
    ++num_features[static_cast<int>(c.features)];
    const double allowed = test::distance_tolerance(a, b);
    double& worst = allowed > 4e-15 ? worst_needle : worst_round;
    worst = std::max(worst, error);
    num_wrong += !(error <= allowed);
    EXPECT_LE(error, allowed) << "seed " << kSeed << ", pair " << i;
  }
  std::printf(
      "seed %u: worst error %.2g of the coordinates, with needles %.2g; %d vertex-face, %d "
      "face-vertex, "
      "%d edge-edge, "
      "%d ends, %d crossing of %d\n",
      kSeed, worst_round, worst_needle, num_features[0], num_features[1], num_features[2],
      num_features[3], num_crossing, num_pairs);
  for (const int n : num_features) EXPECT_GT(n, 0.01 * num_pairs);
  EXPECT_LT(num_crossing, 0.5 * num_pairs);
}

TEST(ClosestPoints, AreCloserThanAllSamples) {
  test::Random random(12);
  const auto sample = [&](const Triangle& t) {
    double u = random.uniform(0, 1), v = random.uniform(0, 1);
    if (u + v > 1) u = 1 - u, v = 1 - v;
    return Vec3(t[0] + u * (t[1] - t[0]) + v * (t[2] - t[0]));
  };
  for (int i = 0; i < test::with_effort(3000); ++i) {
    const auto [a, b] = test::random_pair(i, random);
    const double found = closest_points(a, b).distance;
    for (int k = 0; k < 200; ++k) EXPECT_GE((sample(a) - sample(b)).norm(), found - 1e-14);
  }
}

TEST(ClosestPoints, AreSymmetric) {
  test::Random random(13);
  for (int i = 0; i < 5000; ++i) {
    const auto [a, b] = test::random_pair(i, random);
    EXPECT_NEAR(closest_points(a, b).distance, closest_points(b, a).distance,
                2 * extent(a, b) * test::distance_tolerance(a, b));
  }
}

TEST(ClosestPoints, HandleNeedlesOfEveryThickness) {
  test::Random random(14);
  for (int i = 0; i < test::with_effort(20000); ++i) {
    const double height = std::pow(10.0, random.uniform(-14, -1));
    const Vec3 p = random.in_cube(1), d = random.direction();
    const Triangle needle{p, p + d, p + random.uniform(0, 1) * d + height * random.direction()};
    const Triangle other = test::soup(1, i % 5, random)[0];
    EXPECT_LE(error_of(needle, other), test::distance_tolerance(needle, other)) << height;
  }
}

TEST(ClosestPoints, NameTheFeatures) {
  const Triangle floor{Vec3(-1, -1, 0), Vec3(1, -1, 0), Vec3(0, 1, 0)};
  const Triangle above{Vec3(0, 0, 1), Vec3(1, 0, 2), Vec3(0, 1, 2)};
  ClosestPoints c = closest_points(above, floor);
  EXPECT_EQ(c.features, Features::VertexFace);
  EXPECT_EQ(c.a, 0);
  EXPECT_EQ(c.distance, 1);
  EXPECT_EQ(c.point_b, Vec3::Zero());
  c = closest_points(floor, above);
  EXPECT_EQ(c.features, Features::FaceVertex);
  EXPECT_EQ(c.b, 0);

  const Triangle along_x{Vec3(-1, 0, 1), Vec3(1, 0, 1), Vec3(0, 0, 3)};
  const Triangle along_y{Vec3(0, 0, -3), Vec3(0, -1, 0), Vec3(0, 1, 0)};
  c = closest_points(along_x, along_y);
  EXPECT_EQ(c.features, Features::EdgeEdge);
  EXPECT_EQ(c.a, 0);
  EXPECT_EQ(c.b, 1);
  EXPECT_EQ(c.distance, 1);

  const Triangle beside{Vec3(3, -1, 0), Vec3(5, 0, 0), Vec3(5, -2, 0)};
  c = closest_points(floor, beside);
  EXPECT_EQ(c.features, Features::Other);
  EXPECT_EQ(c.distance, 2);
}

TEST(ClosestPoints, DetectCrossingAndTouching) {
  const Triangle floor{Vec3(-1, -1, 0), Vec3(1, -1, 0), Vec3(0, 1, 0)};
  const Triangle through{Vec3(0, 0, -1), Vec3(0, 0, 1), Vec3(3, 0, 1)};
  EXPECT_EQ(closest_points(floor, through).features, Features::Crossing);
  const Triangle standing{Vec3(0, 0, 0), Vec3(0, 1, 1), Vec3(1, 0, 1)};
  EXPECT_EQ(closest_points(floor, standing).distance, 0);
  const Triangle overlapping{Vec3(0, 0, 0), Vec3(3, 0, 0), Vec3(0, 3, 0)};  // coplanar
  EXPECT_EQ(closest_points(floor, overlapping).distance, 0);
  EXPECT_EQ(closest_points(floor, floor).distance, 0);
  // Coplanar, one inside the other: no edges meet, and no edge pierces.
  const Triangle inside{Vec3(-0.1, -0.1, 0), Vec3(0.1, -0.1, 0), Vec3(0, 0.1, 0)};
  EXPECT_EQ(closest_points(floor, inside).distance, 0);
}

TEST(ClosestPoints, HandleTrianglesWithoutArea) {
  const Vec3 p(0, 0, 0), q(0, 0, 3), r(4, 0, 0);
  EXPECT_EQ(closest_points({p, p, p}, {q, q, q}).distance, 3);
  EXPECT_EQ(closest_points({q, q, q}, {p, r, r}).distance, 3);
  EXPECT_DOUBLE_EQ(closest_points({p, p, p}, {q, r, q}).distance, 2.4);
  EXPECT_EQ(closest_points({p, r, p}, {q, q + r, q}).distance, 3);          // parallel segments
  EXPECT_EQ(closest_points({p, r, p}, {r, p, r}).distance, 0);              // the same segment
  EXPECT_EQ(closest_points({p, r, p}, {2 * r, 3 * r, 2 * r}).distance, 4);  // collinear
}

TEST(ClosestOnSegments, CoversEveryRegionAndParallelSegments) {
  const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();
  SegmentPoints c = closest_on_segments(-x, 2 * x, z - y, 2 * y);
  EXPECT_EQ(c.s, 0.5);
  EXPECT_EQ(c.t, 0.5);
  EXPECT_EQ(c.squared_distance, 1);
  c = closest_on_segments(Vec3::Zero(), x, 3 * x + y, y);
  EXPECT_EQ(c.s, 1);
  EXPECT_EQ(c.t, 0);
  EXPECT_EQ(c.squared_distance, 5);
  EXPECT_EQ(closest_on_segments(Vec3::Zero(), x, 0.5 * x + z, x).squared_distance, 1);
  EXPECT_EQ(closest_on_segments(Vec3::Zero(), x, 2 * x, x).squared_distance, 1);
  EXPECT_EQ(closest_on_segments(Vec3::Zero(), 0 * x, 2 * x, x).squared_distance, 4);
  EXPECT_EQ(closest_on_segments(x, 0 * x, y, 0 * x).squared_distance, 2);
}

}  // namespace
}  // namespace trivet
