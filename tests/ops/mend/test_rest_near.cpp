// One object's nearest rest among others that stand still.
#include <gtest/gtest.h>

#include "ops/mend/boxes.h"
#include "ops/mend/rest_near.h"
#include "ops/placement/clearance.h"

namespace trivet {
namespace {

using namespace trivet::test;

constexpr double kTableTolerance = 0.006;
// The slopes have 22 and 30 degrees; friction holds up to 26.6.
constexpr double kTanOfSlope = 0.404026, kTanOfSteepSlope = 0.577350;
constexpr double kEdgeHeight = 0.04, kSlopeLength = 0.02, kApart = 0.05, kFoot = 0.03;

/// It lies along y, with its edge over x = 0; the upper slope is on the side of -x.
Triangles roof() {
  return prism({{-kSlopeLength, 0},
                {kSlopeLength, 0},
                {kSlopeLength, kEdgeHeight - kSlopeLength * kTanOfSteepSlope},
                {0, kEdgeHeight},
                {-kSlopeLength, kEdgeHeight + kSlopeLength * kTanOfSlope}},
               0.05);
}

/// Its point is at the origin.
Triangles foot() {
  const double half = 0.002;
  const Vec3 point = Vec3::Zero(), a(-half, -half, kFoot), b(half, -half, kFoot),
             c(half, half, kFoot), d(-half, half, kFoot);
  return outward(
      {{point, b, a}, {point, c, b}, {point, d, c}, {point, a, d}, {a, b, c}, {a, c, d}});
}

/// A table, taken out, with four pointed feet on two roofs.
struct OnRoofs : Boxes {
  ObjectId table;
  Placement given;

  /// @param beyond  metres from the edges to the feet, down the steep slopes.
  explicit OnRoofs(double beyond) {
    Triangles roofs,
        feet = moved(box_between(Vec3(-0.01, -0.03, 0), Vec3(kApart + 0.01, 0.03, 0.004)),
                     Vec3(0, 0, kFoot - 1e-4));
    for (const double x : {0.0, kApart}) {
      roofs = joined(roofs, moved(roof(), Vec3(x, 0, 0)));
      for (const double y : {-0.02, 0.02}) feet = joined(feet, moved(foot(), Vec3(x, y, 0)));
    }
    add("roofs", weld(roofs), Vec3::Zero(), true);
    const double slope = beyond > 0 ? kTanOfSteepSlope : kTanOfSlope;
    table = add("table", weld(feet), Vec3(beyond, 0, kEdgeHeight - slope * beyond + 1e-4));
    given = {table, scene.at(table).pose};
    edit_object(scene, table, [](Object& o) { o.placed = false; });
  }

  double clearance() const { return default_clearance(scene); }
  std::optional<Pose> rest() { return rest_near(scene, given, kTableTolerance, clearance(), {}); }
  std::optional<Pose> rest_or_beside() {
    return rest_near_or_beside(scene, given, kTableTolerance, clearance(), {});
  }
  bool rests_at(const Pose& pose) {
    edit_object(scene, table, [&](Object& o) {
      o.pose = pose;
      o.placed = true;
    });
    return is_true(scene);
  }
};

TEST(RestNear, WhatSlidesIsHeldALittleUpTheSlope) {
  OnRoofs s(0.001);
  EXPECT_FALSE(s.rest());
  const std::optional<Pose> rest = s.rest_or_beside();
  ASSERT_TRUE(rest);
  EXPECT_LT((rest->translation - s.given.pose.translation).norm(), 1.5 * kTableTolerance);
  EXPECT_LT(rest->translation.x(), 0);
  EXPECT_FALSE(s.scene.at(s.table).placed);
  EXPECT_EQ(s.at(s.table), s.given.pose.translation);
  EXPECT_TRUE(s.rests_at(*rest));
}

TEST(RestNear, FarFromTheEdgeNothingHoldsIt) {
  OnRoofs s(0.01);
  EXPECT_FALSE(s.rest());
  EXPECT_FALSE(s.rest_or_beside());
}

TEST(RestNear, WhatIsHeldAsItLiesIsNotTakenBeside) {
  OnRoofs s(-0.004);
  const std::optional<Pose> rest = s.rest(), beside = s.rest_or_beside();
  ASSERT_TRUE(rest && beside);
  EXPECT_EQ(rest->translation, beside->translation);
}

}  // namespace
}  // namespace trivet
