#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <thread>

#include "core/mesh/hull.h"
#include "core/mesh/made_meshes.h"
#include "core/mesh/mass.h"

namespace trivet {
namespace {

using namespace trivet::testing;
using Points = std::vector<Vec3>;

Points make_grid(int nx, int ny, int nz) {
  Points out;
  for (int x = 0; x < nx; ++x)
    for (int y = 0; y < ny; ++y)
      for (int z = 0; z < nz; ++z) out.emplace_back(x, y, z);
  return out;
}

Points random_points(std::mt19937& random, int num_points) {
  std::normal_distribution<double> number;
  Points out(num_points);
  for (Vec3& p : out) p = Vec3::NullaryExpr([&] { return number(random); });
  return out;
}

std::vector<Index> hull_vertices(const Points& points) {
  Mesh mesh;
  mesh.vertices = points;
  return convex_hull_vertices(mesh);
}

std::vector<Index> all(const Points& points) {
  std::vector<Index> out;
  for (size_t i = 0; i < points.size(); ++i) out.push_back(static_cast<Index>(i));
  return out;
}

TEST(Hull, ReducesGridToCorners) {
  const Points grid = make_grid(4, 4, 4);
  EXPECT_EQ(hull_vertices(grid), (std::vector<Index>{0, 3, 12, 15, 48, 51, 60, 63}));
}

TEST(Hull, KeepsAllPointsOfFlatInputSilently) {
  ::testing::internal::CaptureStdout();
  ::testing::internal::CaptureStderr();
  for (const Points& points : {Points{}, make_grid(1, 1, 1), make_grid(3, 1, 1), make_grid(9, 1, 1),
                               make_grid(5, 5, 1), Points(20, Vec3(1, 2, 3))}) {
    EXPECT_TRUE(convex_hull(points).vertices.empty());
    EXPECT_EQ(hull_vertices(points), all(points));
  }
  EXPECT_EQ(::testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

TEST(Hull, CallsObliquePlaneFlat) {
  constexpr unsigned kSeed = 5;
  std::printf("seed %u\n", kSeed);
  std::mt19937 random(kSeed);
  std::uniform_real_distribution<double> number(-1, 1);
  const Vec3 u(0.3, 0.9, -0.1), v(-0.7, 0.2, 0.45), offset(1e3, -2e3, 5e2);
  Points points;
  for (int i = 0; i < 500; ++i) points.push_back(offset + number(random) * u + number(random) * v);
  const std::vector<Index> vertices = hull_vertices(points);
  EXPECT_GE(vertices.size(), 4u);  // flat to within rounding: all, or a sliver's corners
}

/// All points lie behind all faces, and every vertex is needed.
TEST(Hull, ContainsRandomPoints) {
  constexpr unsigned kSeed = 6;
  std::printf("seed %u\n", kSeed);
  std::mt19937 random(kSeed);
  for (const int num_points : {4, 5, 10, 100, 1000}) {
    const Points points = random_points(random, num_points);
    const ConvexHull hull = convex_hull(points);
    ASSERT_GE(hull.vertices.size(), 4u);
    EXPECT_TRUE(std::is_sorted(hull.vertices.begin(), hull.vertices.end()));
    EXPECT_EQ(hull.triangles.size(), 2 * hull.vertices.size() - 4);  // Euler
    Vec3 inside = Vec3::Zero();
    for (const Index v : hull.vertices)
      inside += points[v] / static_cast<double>(hull.vertices.size());
    for (const Index3& t : hull.triangles) {
      const Vec3 normal = (points[t[1]] - points[t[0]]).cross(points[t[2]] - points[t[0]]);
      const double side = normal.dot(inside - points[t[0]]) < 0 ? 1 : -1;
      for (const Vec3& p : points)
        ASSERT_LE(side * normal.dot(p - points[t[0]]), 1e-12 * normal.norm());
    }
  }
}

TEST(Hull, KeepsSphereVerticesAtAnyScaleAndOffset) {
  const Mesh sphere = weld(make_sphere(1, 3));
  for (const double unit : {1e-30, 1.0, 1e30}) {
    Points points;
    for (const Vec3& p : sphere.vertices) points.push_back(unit * p);
    EXPECT_EQ(hull_vertices(points), all(points));
  }
  Points far;
  for (const Vec3& p : sphere.vertices) far.push_back(p + Vec3(1e6, 1e6, -1e6));
  EXPECT_EQ(hull_vertices(far), all(far));
}

TEST(Hull, IsTheSameFromManyThreads) {
  constexpr unsigned kSeed = 7;
  std::printf("seed %u\n", kSeed);
  std::mt19937 random(kSeed);
  const Points solid = random_points(random, 2000), flat = make_grid(20, 20, 1);
  const std::vector<Index> expected = hull_vertices(solid);
  std::vector<int> num_right(4);
  std::vector<std::thread> threads;
  for (int& right : num_right)
    threads.emplace_back([&] {
      for (int i = 0; i < 20; ++i)
        right += hull_vertices(solid) == expected && convex_hull(flat).vertices.empty();
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(num_right, std::vector<int>(4, 20));
}

}  // namespace
}  // namespace trivet
