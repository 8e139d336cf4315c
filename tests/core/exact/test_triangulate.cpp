// Polygons as triangles: as many as there must be, of the polygon's area, none over another.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "core/exact/predicates.h"
#include "core/exact/triangulate.h"

namespace trivet {
namespace {

using Polygon = std::vector<Vec3>;

double area_of(const Polygon& p, const std::vector<Index3>& triangles) {
  double area = 0;
  for (const Index3& t : triangles) area += (p[t[1]] - p[t[0]]).cross(p[t[2]] - p[t[0]]).norm() / 2;
  return area;
}

double planar_area(const Polygon& p) {
  Vec3 sum = Vec3::Zero();
  for (size_t i = 0; i < p.size(); ++i) sum += p[i].cross(p[(i + 1) % p.size()]);
  return sum.norm() / 2;
}

// Each side of the polygon once, each diagonal twice, in opposite directions.
void expect_sides(const Polygon& p, const std::vector<Index3>& triangles) {
  const auto n = static_cast<Index>(p.size());
  std::vector<std::pair<Index, Index>> sides;
  for (const Index3& t : triangles)
    for (int k = 0; k < 3; ++k) sides.emplace_back(t[k], t[(k + 1) % 3]);
  for (Index i = 0; i < n; ++i) {
    const std::pair side(i, (i + 1) % n);
    EXPECT_EQ(std::count(sides.begin(), sides.end(), side), 1);
  }
  for (const auto& [a, b] : sides)
    if ((a + 1) % n != b) {
      EXPECT_EQ(std::count(sides.begin(), sides.end(), std::pair(b, a)), 1);
    }
}

void expect_cut(const Polygon& polygon) {
  for (size_t first = 0; first < polygon.size(); ++first)
    for (const bool backwards : {false, true}) {
      Polygon p = polygon;
      std::rotate(p.begin(), p.begin() + static_cast<long>(first), p.end());
      if (backwards) std::reverse(p.begin(), p.end());
      std::vector<Index3> triangles;
      EXPECT_TRUE(triangulate(p, triangles));
      EXPECT_EQ(triangles.size(), p.size() - 2);
      expect_sides(p, triangles);
      EXPECT_NEAR(area_of(p, triangles), planar_area(p), 1e-12 * (1 + planar_area(p)));
    }
}

Polygon flat(std::initializer_list<std::pair<double, double>> points) {
  Polygon out;
  for (const auto& [x, y] : points) out.emplace_back(x, y, 0);
  return out;
}

const Polygon kShapes[] = {
    flat({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}),                  // an L
    flat({{0, 0}, {2, 0}, {0.5, 0.5}, {0, 2}}),                              // an arrow
    flat({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}}),  // corners on sides
    flat({{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}}),  // a U
    flat({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {1.5, 2}}),                        // three on a line
    // A frame: a bridge from outside to inside, there and back.
    flat({{0, 0}, {3, 0}, {3, 3}, {0, 3}, {0, 0}, {1, 1}, {1, 2}, {2, 2}, {2, 1}, {1, 1}})};

TEST(Triangulate, CutsConcavePolygons) {
  for (size_t i = 0; i + 1 < std::size(kShapes); ++i) expect_cut(kShapes[i]);
}

TEST(Triangulate, CutsFramesAlongTheirBridges) {
  for (size_t first = 0; first < 10; ++first) {
    Polygon p = kShapes[5];
    std::rotate(p.begin(), p.begin() + static_cast<long>(first), p.end());
    std::vector<Index3> triangles;
    EXPECT_TRUE(triangulate(p, triangles));
    EXPECT_DOUBLE_EQ(area_of(p, triangles), 8);
  }
}

TEST(Triangulate, CutsInAnyPlane) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(-1, 1);
  for (const Polygon& shape : kShapes)
    for (int round = 0; round < 20; ++round) {
      const Eigen::Quaterniond turn(
          Eigen::Vector4d::NullaryExpr([&](Eigen::Index) { return number(random); }).normalized());
      const Vec3 offset = 100 * Vec3::NullaryExpr([&](Eigen::Index) { return number(random); });
      Polygon p;
      for (const Vec3& c : shape) p.push_back(turn * c + offset);
      std::vector<Index3> triangles;
      EXPECT_TRUE(triangulate(p, triangles));
      EXPECT_NEAR(area_of(p, triangles), planar_area(shape), 1e-9);
    }
}

// Stars about a point, every corner as far as chance has it.
TEST(Triangulate, CutsRandomStars) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> radius(0.05, 1);
  for (int round = 0; round < 300; ++round) {
    const int n = 4 + round % 40;
    Polygon p;
    for (int i = 0; i < n; ++i) {
      const double angle = 2 * std::numbers::pi * i / n, r = radius(random);
      p.emplace_back(r * std::cos(angle), r * std::sin(angle), 0);
    }
    std::vector<Index3> triangles;
    ASSERT_TRUE(triangulate(p, triangles));
    EXPECT_NEAR(area_of(p, triangles), planar_area(p), 1e-12);
    expect_sides(p, triangles);
  }
}

// Not planar: no triangle stands on another, seen along the axis of the largest area.
TEST(Triangulate, CutsBentPolygons) {
  Polygon p = kShapes[0];
  for (size_t i = 0; i < p.size(); ++i) p[i].z() = i % 2 ? 0.3 : -0.3;
  std::vector<Index3> triangles;
  EXPECT_TRUE(triangulate(p, triangles));
  for (const Index3& t : triangles) {
    const auto flat_corner = [&](int k) { return Vec2(p[t[k]].x(), p[t[k]].y()); };
    EXPECT_GT(orient2d(flat_corner(0), flat_corner(1), flat_corner(2)), 0);
  }
}

TEST(Triangulate, KeepsTheFirstDiagonalOfConvexQuads) {
  std::vector<Index3> triangles;
  EXPECT_TRUE(triangulate(flat({{0, 0}, {1, 0}, {1, 1}, {0, 1}}), triangles));
  EXPECT_EQ(triangles, (std::vector<Index3>{{0, 1, 2}, {0, 2, 3}}));
}

TEST(Triangulate, MakesFansOfPolygonsThatCrossThemselves) {
  std::vector<Index3> triangles;
  EXPECT_FALSE(triangulate(flat({{0, 0}, {1, 1}, {1, 0}, {0, 1}}), triangles));
  EXPECT_EQ(triangles.size(), 2u);
}

TEST(Triangulate, KeepsCornersOnALine) {
  const Vec3 a(0, 0, 0), b(1, 2, 3);
  std::vector<Index3> triangles;
  EXPECT_TRUE(triangulate(Polygon{a, b, a, b, a}, triangles));
  EXPECT_EQ(triangles.size(), 3u);
  triangles.clear();
  EXPECT_TRUE(triangulate(Polygon{a, a, a, a}, triangles));
  EXPECT_EQ(triangles.size(), 2u);
}

}  // namespace
}  // namespace trivet
