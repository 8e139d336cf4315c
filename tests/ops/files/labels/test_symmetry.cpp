// Surfaces of revolution are found, and nothing else is taken for one.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "ops/files/labels/symmetry.h"

namespace trivet {
namespace {

struct Turned {
  std::vector<Vec3> vertices;
  std::vector<Index3> triangles;

  std::optional<Revolution> found() const { return surface_of_revolution(vertices, triangles, {}); }
};

/// Walls through (radius, height), turned about the axis through `centre`; caps on both ends.
Turned turned(const std::vector<Vec2>& profile, int sides, int axis = 2,
              const Vec3& centre = Vec3::Zero()) {
  Turned out;
  const auto add = [&](double x, double y, double h) {
    Vec3 p;
    p[axis] = h, p[(axis + 1) % 3] = x, p[(axis + 2) % 3] = y;
    out.vertices.push_back(p + centre);
  };
  for (const Vec2& at : profile)
    for (int i = 0; i < sides; ++i) {
      const double angle = 2 * std::numbers::pi * i / sides;
      add(at.x() * std::cos(angle), at.x() * std::sin(angle), at.y());
    }
  for (Index ring = 0; ring + 1 < static_cast<Index>(profile.size()); ++ring)
    for (Index i = 0; i < sides; ++i) {
      const Index a = ring * sides + i, b = ring * sides + (i + 1) % sides;
      out.triangles.push_back({a, b, b + sides});
      out.triangles.push_back({a, b + sides, a + sides});
    }
  const Index last = static_cast<Index>((profile.size() - 1) * sides);
  for (const Index first : {0, last})  // fans: across the axis they may be cut in any way
    for (Index i = 1; i + 1 < sides; ++i)
      out.triangles.push_back({first, first + i, first + i + 1});
  return out;
}

const std::vector<Vec2> kCan = {{0.03, -0.05}, {0.03, 0.05}};
const std::vector<Vec2> kGlass = {{0.02, 0}, {0.03, 0.1}};

TEST(Symmetry, FindsSurfacesOfRevolution) {
  for (const int axis : {0, 1, 2})
    for (const int sides : {12, 32, 33}) {
      const Vec3 centre(0.3, -0.2, 0.7);
      const auto can = turned(kCan, sides, axis, centre).found();
      ASSERT_TRUE(can) << axis << " " << sides;
      EXPECT_EQ(can->axis, Vec3(Vec3::Unit(axis)));
      EXPECT_TRUE(can->flips);
      Vec3 off = can->point - centre;
      off[axis] = 0;
      EXPECT_LT(off.norm(), 1e-9);
    }
  const auto glass = turned(kGlass, 24).found();
  ASSERT_TRUE(glass);
  EXPECT_FALSE(glass->flips);
}

TEST(Symmetry, TakesNothingElseForOne) {
  EXPECT_FALSE(turned(kCan, 8).found()) << "eight sides are no circle";
  Turned with_handle = turned(kCan, 24);
  const auto first = static_cast<Index>(with_handle.vertices.size());
  for (const Vec3& p : {Vec3(0.03, 0, 0.02), Vec3(0.05, 0, 0), Vec3(0.03, 0, -0.02)})
    with_handle.vertices.push_back(p);
  with_handle.triangles.push_back({first, first + 1, first + 2});
  EXPECT_FALSE(with_handle.found());
  Turned with_window = turned(kCan, 24);
  with_window.triangles.erase(with_window.triangles.begin() + 5,
                              with_window.triangles.begin() + 11);
  EXPECT_FALSE(with_window.found());
  EXPECT_FALSE(turned({{0.03, -0.05}, {0.03, 0.05}}, 4).found());
  EXPECT_FALSE(Turned().found());
  EXPECT_FALSE((Turned{{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()}, {{0, 1, 2}}}).found());
}

TEST(Symmetry, PaintedSidesAreNotTheSame) {
  const Turned can = turned(kCan, 24);
  std::vector<Index> materials(can.triangles.size(), 0);
  EXPECT_TRUE(surface_of_revolution(can.vertices, can.triangles, materials));
  for (int i = 0; i < 12; ++i) materials[i] = 1;  // a stripe on one side
  EXPECT_FALSE(surface_of_revolution(can.vertices, can.triangles, materials));
}

}  // namespace
}  // namespace trivet
