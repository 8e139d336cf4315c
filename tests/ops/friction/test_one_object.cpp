// One object with finite friction: mechanics with known answers.

#include <gtest/gtest.h>

#include "ops/friction/analytic.h"
#include "ops/placement/verify.h"
#include "ops/settle/equilibrium.h"

namespace trivet::test {
namespace {

using Status = SettleOutcome::Status;

bool stays(const SettleOutcome& out) { return out.status == Status::AtRest && out.steps.empty(); }

/// Every motion lowers it, but for lifts; the end is at rest and free of interpenetration.
void expect_proper_end(Stage& stage, ObjectId id, const SettleOutcome& out) {
  ASSERT_EQ(out.status, Status::AtRest);
  for (const SettleStep& s : out.steps)
    EXPECT_TRUE(s.kind == SettleStep::Kind::Lift || s.energy_drop > 0);
  EXPECT_FALSE(refuse_interpenetration(stage.scene, id, out.pose, true));
  edit_object(stage.scene, id, [&](Object& o) { o.pose = out.pose; });
  EXPECT_TRUE(stays(stage.settle(id)));
}

class Incline : public testing::TestWithParam<double> {};

// A block slips above atan mu.
TEST_P(Incline, HoldsUpToTheAngleOfFriction) {
  const double mu = GetParam(), limit = std::atan(mu) * 180 / M_PI;
  {
    Stage stage(mu);
    EXPECT_TRUE(stays(stage.settle(stage.add_on_slope(limit - 0.15, box(0.2, 0.2, 0.2), 0.1))));
  }
  Stage stage(mu);
  const ObjectId block = stage.add_on_slope(limit + 0.15, box(0.2, 0.2, 0.2), 0.1);
  const SettleOutcome out = stage.settle(block);
  expect_proper_end(stage, block, out);
  EXPECT_LT(out.pose.translation.z(), 0.2);  // on the floor
}

INSTANTIATE_TEST_SUITE_P(Frictions, Incline, testing::Values(0.3, 0.5, 0.8));

// The smaller coefficient counts.
TEST(Incline, TakesTheSmallerFrictionOfThePair) {
  Stage stage(0.8);
  const ObjectId block = stage.add_on_slope(30, box(0.2, 0.2, 0.2), 0.1);
  EXPECT_TRUE(stays(stage.settle(block)));
  edit_object(stage.scene, block, [](Object& o) { o.material.friction = 0.5; });
  EXPECT_FALSE(stays(stage.settle(block)));
}

// A plank down a slope on two rails, of friction mu_1 above and mu_2 below: the lower one bears
// more by the height h of the plank's centre, and they lie d apart. It slips where tan a > (mu_1 +
// mu_2) / 2 / (1 - (mu_2 - mu_1) h / d).
TEST(Plank, SlipsOnTwoRailsAsBothTogetherHold) {
  const double distance = 0.6, rail = 0.004, height = 0.1;
  for (const auto& [mu_above, mu_below] : {std::pair(0.2, 0.6), {0.6, 0.2}, {0.1, 0.3}}) {
    const double limit =
        std::atan((mu_above + mu_below) / 2 / (1 - (mu_below - mu_above) * height / 2 / distance)) *
        180 / M_PI;
    for (const double degrees : {limit - 0.5, limit + 0.5}) {
      Stage stage(1);
      const double a = radians(degrees);
      const Vec3 up(std::sin(a), 0, std::cos(a)), down(std::cos(a), 0, -std::sin(a));
      const Vec3 middle(0, 0, 1);
      for (const auto& [side, mu] : {std::pair(-0.5, mu_above), {0.5, mu_below}}) {
        const ObjectId id = stage.add(box(rail, 0.3, 0.02), middle + side * distance * down,
                                      about_y(degrees), true);
        edit_object(stage.scene, id, [&](Object& o) { o.material.friction = mu; });
      }
      const ObjectId plank = stage.add(box(0.9, 0.2, height),
                                       middle + (0.01 + height / 2 + kGap) * up, about_y(degrees));
      EXPECT_EQ(stays(stage.settle(plank)), degrees < limit) << mu_above << " " << degrees;
    }
  }
}

// A tall block topples before it slips: above tan a = width / height.
TEST(TallBlock, TopplesWhenItsCentreLeavesItsFoot) {
  for (const auto& [height, degrees, holds] : {std::tuple(0.45, 20.0, true),
                                               {0.45, 23.8, true},
                                               {0.45, 24.2, false},
                                               {0.5, 21.6, true},
                                               {0.5, 22.0, false},
                                               {0.5, 24.5, false}}) {
    Stage stage(0.5);
    const ObjectId block = stage.add_on_slope(degrees, box(0.2, 0.2, height), height / 2);
    const SettleOutcome out = stage.settle(block);
    EXPECT_EQ(stays(out), holds) << height << " m at " << degrees << " degrees, "
                                 << out.steps.size() << " motions";
    if (holds) continue;
    expect_proper_end(stage, block, out);
    ASSERT_FALSE(out.steps.empty());
    EXPECT_EQ(out.steps[0].kind, SettleStep::Kind::TurnAboutLine);
  }
}

ObjectId add_ladder(Stage& stage, double degrees) {
  const double a = radians(degrees), length = 2, thickness = 0.04;
  stage.add(box(0.1, 2, 3), Vec3(0.05 + kGap, 0, 1.5 + kGap), {}, true);
  const double x = -(length / 2 * std::cos(a) + thickness / 2 * std::sin(a)) - kGap;
  const double z = length / 2 * std::sin(a) + thickness / 2 * std::cos(a) + kGap;
  return stage.add(box(length, 0.4, thickness), Vec3(x, 0, z), about_y(-degrees));
}

// tan a = (1/2 - m) / (mu / (1 + mu^2) + t / 2 L), m = mu^2 / (1 + mu^2).
double ladder_limit(double mu) {
  const double m = mu * mu / (1 + mu * mu);
  return std::atan((0.5 - m) / (mu / (1 + mu * mu) + 0.04 / 4)) * 180 / M_PI;
}

TEST(Ladder, SlidesDownBelowItsAngle) {
  for (const double mu : {0.3, 0.5}) {
    const double limit = ladder_limit(mu);
    Stage above(mu), below(mu);
    EXPECT_TRUE(stays(above.settle(add_ladder(above, limit + 0.3)))) << mu;
    const ObjectId ladder = add_ladder(below, limit - 0.3);
    const SettleOutcome out = below.settle(ladder);
    expect_proper_end(below, ladder, out);
    EXPECT_LT(out.pose.translation.z(), 0.1) << mu;  // flat on the floor
  }
}

// A smooth wall does not hold its top: tan a = 1 / (2 mu), but for the thickness.
TEST(Ladder, SlidesEarlierAtASmoothWall) {
  for (const double mu : {0.3, 0.5}) {
    const double limit = std::atan(1 / (2 * (mu + 0.04 / 4))) * 180 / M_PI;
    for (const double degrees : {limit - 0.5, limit + 0.5}) {
      Stage stage(mu);
      const ObjectId ladder = add_ladder(stage, degrees);
      edit_object(stage.scene, stage.scene.ids()[0], [](Object& o) { o.material.friction = 1e-9; });
      EXPECT_EQ(stays(stage.settle(ladder)), degrees > limit) << mu << " " << degrees;
    }
  }
}

// A card against another that is fixed: as a ladder without thickness, it needs (1 - mu^2) / 2 mu =
// tan a: 36.9 and 56.6 degrees.
TEST(Card, LeansAgainstAnotherIfSteepEnough) {
  const auto card = [](double degrees, double mirror) {
    const double a = radians(degrees), length = 0.5, thick = 0.02;
    const double c = std::cos(a), s = std::sin(a);
    std::vector<Vec2> p{{-length * c, 0},
                        {0, length * s},
                        {0, length * s + thick / c},
                        {-length * c - thick * s, thick * c}};
    if (mirror < 0) {
      std::reverse(p.begin(), p.end());
      for (Vec2& q : p) q.x() = -q.x();
    }
    return extruded(p, mirror < 0 ? 0.26 : 0.3);
  };
  for (const auto& [mu, degrees, holds] : {std::tuple(0.5, 46.0, true),
                                           {0.5, 60.0, true},
                                           {0.5, 32.0, false},
                                           {0.3, 60.0, true},
                                           {0.3, 50.0, false}}) {
    Stage stage(mu);
    stage.add(card(degrees, -1), Vec3(kGap / 2, 0, kGap), {}, true);
    const ObjectId left = stage.add(card(degrees, 1), Vec3(-kGap / 2, 0, kGap));
    const SettleOutcome out = stage.settle(left);
    EXPECT_EQ(stays(out), holds) << mu << " " << degrees;
    if (!holds) expect_proper_end(stage, left, out);
  }
}

TEST(Cylinder, RollsDownToTheFloor) {
  for (const auto& [degrees, sides] : {std::pair(10.0, 24), {35.0, 24}, {20.0, 48}}) {
    Stage stage(0.5);
    const ObjectId roll =
        stage.add_on_slope(degrees, lying_cylinder(0.1, 0.3, sides), 0.1 * std::cos(M_PI / sides),
                           -0.7, about_y(90 + 180.0 / sides));
    const SettleOutcome out = stage.settle(roll);
    expect_proper_end(stage, roll, out);
    EXPECT_LT(out.pose.translation.z(), 0.11);
  }
}

// A facet as wide as this holds it: it stays below 180 / n degrees.
TEST(Cylinder, RestsOnItsFacets) {
  Stage stage(0.5);
  const ObjectId roll = stage.add_on_slope(
      10, lying_cylinder(0.1, 0.3, 12), 0.1 * std::cos(M_PI / 12), -0.7, about_y(90 + 180.0 / 12));
  EXPECT_TRUE(stays(stage.settle(roll)));
}

// A wedge in a V groove whose sides rise at a, tilted along the groove by b. Its sides may press
// against each other by friction across the groove, so it can be held up to
// tan b = mu / sqrt(cos^2 a - mu^2 sin^2 a); the pyramids inside the cones lose 8 % of it at most.
TEST(Wedge, SlidesAlongItsGrooveAboveItsAngle) {
  const double mu = 0.4, side = 45;
  const auto outcome = [&](double degrees) {
    Stage stage(mu, true);
    const Rotation tilt =
        Rotation::about_axis(Vec3::UnitX(), -std::tan(radians(degrees) / 2));  // down along +y
    const Mat3 turn = tilt.matrix();
    const Vec3 origin(0, 0, 1.5);
    for (const double s : {1.0, -1.0}) {
      const double a = radians(side);
      const Vec3 up(-s * std::sin(a), 0, std::cos(a)), out(s * std::cos(a), 0, std::sin(a));
      stage.add(box(1, 2, 0.1), origin + turn * (0.5 * out - 0.05 * up), tilt * about_y(-s * side),
                true);
    }
    const double half = 0.15;
    const ObjectId wedge = stage.add(extruded({{0, 0}, {half, half}, {-half, half}}, 0.2),
                                     origin + turn * Vec3(0, -0.5, kGap), tilt);
    const SettleOutcome out = stage.settle(wedge);
    EXPECT_EQ(out.status, Status::AtRest);
    return stays(out);
  };
  const double a = radians(side), mu_sin = mu * std::sin(a);
  const double tangent = mu / std::sqrt(std::cos(a) * std::cos(a) - mu_sin * mu_sin);
  EXPECT_TRUE(outcome(std::atan(0.92 * tangent) * 180 / M_PI));
  EXPECT_FALSE(outcome(std::atan(1.01 * tangent) * 180 / M_PI));
}

// Forces balance it on its tip, but it falls over.
TEST(Needle, DoesNotStandOnItsTip) {
  Stage stage(0.8);
  const ObjectId needle =
      stage.add(extruded({{0, 0}, {0.05, 0.5}, {-0.05, 0.5}}, 0.1), Vec3(0, 0, kGap));
  const SettleOutcome out = stage.settle(needle);
  expect_proper_end(stage, needle, out);
  EXPECT_LT(out.pose.translation.z(), 0.2);
  EXPECT_FALSE(out.steps.empty());
}

// A rod over the edge of a table slips off it when it leans too steeply to be held.
TEST(Rod, LeavesAnEdgeByFalling) {
  Stage stage(0.5);
  stage.add(box(1, 1, 0.5), Vec3(-0.5, 0, 0.25 + kGap), {}, true);
  const ObjectId rod = stage.add(box(0.6, 0.1, 0.05), Vec3(0.05, 0, 0.525 + 3 * kGap));
  const SettleOutcome out = stage.settle(rod);
  expect_proper_end(stage, rod, out);
  EXPECT_LT(out.pose.translation.z(), 0.4);
}

TEST(FiniteFriction, GivesTheSameBitsAgain) {
  Stage stage(0.5);
  const ObjectId block = stage.add_on_slope(33, box(0.2, 0.3, 0.15), 0.075);
  const SettleOutcome a = stage.settle(block), b = stage.settle(block);
  EXPECT_EQ(a.pose.translation, b.pose.translation);
  EXPECT_EQ(a.steps.size(), b.steps.size());
}

}  // namespace
}  // namespace trivet::test
