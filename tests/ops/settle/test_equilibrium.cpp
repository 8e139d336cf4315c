// Force equilibrium in textbook cases.

#include <gtest/gtest.h>

#include <cmath>

#include "contact_at.h"
#include "ops/settle/equilibrium.h"
#include "ops/settle/least_friction.h"
#include "ops/settle/settle.h"
#include "support/effort.h"
#include "support/random_shapes.h"

namespace trivet {
namespace {

constexpr double kTiny = 1e-7;

using test::contact;

/// The corners of a square of half size 1, turned about the origin.
std::vector<ContactPoint> square(const Mat3& rotation = Mat3::Identity()) {
  std::vector<ContactPoint> out;
  for (const double x : {-1.0, 1.0})
    for (const double y : {-1.0, 1.0})
      out.push_back(contact(rotation * Vec3(x, y, 0), rotation * Vec3::UnitZ()));
  return out;
}

double least(const std::vector<ContactPoint>& contacts, const Vec3& centre, double size = 2) {
  return least_friction(contacts, centre, size, kTiny);
}

TEST(HullMargin, MeasuresSquare) {
  const std::vector<Vec2> square{{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 1}};
  EXPECT_EQ(hull_margin(square, {1, 1}), 1);
  EXPECT_EQ(hull_margin(square, {0.25, 1}), 0.25);
  EXPECT_EQ(hull_margin(square, {-0.5, 1}), -0.5);
  EXPECT_EQ(hull_margin(square, {-3, -4}), -5);
  EXPECT_EQ(hull_margin(square, {0, 1}), 0);
}

TEST(HullMargin, IsNeverPositiveForFewerPoints) {
  EXPECT_EQ(hull_margin({}, {0, 0}), -kInfinity);
  EXPECT_EQ(hull_margin({{3, 4}}, {0, 0}), -5);
  EXPECT_EQ(hull_margin({{-1, 2}, {1, 2}}, {0, 0}), -2);
  EXPECT_EQ(hull_margin({{-1, 0}, {1, 0}, {0.5, 0}}, {0, 0}), 0);  // exactly above it
}

TEST(CarryingMargin, IgnoresSteepContacts) {
  auto contacts = square();
  EXPECT_EQ(carrying_margin(contacts, {0.5, 0, 3}), 0.5);
  contacts.push_back(contact({5, 0, 0}, Vec3::UnitX()));
  contacts.push_back(contact({0, 5, 0}, -Vec3::UnitZ()));
  EXPECT_EQ(carrying_margin(contacts, {0.5, 0, 3}), 0.5);
  EXPECT_EQ(carrying_margin({contact({0, 0, 0}, Vec3::UnitX())}, {0, 0, 1}), -kInfinity);
}

TEST(Equilibrium, NeedsNoFrictionForBoxOnGround) {
  EXPECT_NEAR(equilibrium_residual(square(), {0.9, -0.9, 1}, 2, 0), 0, kTiny);
  EXPECT_EQ(least(square(), {0.9, -0.9, 1}), 0);
}

TEST(Equilibrium, FailsOutsideHullWithAnyFriction) {
  EXPECT_GT(equilibrium_residual(square(), {1.1, 0, 1}, 2, 5), 0.01);
  EXPECT_EQ(least(square(), {1.1, 0, 1}), kInfinity);
  // The missing torque: 0.1 beyond the edge, in weights times size.
  EXPECT_NEAR(equilibrium_residual(square(), {1.1, 0, 1}, 2, 0), 0.1 / 2, kTiny);
}

TEST(Equilibrium, FailsWithoutContacts) {
  EXPECT_EQ(equilibrium_residual({}, Vec3::Zero(), 1, 1), kInfinity);
  EXPECT_EQ(least({}, Vec3::Zero()), kInfinity);
  // Contacts that only push down or sideways: the whole weight is missing.
  EXPECT_NEAR(equilibrium_residual({contact({0, 0, 1}, -Vec3::UnitZ())}, Vec3::Zero(), 2, 0), 1,
              kTiny);
  EXPECT_NEAR(equilibrium_residual({contact({-1, 0, 0}, Vec3::UnitX())}, Vec3::Zero(), 2, 0), 1,
              kTiny);
}

TEST(LeastFriction, IsTangentOfSlope) {
  for (const double angle : {0.05, 0.2, 0.5, 0.9, 1.2}) {
    const Mat3 slope = Rotation::about_axis(Vec3::UnitY(), std::tan(angle / 2)).matrix();
    const double mu = least(square(slope), slope * Vec3(0, 0, 0.1));
    EXPECT_GE(mu, 0.999 * std::tan(angle));
    EXPECT_LE(mu, 1.011 * std::tan(angle));
  }
}

TEST(LeastFriction, IsSafeOnSlopeInAnyDirection) {
  // The pyramid lies inside the cone: it may require more, by 1 / cos(22.5 degrees), never less.
  test::Random random(1);
  for (int i = 0; i < 200; ++i) {
    const double angle = random.uniform(0.05, 1.2), around = random.uniform(0, 2 * M_PI);
    const Vec3 axis(std::cos(around), std::sin(around), 0);
    const Mat3 slope = Rotation::about_axis(axis, std::tan(angle / 2)).matrix();
    const double mu = least(square(slope), slope * Vec3(0, 0, 0.1));
    EXPECT_GE(mu, 0.999 * std::tan(angle));
    EXPECT_LE(mu, 1.095 * std::tan(angle));
  }
}

TEST(LeastFriction, IsInfiniteOnSteepSlope) {
  const Mat3 slope = Rotation::about_axis(Vec3::UnitY(), std::tan(0.5 * 1.5)).matrix();
  EXPECT_EQ(least(square(slope), slope * Vec3(0, 0, 0.01)), kInfinity);  // tan 1.5 = 14
}

TEST(LeastFriction, IsInfiniteForTallBlockOnSlope) {
  const Mat3 slope = Rotation::about_axis(Vec3::UnitY(), std::tan(0.25)).matrix();  // 0.5 rad
  EXPECT_LT(least(square(slope), slope * Vec3(0, 0, 1.8)), 1);
  EXPECT_EQ(least(square(slope), slope * Vec3(0, 0, 1.9)), kInfinity);  // 1 / tan 0.5 = 1.83
}

TEST(LeastFriction, MatchesLadder) {
  // Uniform, leaning against a rough wall: mu = tan((90 degrees - angle to the ground) / 2).
  for (const double angle : {0.6, 1.0, 1.3}) {
    const Vec3 foot(std::cos(angle), 0, 0), head(0, 0, std::sin(angle));
    const double mu = least({contact(foot), contact(head, Vec3::UnitX())}, 0.5 * (foot + head), 1);
    const double expected = std::tan(0.5 * (M_PI / 2 - angle));
    EXPECT_GE(mu, 0.999 * expected);
    EXPECT_LE(mu, 1.011 * expected);
  }
}

TEST(LeastFriction, IsZeroInVGroove) {
  const std::vector<ContactPoint> groove{
      contact({-1, -1, 0}, {1, 0, 1}), contact({-1, 1, 0}, {1, 0, 1}),
      contact({1, -1, 0}, {-1, 0, 1}), contact({1, 1, 0}, {-1, 0, 1})};
  EXPECT_EQ(least(groove, {0, 0, 0.5}), 0);
  // Off the middle, the normals leave a torque that friction must balance.
  const double mu = least(groove, {0.3, 0, 0.5});
  EXPECT_GT(mu, 0.01);
  EXPECT_LT(mu, 1);
}

TEST(LeastFriction, IsZeroForHookUnderItsPoint) {
  EXPECT_EQ(least({contact({0, 0, 1})}, {0, 0, 0}), 0);
  EXPECT_EQ(least({contact({0, 0, 1})}, {0.01, 0, 0}), kInfinity);
  EXPECT_EQ(least({contact({0, 0, -1})}, {0, 0, 0}), 0);  // balanced on a tip: in force equilibrium
}

TEST(LeastFriction, BalancesKnifeEdgeOnlyExactly) {
  const std::vector<ContactPoint> edge{contact({0, -1, 0}), contact({0, 1, 0})};
  EXPECT_EQ(least(edge, {0, 0.5, 1}), 0);
  EXPECT_EQ(least(edge, {0.01, 0, 1}), kInfinity);
  EXPECT_EQ(least(edge, {0, 1.5, 1}), kInfinity);
}

TEST(LeastFriction, RejectsNearlyCollinearContacts) {
  // Two contacts nearly on one line: friction of one against the other must not balance a body that
  // leans over them.
  const std::vector<ContactPoint> edge{contact({1e-6, -1, 0}), contact({-1e-6, 1, 0}, {1e-3, 0, 1}),
                                       contact({0, 0, 0}, {-1e-3, 0, 1})};
  EXPECT_EQ(least(edge, {0.3, 0, 1}), kInfinity);
}

// All coefficients of the grid on the way, each by a program of its own.
double by_bisection(const std::vector<ContactPoint>& contacts, const Vec3& centre,
                    double tolerance) {
  const auto holds = [&](double friction) {
    return equilibrium_residual(contacts, centre, 2, friction) <= tolerance;
  };
  if (holds(0)) return 0;
  if (!holds(kLargestFriction)) return kInfinity;
  double fails = 0, high = kLargestFriction;
  while (high - fails > 0.01 * high && high > 1e-3) {
    const double middle = 0.5 * (fails + high);
    (holds(middle) ? high : fails) = middle;
  }
  return high;
}

TEST(LeastFriction, EqualsBisectionForRandomContacts) {
  test::Random random(3);
  int num_finite = 0;
  for (const int num_contacts : {2, 3, 3, 3, 4, 6, 12, 60})
    for (int i = 0; i < test::with_effort(100); ++i) {
      std::vector<ContactPoint> contacts;
      for (int k = 0; k < num_contacts; ++k)
        contacts.push_back(contact(random.in_cube(1), random.direction() + Vec3(0, 0, 1.2)));
      const Vec3 centre = random.in_cube(0.4);
      const double tolerance = i % 2 ? 1e-7 : 2e-4;
      const double expected = by_bisection(contacts, centre, tolerance);
      EXPECT_EQ(least_friction(contacts, centre, 2, tolerance), expected)
          << num_contacts << " contacts, number " << i;
      num_finite += expected > 0 && expected < kInfinity;
    }
  EXPECT_GT(num_finite, test::with_effort(100));
}

TEST(Equilibrium, DoesNotDependOnScaleOrPlace) {
  test::Random random(2);
  for (int i = 0; i < 50; ++i) {
    std::vector<ContactPoint> near, far;
    const Vec3 centre = random.in_cube(0.5), away = 1000 * random.direction();
    for (int k = 0; k < 5; ++k) {
      near.push_back(contact(random.in_cube(1), random.direction() + Vec3::UnitZ()));
      far.push_back(near.back());
      far.back().point = 1e3 * near.back().point + away;
    }
    EXPECT_NEAR(equilibrium_residual(near, centre, 1, 0.5),
                equilibrium_residual(far, 1e3 * centre + away, 1e3, 0.5), 1e-9);
  }
}

TEST(Equilibrium, IsMonotonicInFriction) {
  test::Random random(3);
  int num_held = 0;
  for (int i = 0; i < 200; ++i) {
    std::vector<ContactPoint> contacts;
    const int n = random.integer(2, 8);
    for (int k = 0; k < n; ++k)
      contacts.push_back(contact(random.in_cube(1), random.direction() + 0.5 * Vec3::UnitZ()));
    const Vec3 centre = random.in_cube(0.5);
    double before = kInfinity;
    for (const double mu : {0.0, 0.2, 0.5, 1.0}) {
      const double residual = equilibrium_residual(contacts, centre, 2, mu);
      EXPECT_LE(residual, before + 1e-9);
      before = residual;
    }
    num_held += before < kTiny;
  }
  EXPECT_GT(num_held, 20);
  EXPECT_LT(num_held, 180);
}

TEST(Equilibrium, OneMoreContactNeverHurts) {
  test::Random random(5);
  int num_held = 0;
  for (int i = 0; i < 200; ++i) {
    std::vector<ContactPoint> contacts;
    const int n = i % 2 ? random.integer(2, 8) : random.integer(30, 300);
    const double up = random.uniform(-2, 0.5);
    for (int k = 0; k < n; ++k)
      contacts.push_back(contact(random.in_cube(1), random.direction() + up * Vec3::UnitZ()));
    const Vec3 centre = random.in_cube(1.2);
    const double mu = random.uniform(0, 1);
    const double margin = carrying_margin(contacts, centre), friction = least(contacts, centre);
    const double residual = equilibrium_residual(contacts, centre, 2, mu);
    for (int k = 0; k < 20; ++k)  // most of them from above
      contacts.push_back(contact(random.in_cube(1), random.direction() - Vec3::UnitZ()));
    EXPECT_GE(carrying_margin(contacts, centre), margin - 1e-12) << i;
    EXPECT_LE(equilibrium_residual(contacts, centre, 2, mu), residual + 1e-5) << i;
    EXPECT_LE(least(contacts, centre), friction) << i;
    num_held += std::isfinite(friction);
  }
  EXPECT_GT(num_held, 50);
  EXPECT_LT(num_held, 190);
}

// Also of contacts at one place, above each other, in one line, under the centre, and without
// friction.
std::vector<FrictionContact> few_contacts(test::Random& random) {
  std::vector<FrictionContact> out;
  const double up = random.uniform(-1, 1.5);
  const int n = random.integer(1, 9), kind = random.integer(0, 4);
  for (int k = 0; k < n; ++k) {
    Vec3 point = random.in_cube(1);
    if (kind == 1 && k > 0) point = out[0].point;
    if (kind == 2) point = Vec3(point.x(), 0, 0.5 * point.x());
    if (kind == 3) point.z() = 0;
    const Vec3 normal = kind == 3 ? Vec3::UnitZ() : Vec3(random.direction() + up * Vec3::UnitZ());
    out.push_back({contact(point, normal), random.integer(0, 3) ? random.uniform(0, 2) : 0});
  }
  return out;
}

TEST(LeastMissing, IsNeverMoreThanTheProgramFinds) {
  test::Random random(7);
  int num_told = 0, num_missing = 0;
  for (int i = 0; i < 4000; ++i) {
    const std::vector<FrictionContact> contacts = few_contacts(random);
    const bool over_first = random.integer(0, 4) == 0;
    Vec3 centre = random.in_cube(1);
    if (over_first) centre.head<2>() = contacts[0].point.head<2>();
    const double size = random.uniform(0.5, 4), enough = random.integer(0, 1) ? 1e-2 : 3e-6;
    const double residual = friction_residual(contacts, centre, size);
    EXPECT_LE(least_missing(contacts, centre, size), residual + 1e-6) << i;
    EXPECT_EQ(forces_balance(contacts, centre, size, enough),
              friction_residual(contacts, centre, size, enough) <= enough)
        << i;
    num_missing += residual > 0.03;
    num_told += residual > 0.03 && least_missing(contacts, centre, size) > 0.03;
  }
  EXPECT_GT(num_missing, 1000);
  EXPECT_GT(num_told, num_missing / 3);
}

// A block of ice slides down a slope, a plank tips over its support.
TEST(LeastMissing, KnowsSlidesAndTurns) {
  const Vec3 slope = Vec3(0.6, 0, 0.8);
  const FrictionContact ice{contact({0, 0, 0}, slope), 0.1};
  EXPECT_GT(least_missing({ice}, slope, 1), 0.1);
  const FrictionContact edge{contact({0, 0, 0}, Vec3::UnitZ()), 0.5}, other{edge};
  EXPECT_NEAR(least_missing({edge, other}, {0.25, 0, 0}, 1), 0.25, 1e-12);
  EXPECT_EQ(least_missing({edge}, {0, 0, 1}, 1), 0);
}

// A sample of 40 contacts may leave out those that matter.
TEST(Equilibrium, FindsResidualOfAllOfManyContacts) {
  test::Random random(6);
  for (int i = 0; i < 40; ++i) {
    std::vector<ContactPoint> crowd, all;
    for (int k = 0; k < 200; ++k)
      crowd.push_back(contact(random.in_cube(1), random.direction() - 2 * Vec3::UnitZ()));
    all = crowd;
    for (const ContactPoint& c : square()) all.push_back(c);
    const Vec3 centre(random.uniform(-0.8, 0.8), random.uniform(-0.8, 0.8), 0.5);
    EXPECT_NEAR(equilibrium_residual(all, centre, 2, 0), 0, 1e-5) << i;
    EXPECT_GT(equilibrium_residual(crowd, centre, 2, 0), 0.5);
  }
}

TEST(Reduced, KeepsForcesOfManyContacts) {
  test::Random random(4);
  for (int i = 0; i < 30; ++i) {
    std::vector<ContactPoint> contacts;
    for (int k = 0; k < 300; ++k) {
      const Vec3 at = random.in_cube(1);
      contacts.push_back(contact({at.x(), at.y(), 0}));                  // a flat bottom
      contacts.push_back(contact({-1, at.y(), at.z()}, Vec3::UnitX()));  // against a wall
    }
    const auto few = reduced(contacts, 40);
    EXPECT_LE(few.size(), 60u);
    EXPECT_GE(few.size(), 6u);
    for (const Vec3& centre : {Vec3(0.2, 0.1, 1), Vec3(-1.05, 0, 1), Vec3(1.2, 0, 0)})
      EXPECT_NEAR(equilibrium_residual(few, centre, 2, 0.3),
                  equilibrium_residual(contacts, centre, 2, 0.3), 0.02);
  }
  EXPECT_EQ(reduced(square(), 40).size(), 4u);
}

TEST(IsAtRest, UsesHullOrForces) {
  EXPECT_TRUE(is_balanced(square(), {0.9, 0, 1}, 2, 1e-6));
  EXPECT_FALSE(is_balanced(square(), {1.1, 0, 1}, 2, 1e-6));
  EXPECT_TRUE(is_balanced({contact({0, 0, 1})}, {0, 0, 0}, 2, 1e-6));
  EXPECT_FALSE(is_balanced({contact({0, 0, 1})}, {0.1, 0, 0}, 2, 1e-6));
  EXPECT_FALSE(is_balanced({}, {0, 0, 0}, 2, 1e-6));
}

}  // namespace
}  // namespace trivet
