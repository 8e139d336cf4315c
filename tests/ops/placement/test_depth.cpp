// Depths of interpenetrations, beside known ones and exact tests a little before and behind them.
#include <gtest/gtest.h>

#include "ops/operations/stage.h"
#include "ops/placement/depth.h"
#include "support/effort.h"

namespace trivet::test {
namespace {

bool meets(const Object& a, Pose pose, const Vec3& by, const ObjectInWorld& b) {
  pose.translation += by;
  return !verify_pair(in_world(a, pose, Vec3::Zero()), b, false, 1).clear();
}

TEST(Depth, OfBoxesIsTheLeastOverlap) {
  Random random(5);
  for (int i = 0; i < with_effort(300); ++i) {
    const Vec3 half = Vec3(0.2, 0.2, 0.2) + 0.1 * random.in_cube(1);
    const Object a = object_of("a", box_triangles(half)),
                 b = object_of("b", box_triangles({0.3, 0.4, 0.5}));
    const Vec3 least_apart = half + Vec3(0.3, 0.4, 0.5);
    const Vec3 at = 0.95 * random.in_cube(1).cwiseProduct(least_apart);
    const ObjectInWorld here = in_world(a, {{}, at}, Vec3::Zero()),
                        there = in_world(b, {{}, Vec3::Zero()}, Vec3::Zero());
    if (verify_pair(here, there, false, 1).clear()) continue;
    const double overlap = (least_apart - at.cwiseAbs()).minCoeff();
    const Depth depth = depth_of(here, there);
    EXPECT_NEAR(depth.metres, overlap, 1.1e-3 * overlap) << "pair " << i;
    EXPECT_GE(depth.metres, (1 - 1e-6) * overlap) << "pair " << i;
  }
}

TEST(Depth, EndsWhereTheWayIsFree) {
  Random random(6);
  int num_met = 0;
  for (int i = 0; i < with_effort(300); ++i) {
    const Object a = object_of("a", bumpy_sphere(5, 8, 0.3, static_cast<unsigned>(i))),
                 b = object_of("b", box_triangles({0.5, 0.6, 0.7}));
    const Pose pose{random.rotation(), random.in_cube(1.2)};
    const ObjectInWorld here = in_world(a, pose, Vec3::Zero()),
                        there = in_world(b, {random.rotation(), Vec3::Zero()}, Vec3::Zero());
    if (verify_pair(here, there, false, 1).clear()) continue;
    ++num_met;
    const Depth depth = depth_of(here, there);
    ASSERT_GT(depth.metres, 0);
    EXPECT_FALSE(meets(a, pose, 1.0001 * depth.metres * depth.way, there)) << "pair " << i;
    EXPECT_TRUE(meets(a, pose, 0.998 * depth.metres * depth.way, there)) << "pair " << i;
    for (int k = 0; k < 3; ++k)
      for (const double sign : {1.0, -1.0})
        EXPECT_TRUE(meets(a, pose, 0.998 * depth.metres * sign * Vec3::Unit(k), there))
            << "pair " << i << ": a shorter way along an axis";
  }
  EXPECT_GT(num_met, with_effort(300) / 4);
}

TEST(Depth, OfTwoPointsIsNone) {
  const Object a = object_of("a", {{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()}});
  const ObjectInWorld here = in_world(a, {}, Vec3::Zero());
  EXPECT_EQ(depth_of(here, here).metres, 0);
}

}  // namespace
}  // namespace trivet::test
