// Support surfaces of shelves and tables whose boards are known.
#include <gtest/gtest.h>

#include "ops/arrange/arrange_testing.h"
#include "ops/arrange/support_surfaces.h"
#include "support/solids.h"

namespace trivet {
namespace {

constexpr double kBoards[] = {0.1, 0.4, 0.75, 1.2};  // upper sides
constexpr double kThick = 0.02;

test::Triangles shelf() { return test::shelf({std::begin(kBoards), std::end(kBoards)}); }

std::vector<SupportSurface> surfaces_of(const test::Triangles& triangles, const Affine& m = {}) {
  const auto shape = test::shape_of(triangles);
  return support_surfaces(Body(*shape, m));
}

TEST(SupportSurfaces, OfShelfAreItsBoards) {
  const auto surfaces = surfaces_of(shelf());
  ASSERT_EQ(surfaces.size(), 4u);
  for (int i = 0; i < 4; ++i) {
    const SupportSurface& s = surfaces[i];
    EXPECT_NEAR(s.height, kBoards[i], 1e-12);
    EXPECT_NEAR(s.area, i < 3 ? 0.8 * 0.3 : 0.84 * 0.3, 1e-12);  // the sides' tops join the last
    EXPECT_NEAR(s.upper.x(), i < 3 ? 0.4 : 0.42, 1e-12);
    EXPECT_NEAR(s.lower.y(), -0.15, 1e-12);
    EXPECT_EQ(s.outline.size(), 4u);
    if (i < 3)
      EXPECT_NEAR(s.head_room, kBoards[i + 1] - kThick - kBoards[i], 1e-9);
    else
      EXPECT_EQ(s.head_room, kInfinity);
  }
}

TEST(SupportSurfaces, FollowThePose) {
  const Pose pose{Rotation{1, 0, 0, 1}.normalized(), Vec3(3, 4, 5)};
  const auto surfaces = surfaces_of(shelf(), world_from_object(pose, UpAxis::Z, 2));
  ASSERT_EQ(surfaces.size(), 4u);
  EXPECT_NEAR(surfaces[0].height, 5.2, 1e-12);
  EXPECT_NEAR(surfaces[0].lower.y(), 4 - 0.8, 1e-12);
  EXPECT_NEAR(surfaces[0].upper.x(), 3.3, 1e-12);
  // On its back it offers one side of the sides and edges of boards.
  const auto lying = surfaces_of(
      shelf(), world_from_object({Rotation{1, 1, 0, 0}.normalized(), Vec3::Zero()}, UpAxis::Z, 1));
  for (const SupportSurface& s : lying) EXPECT_NEAR(s.height, 0.15, 1e-9);
}

TEST(SupportSurfaces, OfInsideOutMeshAreTheSame) {
  test::Triangles flipped = shelf();
  for (Triangle& t : flipped) std::swap(t[1], t[2]);
  EXPECT_EQ(surfaces_of(flipped).size(), 4u);
}

TEST(SupportSurfaces, OfOpenSheetCountEitherSide) {
  for (const bool flip : {false, true}) {
    test::Triangles sheet{{Vec3(0, 0, 1), Vec3(1, 0, 1), Vec3(0, 1, 1)}};
    if (flip) std::swap(sheet[0][1], sheet[0][2]);
    const auto surfaces = surfaces_of(sheet);
    ASSERT_EQ(surfaces.size(), 1u);
    EXPECT_NEAR(surfaces[0].area, 0.5, 1e-14);
  }
}

TEST(SupportSurfaces, LeaveOutSlopesAndWalls) {
  // A wedge of 20 degrees; one of 10 degrees counts.
  for (const double slope : {20.0, 10.0}) {
    const double rise = std::tan(slope * M_PI / 180);
    const auto wedge = test::prism({{0, 0}, {1, 0}, {1, rise}}, 0.5);
    EXPECT_EQ(surfaces_of(wedge).size(), slope < 15 ? 1u : 0u);
  }
  EXPECT_TRUE(surfaces_of({{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 0, 1)}}).empty());
}

// Parts that overlap hide faces, as in most models.
TEST(SupportSurfaces, LeaveOutHiddenFaces) {
  const auto table = test::joined(test::box_between(Vec3(-0.5, -0.5, 0.7), Vec3(0.5, 0.5, 0.74)),
                                  test::box_between(Vec3(-0.4, -0.4, 0), Vec3(0.4, 0.4, 0.738)));
  const auto surfaces = surfaces_of(table);
  ASSERT_EQ(surfaces.size(), 1u);
  EXPECT_NEAR(surfaces[0].height, 0.74, 1e-12);
}

}  // namespace
}  // namespace trivet
