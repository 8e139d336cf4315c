// Forces by the touches that lower the cost alone, against the program of all touches.
#include <gtest/gtest.h>

#include <random>

#include "ops/stability/force_program.h"
#include "ops/stability/priced_forces.h"

namespace trivet {
namespace {

constexpr double kEps = 1e-6;

FreeBodies random_bodies(std::mt19937_64& random, double steep) {
  std::uniform_real_distribution<double> in(-1, 1);
  FreeBodies out;
  for (int i = 0; i < 3; ++i) out.bodies.push_back({{}, Vec3(in(random), in(random), i), 1, 2});
  for (Index k = 0; k < 90; ++k) {
    const Vec3 point(in(random), in(random), in(random) + 0.5);
    const Vec3 normal(in(random), in(random), 0.3 * in(random)-steep);
    const Index on = k / 30, from = k % 30 < 20 || on == 0 ? BodyContact::kGround : on - 1;
    const ContactPoint p{point, normal.normalized(), 0, ContactFeatures::VertexFace, k, 0};
    out.touches.push_back({on, from, Support::floor(), 0.3, p});
  }
  return out;
}

double by_all(FreeBodies part, const std::vector<double>& prices) {
  for (size_t k = 0; k < prices.size(); ++k) part.touches[k].contact.gap = prices[k];
  ForceProgram program(part, kEps, 1, {}, 1);
  program.add_missing(1, kInfinity);
  const LinearProgram::Solution solution = program.solve();
  EXPECT_TRUE(solution.optimal);
  return solution.objective;
}

TEST(PricedForces, CostAsLittleAsByAllTouchesAtOnce) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> in(0, 1);
  size_t num_joined = 0;
  int num_balanced = 0;
  constexpr int kTrials = 40;
  for (int trial = 0; trial < kTrials; ++trial) {
    const FreeBodies part = random_bodies(random, 0.1 * (trial % 8) - 0.5);
    std::vector<char> first(part.touches.size(), 0);
    for (size_t k = 0; k < first.size(); k += 9) first[k] = trial % 3 > 0;
    PricedForces forces(part, kEps, first);
    std::vector<double> prices(part.touches.size());
    for (int round = 0; round < 4; ++round) {
      // Some cost nothing, as closed contacts do.
      for (double& p : prices) p = std::max(0.0, in(random)-0.2 * round);
      const PartForces found = forces.find(prices);
      ASSERT_TRUE(found.solved);
      EXPECT_NEAR(found.residual, by_all(part, prices), 1e-5) << trial << ' ' << round;
      ASSERT_EQ(found.forces.size(), part.touches.size());
      num_balanced += found.balanced();
      Vec3 sum(0, 0, -3);
      for (size_t k = 0; k < found.forces.size(); ++k)
        if (part.touches[k].from == BodyContact::kGround) sum += found.forces[k];
      if (found.balanced()) {
        EXPECT_LT(sum.norm(), 1e-3) << trial << ' ' << round;
      }
    }
    num_joined += forces.num_joined();
  }
  EXPECT_GT(num_balanced, kTrials / 4);
  EXPECT_LT(num_joined, 60u * kTrials);
}

// The bodies have moved a little, and other touches are there.
TEST(PricedForces, CostAsLittleFromWhereOthersEnded) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> in(0, 1);
  size_t num_carried = 0;
  for (int trial = 0; trial < 20; ++trial) {
    FreeBodies part = random_bodies(random, 0.1 * (trial % 8) - 0.5);
    std::vector<double> prices(part.touches.size());
    for (double& p : prices) p = in(random);
    const std::vector<char> none(part.touches.size(), 0);
    PricedForces before(part, kEps, none);
    ASSERT_TRUE(before.find(prices).solved);
    const PricedForces::End end = before.end();
    num_carried += end.touches.size();
    for (BodyContact& t : part.touches) t.contact.point += 1e-3 * Vec3(in(random), in(random), 0);
    part.touches.erase(part.touches.begin() + 5, part.touches.begin() + 15);
    prices.erase(prices.begin() + 5, prices.begin() + 15);
    PricedForces forces(part, kEps, std::vector<char>(prices.size(), 0), end);
    EXPECT_LE(forces.num_joined(), end.touches.size());
    const PartForces found = forces.find(prices);
    ASSERT_TRUE(found.solved);
    EXPECT_NEAR(found.residual, by_all(part, prices), 1e-5) << trial;
  }
  EXPECT_GT(num_carried, 40u);
}

}  // namespace
}  // namespace trivet
