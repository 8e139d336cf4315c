// Cables with known answers.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/flex/stage.h"

namespace trivet::test {
namespace {

FlexMaterial limp_cable() {
  FlexMaterial m;
  m.density = 0.05, m.stretch = 20000, m.bending = 0, m.thickness = 0.006;
  return m;
}

DrapeOptions one_level() {
  DrapeOptions options;
  options.levels = 1;
  return options;
}

// z = a cosh(x / a), length 2 a sinh(s / 2 a).
TEST(FlexCables, HangAsCatenaries) {
  const int n = 100;
  DrapeProblem problem =
      cable(n, 1.2, {{-0.5, 0, 1}, {0, 0, 1 - std::sqrt(0.36 - 0.25)}, {0.5, 0, 1}}, limp_cable());
  problem.pinned[0] = problem.pinned[n] = true;
  const DrapeResult result = drape(problem, built({}), one_level());
  ASSERT_EQ(result.ending, Ending::AtRest);
  double low = 0.1, high = 5;
  for (int i = 0; i < 200; ++i) {
    const double a = (low + high) / 2;
    (2 * a * std::sinh(0.5 / a) > 1.2 ? low : high) = a;
  }
  for (const Vec3& p : result.x)
    EXPECT_NEAR(p.z() - 1, low * (std::cosh(p.x() / low) - std::cosh(0.5 / low)), 5e-5);
  EXPECT_NEAR(result.pin_share, 1, 1e-3);
  EXPECT_NEAR(result.certificate.balance, 1, 1e-3);
  EXPECT_TRUE(result.certificate.stable);
}

// Friction holds e^(mu pi) times a weight, and no more.
double slid_over_cylinder(double share_of_limit, int max_steps) {
  const double mu = 0.3;
  FlexMaterial m;
  m.density = 0.02, m.stretch = 5000, m.bending = 1e-6, m.thickness = 0.004, m.friction = mu;
  Obstacles cylinder;
  add_lathe(cylinder, {{0, -0.1}, {0.03, -0.1}, {0.03, 0.1}, {0, 0.1}}, 256, {0, 0, 1}, true);
  cylinder.build();
  const double radius = 0.03 + 0.002 + 0.00025, down = 0.2;
  Points path{{-radius, 0, 1 - down}};
  for (int i = 0; i <= 180; ++i) {
    const double angle = M_PI * i / 180;
    path.emplace_back(-radius * std::cos(angle), 0, 1 + radius * std::sin(angle));
  }
  path.emplace_back(radius, 0, 1 - down);
  const int n = 128;
  DrapeProblem problem = cable(n, 2 * down + M_PI * radius, path, m);
  problem.loads.assign(n + 1, 0);
  const double own = m.density * down;
  problem.loads[0] = 1;
  problem.loads[n] = share_of_limit * std::exp(mu * M_PI) * (1 + own) - own;
  DrapeOptions options = one_level();
  options.minimiser.max_steps = max_steps;
  options.pressure = 50;
  const DrapeResult result = drape(problem, cylinder, options);
  return result.ending == Ending::AtRest ? 0 : problem.start.back().z() - result.x.back().z();
}

TEST(FlexCables, AreHeldByCapstans) { EXPECT_EQ(slid_over_cylinder(0.99, 1500), 0); }

TEST(FlexCables, SlideOverCapstansBeyondTheirFriction) {
  EXPECT_GT(slid_over_cylinder(1.01, 1500), 3e-3);
}

// Peirce's cantilever: a strip of twice its bending length sags to a chord of 41.487 degrees.
double cantilever_chord(int num_segments) {
  FlexMaterial m;
  m.density = 0.15, m.bending = 1e-5, m.stretch = 1000, m.thickness = 0.001;
  const double length = 2 * std::cbrt(m.bending / (m.density * kGravity));
  const double l = length / num_segments;
  DrapeProblem problem = cable(num_segments + 1, length + l, {{-l, 0, 1}, {length, 0, 1}}, m);
  problem.pinned[0] = problem.pinned[1] = true;
  const DrapeResult result = drape(problem, built({}), one_level());
  EXPECT_EQ(result.ending, Ending::AtRest);
  const Vec3 end = result.x.back() - Vec3(0, 0, 1);
  return std::atan2(-end.z(), end.x()) * 180 / M_PI;
}

TEST(FlexCables, SagAsPeirceSays) {
  const double coarse = cantilever_chord(48), fine = cantilever_chord(96);
  EXPECT_NEAR(coarse, 42.654, 0.02);
  EXPECT_NEAR(fine, 41.487, 0.65);
  EXPECT_NEAR(2 * fine - coarse, 41.487, 0.05);  // the error is of first order
}

// A clamped column buckles under its own weight at (7.837 EI / q)^(1/3) [Greenhill 1881].
// It starts upright. @return how far its end leans, m.
double leaning(double share_of_limit) {
  FlexMaterial m;
  m.density = 0.15, m.bending = 1e-3, m.stretch = 1e5, m.thickness = 0.001;
  const double length = share_of_limit * std::cbrt(7.837 * m.bending / (m.density * kGravity));
  const int n = 60;
  const double l = length / n;
  DrapeProblem problem = cable(n + 1, length + l, {{0, 0, 1 - l}, {0, 0, 1 + length}}, m);
  problem.pinned[0] = problem.pinned[1] = true;
  const DrapeResult result = drape(problem, built({}), one_level());
  EXPECT_EQ(result.ending, Ending::AtRest);
  EXPECT_TRUE(result.certificate.stable);
  return std::hypot(result.x.back().x(), result.x.back().y());
}

// Half a segment more is free at the clamp: 1 % of the length. Upright it would be balanced beyond
// the limit, but not stable.
TEST(FlexCables, BuckleAsGreenhillSays) {
  EXPECT_LT(leaning(0.97), 1e-6);
  EXPECT_GT(leaning(1.02), 0.01);
}

TEST(FlexCables, ComeToRestOverATableInLevels) {
  FlexMaterial m;
  m.density = 0.04, m.stretch = 5000, m.bending = 2e-4, m.thickness = 0.006;
  Obstacles room;
  add_box(room, {-3, -3, -0.05}, {3, 3, 0});
  add_box(room, {-0.6, -0.35, 0.69}, {0.6, 0.35, 0.72});
  room.build();
  const DrapeProblem problem = cable(128, 2, {{-0.56, 0.1, 0.75}, {1.44, 0.1, 0.75}}, m);
  const DrapeResult result = drape(problem, room, {});
  ASSERT_EQ(result.ending, Ending::AtRest);
  EXPECT_LT(result.certificate.net_force, 1e-3);
  EXPECT_NEAR(result.certificate.balance, 1, 1e-4);
  EXPECT_NEAR(result.shares[0] + result.shares[1], 1, 1e-4);
  EXPECT_GT(result.shares[1], 0.5);
  for (const Vec3& p : result.x) EXPECT_GE(p.z(), 0.003);
}

}  // namespace
}  // namespace trivet::test
