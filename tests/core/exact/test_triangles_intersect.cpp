#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "core/exact/predicates.h"
#include "integer_reference.h"
#include "support/effort.h"

namespace trivet::test {
namespace {

constexpr unsigned kPairSeed = 20240612;

struct Pair {
  Triangle a, b;
};

enum class PairKind {
  Random,
  Grid,
  SmallGrid,
  Coplanar,
  SharedCorner,
  SharedEdge,
  Degenerate,
  Touching
};
constexpr int kNumPairKinds = 8;

Triangle grid_triangle(Source& source, int upper) {
  return {source.grid_point(0, upper), source.grid_point(0, upper), source.grid_point(0, upper)};
}

Triangle random_triangle(Source& source) {
  return {source.point(0, 1), source.point(0, 1), source.point(0, 1)};
}

// In one oblique plane, on integer coordinates.
Pair coplanar_pair(Source& source) {
  const Vec3 u = source.grid_point(-3, 3), v = source.grid_point(-3, 3),
             offset = source.grid_point(-1000, 1000);
  Pair out;
  for (Triangle* t : {&out.a, &out.b})
    for (Vec3& p : *t) {
      const int s = source.integer(0, 5);
      p = offset + s * u + source.integer(0, 5) * v;
    }
  return out;
}

// A corner of b lies on a, to within an ulp; or on one of its edges.
Pair touching_pair(Source& source) {
  Pair out{random_triangle(source), random_triangle(source)};
  const double s = source.uniform(0, 1);
  const double t = source.integer(0, 1) ? 0 : source.uniform(0, 1 - s);
  const Triangle& a = out.a;
  out.b[0] = source.moved(Vec3(a[0] + s * (a[1] - a[0]) + t * (a[2] - a[0])), 1);
  const Vec3 normal = (a[1] - a[0]).cross(a[2] - a[0]);
  for (int k = 1; k < 3; ++k)
    out.b[k] = out.b[0] + source.uniform(0, 2) * normal + 0.1 * source.point(-1, 1);
  return out;
}

Pair degenerate_pair(Source& source) {
  Pair out{grid_triangle(source, 3), grid_triangle(source, 3)};
  out.a[2] = source.integer(0, 1) ? out.a[1] : Vec3(2 * out.a[1] - out.a[0]);
  switch (source.integer(0, 3)) {
    case 0:
      out.b[1] = out.b[0];
      break;
    case 1:
      out.a[1] = out.a[2] = out.a[0];
      break;
    case 2:
      out.b[0] = out.b[1] = out.b[2];
      break;
  }
  return out;
}

Pair make(Source& source, PairKind kind) {
  Pair out{random_triangle(source), random_triangle(source)};
  switch (kind) {
    case PairKind::Random:
      break;
    case PairKind::Grid:
      return {grid_triangle(source, 3), grid_triangle(source, 3)};
    case PairKind::SmallGrid:
      return {grid_triangle(source, 1), grid_triangle(source, 2)};
    case PairKind::Coplanar:
      return coplanar_pair(source);
    case PairKind::SharedCorner:
      out.b[0] = out.a[0];
      for (int k = 1; k < 3; ++k)
        if (source.integer(0, 1)) out.b[k] += Vec3(1, 1, 1);
      break;
    case PairKind::SharedEdge:
      out.b[0] = source.moved(out.a[0], 1);
      out.b[1] = source.moved(out.a[1], 1);
      break;
    case PairKind::Degenerate:
      return degenerate_pair(source);
    case PairKind::Touching:
      return touching_pair(source);
  }
  return out;
}

std::string describe(const Pair& p) {
  std::ostringstream out;
  out.precision(17);
  for (const Triangle* t : {&p.a, &p.b})
    for (const Vec3& corner : *t) out << "(" << corner.transpose() << ") ";
  return out.str();
}

// Tests all 72 permutations of corners and arguments.
void expect_symmetric(const Pair& p, bool truth) {
  std::array<int, 3> i = {0, 1, 2};
  do {
    std::array<int, 3> j = {0, 1, 2};
    do {
      const Triangle a = {p.a[i[0]], p.a[i[1]], p.a[i[2]]};
      const Triangle b = {p.b[j[0]], p.b[j[1]], p.b[j[2]]};
      ASSERT_EQ(triangles_intersect(a, b), truth) << describe({a, b});
      ASSERT_EQ(triangles_intersect(b, a), truth) << describe({b, a});
    } while (std::next_permutation(j.begin(), j.end()));
  } while (std::next_permutation(i.begin(), i.end()));
}

}  // namespace

TEST(TrianglesIntersect, EqualsLinearProgram) {
  Source source(kPairSeed);
  std::array<int, kNumPairKinds> hits{};
  const int num_cases = with_effort(10000);
  for (int i = 0; i < num_cases * kNumPairKinds; ++i) {
    const Pair p = make(source, static_cast<PairKind>(i % kNumPairKinds));
    const bool truth = reference_intersect(p.a, p.b);
    hits[i % kNumPairKinds] += truth;
    ASSERT_NO_FATAL_FAILURE(expect_symmetric(p, truth)) << "case " << i;
  }
  std::printf("seed %u, %% that intersect by kind:", kPairSeed);
  for (int h : hits) {
    std::printf(" %.1f", 100.0 * h / num_cases);
    EXPECT_GE(h, num_cases / 50);
  }
  std::printf("\n");
  for (PairKind k : {PairKind::Random, PairKind::Grid, PairKind::Coplanar, PairKind::Degenerate,
                     PairKind::Touching})
    EXPECT_LE(hits[static_cast<int>(k)], num_cases * 9 / 10);
}

TEST(TrianglesIntersect, DecidesNamedCases) {
  const Triangle t = {Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 4, 0)};
  const auto hits = [&](const Vec3& a, const Vec3& b, const Vec3& c) {
    const Triangle u = {a, b, c};
    expect_symmetric({t, u}, reference_intersect(t, u));
    return triangles_intersect(t, u);
  };
  EXPECT_TRUE(hits({1, 1, -1}, {1, 1, 1}, {9, 9, 1})) << "pierces";
  EXPECT_TRUE(hits({1, 1, 0}, {1, 1, 0}, {1, 1, 0})) << "point inside";
  EXPECT_TRUE(hits({2, 2, 0}, {5, 5, 1}, {5, 5, 2})) << "corner on an edge";
  EXPECT_FALSE(hits({2, 2, 0x1p-60}, {5, 5, 1}, {5, 5, 2})) << "corner over an edge";
  EXPECT_TRUE(hits({-1, 0, 0}, {9, 0, 0}, {5, 0, 5})) << "edge on an edge";
  EXPECT_TRUE(hits({1, 1, 0}, {2, 1, 0}, {1, 2, 0})) << "coplanar inside";
  EXPECT_FALSE(hits({3, 3, 0}, {3, 4, 0}, {4, 3, 0})) << "coplanar outside, boxes overlap";
  EXPECT_FALSE(hits({1, 1, 1}, {2, 1, 1}, {1, 2, 1})) << "parallel";
  EXPECT_TRUE(hits({1, 1, -1}, {1, 1, 1}, {1, 1, 0})) << "segment through";
  EXPECT_FALSE(hits({3, 3, -1}, {3, 3, 1}, {3, 3, 1})) << "segment past";
}

}  // namespace trivet::test
