// One object's nearest rest among others that stand still.
#include <gtest/gtest.h>

#include "core/motion/compose.h"
#include "ops/mend/boxes.h"
#include "ops/mend/rest_near.h"
#include "ops/placement/clearance.h"

namespace trivet {
namespace {

using namespace trivet::test;

constexpr double kTolerance = 0.006, kHalf = 0.003;
constexpr double kSlope = 22, kSteepSlope = 30;  // degrees; friction holds up to 26.6
const Vec3 kEdge(0, 0, 0.05);

Vec3 down(double degrees) { return turn_about(Vec3::UnitY(), degrees).matrix() * Vec3::UnitX(); }

/// A roof of two slopes with a small box on it, taken out.
struct OnRoof : Boxes {
  ObjectId box;
  Placement given;

  /// @param beyond  metres from the edge of both slopes to the box's middle, down the steep one.
  explicit OnRoof(double beyond) {
    const Vec3 top = kEdge - 0.04 * down(kSlope), foot = kEdge + 0.04 * down(kSteepSlope);
    add("roof",
        weld(prism(
            {{top.x(), 0}, {foot.x(), 0}, {foot.x(), foot.z()}, {0, kEdge.z()}, {top.x(), top.z()}},
            0.05)),
        Vec3::Zero(), true);
    const Rotation steep = turn_about(Vec3::UnitY(), kSteepSlope);
    const Vec3 normal = steep.matrix() * Vec3::UnitZ();
    box = add("box", Vec3(kHalf, kHalf, kHalf),
              kEdge + beyond * down(kSteepSlope) + (kHalf + 1e-4) * normal, false, steep);
    given = {box, scene.at(box).pose};
    edit_object(scene, box, [](Object& o) { o.placed = false; });
  }

  std::optional<Pose> rest() { return rest_near(scene, given, kTolerance, clearance(), {}); }
  std::optional<Pose> rest_or_beside() {
    return rest_near_or_beside(scene, given, kTolerance, clearance(), {});
  }
  double clearance() const { return default_clearance(scene); }

  bool rests_at(const Pose& pose) {
    edit_object(scene, box, [&](Object& o) {
      o.pose = pose;
      o.placed = true;
    });
    return is_true(scene);
  }
};

TEST(RestNear, WhatSlidesIsHeldALittleUpTheSlope) {
  OnRoof s(0.004);
  EXPECT_FALSE(s.rest());
  const std::optional<Pose> rest = s.rest_or_beside();
  ASSERT_TRUE(rest);
  EXPECT_LT((rest->translation - s.given.pose.translation).norm(), 1.5 * kTolerance);
  EXPECT_FALSE(s.scene.at(s.box).placed);
  EXPECT_EQ(s.at(s.box), s.given.pose.translation);
  EXPECT_TRUE(s.rests_at(*rest));
}

TEST(RestNear, FarFromTheEdgeNothingHoldsIt) {
  OnRoof s(0.025);
  EXPECT_FALSE(s.rest());
  EXPECT_FALSE(s.rest_or_beside());
}

TEST(RestNear, WhatIsHeldAsItLiesIsNotTakenBeside) {
  OnRoof s(-0.02);
  const std::optional<Pose> rest = s.rest(), beside = s.rest_or_beside();
  ASSERT_TRUE(rest && beside);
  EXPECT_EQ(rest->translation, beside->translation);
}

}  // namespace
}  // namespace trivet
