// First motions with friction against closed forms.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "ops/settle/coulomb.h"

namespace trivet {
namespace {

const CoulombOptions kNoParting{0, 0.1};

Vec3 slope_normal(double a) { return {std::sin(a), 0, std::cos(a)}; }
Vec3 slope_down(double a) { return {std::cos(a), 0, -std::sin(a)}; }

// A block that cannot turn: it slips above atan mu, with g (sin a - mu cos a).
TEST(FirstMotion, OfABlockOnASlope) {
  for (const double mu : {0.0, 0.3, 0.5, 1.0})
    for (double a = 0.05; a < 1.5; a += 0.1) {
      const Vec3 n = slope_normal(a);
      const std::vector<CoulombBody> body{{Vec3::Zero(), 3, 1, Mat3::Zero()}};
      const std::vector<CoulombContact> contacts{
          {0, CoulombContact::kGround, Vec3(-0.1, 0, 0), n, mu, 0},
          {0, CoulombContact::kGround, Vec3(0.1, 0, 0), n, mu, 0}};
      const double expected = std::max(0.0, std::sin(a) - mu * std::cos(a));
      const Twist t = first_motion(body, contacts, kNoParting).twists.front();
      EXPECT_NEAR((t.velocity - expected * slope_down(a)).norm(), 0, 1e-3) << mu << " " << a;
    }
}

// A solid cylinder rolls without slipping up to tan a = 3 mu; beyond, it slips at the contact with
// g (sin a - 3 mu cos a).
TEST(FirstMotion, OfACylinderSlipsAboveThreeMu) {
  const double radius = 0.3, mu = 0.3;
  const Mat3 inertia = Vec3(1, 0.5 * radius * radius, 1).asDiagonal();
  for (double a = 0.1; a < 1.4; a += 0.05) {
    const Vec3 n = slope_normal(a), arm = -radius * n;
    const std::vector<CoulombBody> body{{Vec3::Zero(), 1, 2 * radius, inertia.inverse()}};
    const std::vector<CoulombContact> contacts{
        {0, CoulombContact::kGround, arm + Vec3(0, 0.2, 0), n, mu, 0},
        {0, CoulombContact::kGround, arm - Vec3(0, 0.2, 0), n, mu, 0}};
    const Twist t = first_motion(body, contacts, kNoParting).twists.front();
    const double slip = std::max(0.0, std::sin(a) - 3 * mu * std::cos(a));
    EXPECT_NEAR((t.at(arm) - slip * slope_down(a)).norm(), 0, 2e-3) << a;
    const double speed = slip > 0 ? std::sin(a) - mu * std::cos(a) : 2.0 / 3 * std::sin(a);
    EXPECT_NEAR((t.velocity - speed * slope_down(a)).norm(), 0, 2e-3) << a;
  }
}

// Two blocks on a slope, one on the other: both stay below atan mu, and go as one above it where
// the upper contact is rougher.
TEST(FirstMotion, OfTwoBlocksOnASlope) {
  for (const double a : {0.4, 0.6}) {
    const Vec3 n = slope_normal(a);
    const std::vector<CoulombBody> bodies{{Vec3::Zero(), 1, 1, Mat3::Zero()},
                                          {n, 1, 1, Mat3::Zero()}};
    const std::vector<CoulombContact> contacts{{0, CoulombContact::kGround, -0.5 * n, n, 0.5, 0},
                                               {1, 0, 0.5 * n, n, 0.8, 0}};
    const std::vector<Twist> t = first_motion(bodies, contacts, kNoParting).twists;
    const double expected = std::max(0.0, std::sin(a) - 0.5 * std::cos(a));
    for (const Twist& twist : t)
      EXPECT_NEAR((twist.velocity - expected * slope_down(a)).norm(), 0, 2e-3) << a;
  }
}

// A block over a gap: the step ends when the gap has closed, though the block goes by far less than
// a tenth of its size then.
TEST(FirstMotion, UsesUpNoMoreThanTheRoomOfAContact) {
  for (const double room : {1e-6, 1e-4, 1e-2}) {
    const std::vector<CoulombBody> bodies{{Vec3::Zero(), 1, 1, Mat3::Zero()}};
    const std::vector<CoulombContact> contacts{
        {0, CoulombContact::kGround, Vec3(0, 0, -0.5), Vec3::UnitZ(), 0.5, room}};
    const FirstTwists t = first_motion(bodies, contacts, kNoParting);
    EXPECT_NEAR(-t.twists.front().velocity.z() * t.duration, room, 1e-3 * room);
    EXPECT_NEAR(t.duration, 0.1, 1e-9);
  }
}

TEST(PartingDirection, IsTheNearestThatAllAllow) {
  const Vec3 down = -Vec3::UnitZ();
  const Vec3 slide = parting_direction({slope_normal(0.5)}, down, 0);
  EXPECT_NEAR((slide - slope_down(0.5)).norm(), 0, 1e-9);
  EXPECT_EQ(parting_direction({Vec3::UnitZ()}, down, 0), Vec3::Zero());
  // A groove lets it go along only.
  const Vec3 groove =
      parting_direction({Vec3(1, -0.5, 1).normalized(), Vec3(-1, -0.5, 1).normalized()}, down, 0);
  EXPECT_NEAR(groove.x(), 0, 1e-6);
  EXPECT_LT(groove.z(), -0.1);
}

}  // namespace
}  // namespace trivet
