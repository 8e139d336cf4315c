#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "core/base/error.h"
#include "core/mesh/made_meshes.h"
#include "core/mesh/mesh.h"

namespace trivet {
namespace {

using namespace trivet::testing;

TEST(Weld, AcceptsEmptyInput) {
  const Mesh mesh = weld({});
  EXPECT_TRUE(mesh.vertices.empty());
  EXPECT_TRUE(mesh.triangles.empty());
  EXPECT_TRUE(mesh.box().empty());
}

TEST(Weld, MergesCornersOfCube) {
  const Mesh mesh = weld(make_cube());
  EXPECT_EQ(mesh.vertices.size(), 8u);
  EXPECT_EQ(mesh.triangles.size(), 12u);
  EXPECT_EQ(mesh.box().lower, Vec3::Zero());
  EXPECT_EQ(mesh.box().upper, Vec3::Ones());
}

TEST(Weld, NumbersVerticesInOrderOfUse) {
  const Vec3 a(5, 0, 0), b(1, 0, 0), c(3, 0, 0), d(0, 9, 0);
  const Mesh mesh = weld({{a, b, c}, {c, b, d}});
  EXPECT_EQ(mesh.triangles, (std::vector<Index3>{{0, 1, 2}, {2, 1, 3}}));
  EXPECT_EQ(mesh.vertices, (std::vector<Vec3>{a, b, c, d}));
}

TEST(Weld, TreatsMinusZeroAsZero) {
  const Vec3 plus(0, 0, 0), minus(-0.0, 0, -0.0), x(1, 0, 0), y(0, 1, 0);
  const Mesh mesh = weld({{minus, x, y}, {plus, y, x}});
  EXPECT_EQ(mesh.triangles, (std::vector<Index3>{{0, 1, 2}, {0, 2, 1}}));
  EXPECT_FALSE(std::signbit(mesh.vertices[0].x()));
}

TEST(Weld, KeepsNeighbouringDoublesApart) {
  const double next = std::nextafter(1.0, 2.0);
  const Mesh mesh = weld({{Vec3(1, 1, 1), Vec3(next, 1, 1), Vec3(1, 1, next)}});
  EXPECT_EQ(mesh.vertices.size(), 3u);
}

TEST(Weld, RejectsNonFiniteCoordinates) {
  for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL})
    for (int axis = 0; axis < 3; ++axis) {
      Triangles cube = make_cube();
      cube[7][1][axis] = bad;
      try {
        weld(cube);
        FAIL() << "welded " << bad;
      } catch (const Error& e) {
        EXPECT_EQ(e.kind(), Error::Kind::BadInput);
        EXPECT_NE(std::string(e.what()).find("accepted: finite coordinates"), std::string::npos);
      }
    }
}

TEST(Weld, KeepsDegenerateAndEqualTriangles) {
  const Vec3 a(0, 0, 0), b(1, 0, 0);
  const Mesh mesh = weld({{a, a, a}, {a, b, a}, {a, b, a}});
  EXPECT_EQ(mesh.triangles, (std::vector<Index3>{{0, 0, 0}, {0, 1, 0}, {0, 1, 0}}));
}

TEST(Weld, AgreesWithMap) {
  constexpr unsigned kSeed = 1;
  std::printf("seed %u\n", kSeed);
  std::mt19937 random(kSeed);
  for (const int num_points : {1, 3, 100, 5000, 100000}) {
    const Triangles triangles = make_tangle(random, 20000, num_points);
    const Mesh mesh = weld(triangles);
    std::map<std::array<double, 3>, Index> id_of;
    for (size_t f = 0; f < triangles.size(); ++f)
      for (int k = 0; k < 3; ++k) {
        const Vec3& p = triangles[f][k];
        const Index next = static_cast<Index>(id_of.size());
        const Index id = id_of.emplace(std::array{p.x(), p.y(), p.z()}, next).first->second;
        ASSERT_EQ(mesh.triangles[f][k], id);
        ASSERT_EQ(mesh.vertices[id], p);
      }
    EXPECT_EQ(mesh.vertices.size(), id_of.size());
  }
}

/// Integer grids are a common trap for hashes of coordinates.
TEST(Weld, HandlesIntegerGrid) {
  Triangles triangles;
  for (int x = 0; x < 200; ++x)
    for (int y = 0; y < 200; ++y)
      add_quad(triangles, Vec3(x, y, 0), Vec3(x + 1, y, 0), Vec3(x + 1, y + 1, 0),
               Vec3(x, y + 1, 0));
  EXPECT_EQ(weld(triangles).vertices.size(), 201u * 201u);
}

}  // namespace
}  // namespace trivet
