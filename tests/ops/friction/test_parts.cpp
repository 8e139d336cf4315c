// Verdicts on connected parts against the linear program of the whole part.

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <random>
#include <vector>

#include "ops/check/check.h"
#include "ops/friction/analytic.h"
#include "ops/settle/linear_program.h"
#include "ops/stability/contact_forces.h"
#include "ops/stability/part.h"
#include "ops/stability/unbalanced.h"

namespace trivet::test {
namespace {

// A prism in a groove of 90 degrees, which no vertical forces hold, and a pile of boxes on it, each
// shifted by up to `reach`; the box is 0.4 wide.
void add_groove_and_pile(Stage& stage, std::mt19937_64& random, int n, double reach) {
  const double gap = std::sqrt(2.0) * kGap;
  stage.add(extruded({{-1, 0}, {0, 0}, {-1, 1}}, 1), Vec3(0, 0, 0.01), {}, true);
  stage.add(extruded({{1, 0}, {1, 1}, {0, 0}}, 1), Vec3(0, 0, 0.01), {}, true);
  stage.add(extruded({{0, 0}, {0.5, 0.5}, {-0.5, 0.5}}, 1), Vec3(0, 0, 0.01 + gap));
  double x = 0, z = 0.51 + gap + kGap;
  for (int i = 0; i < n; ++i) {
    stage.add(box(0.4, 0.4, 0.1), Vec3(x, 0, z + 0.05));
    z += 0.1 + kGap;
    x += std::uniform_real_distribution<double>(-reach, reach)(random);
  }
}

PartVerdict judged(const Scene& scene, int limit) {
  const std::vector<ObjectId> all = scene.ids();
  return judge_parts(scene, connected_with(scene, all), all, kEps, limit);
}

bool stands_by_program(const Scene& scene) {
  const std::vector<ObjectId> all = scene.ids();
  FreeBodies part = near_bodies(scene, connected_with(scene, all), kEps, is_fixed_or_held, {});
  return contact_forces(part, kEps).balanced();
}

// Few touches first, others by column generation: as all at once.
TEST(Parts, LackNoMoreByFewTouchesThanByAll) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> in(-1, 1);
  int num_balanced = 0;
  constexpr int kTrials = 60;
  for (int trial = 0; trial < kTrials; ++trial) {
    FreeBodies few;
    for (int i = 0; i < 2; ++i) few.bodies.push_back({{}, Vec3(in(random), in(random), i), 1, 2});
    for (int k = 0; k < 80; ++k) {
      const Vec3 point(in(random), in(random), in(random) + 0.5);
      const Vec3 normal = Vec3(in(random), in(random), 0.1 * (trial % 6) - 0.6 + 0.3 * in(random));
      const Index on = k < 40 ? 0 : 1, from = k < 60 ? BodyContact::kGround : 0;
      const ContactPoint p{point, normal.normalized(), kGap, ContactFeatures::VertexFace, k, 0};
      (k % 20 < 3 ? few.touches : few.more).push_back({on, from, Support::floor(), 0.3, p});
    }
    FreeBodies all = few;
    all.touches.insert(all.touches.end(), all.more.begin(), all.more.end());
    all.more.clear();
    const bool quickly = quickly_balanced(all, kEps);
    const PartForces by_few = contact_forces(few, kEps), by_all = contact_forces(all, kEps);
    ASSERT_TRUE(by_few.solved && by_all.solved);
    EXPECT_EQ(quickly, by_all.balanced()) << "trial " << trial;
    EXPECT_EQ(by_few.balanced(), by_all.balanced()) << "trial " << trial;
    EXPECT_NEAR(by_few.residual, by_all.residual, 1e-4) << "trial " << trial;
    num_balanced += by_all.balanced();
  }
  EXPECT_GT(num_balanced, kTrials / 10);
  EXPECT_LT(num_balanced, kTrials * 9 / 10);
}

// The motion of three bodies that do not stand tells that two of them do not either, at most where
// their program says so: they may have touches that the three do not have.
TEST(Parts, AreCalledUnbalancedByMotionsOnlyWhereTheProgramSaysSo) {
  std::mt19937_64 random(40);
  std::uniform_real_distribution<double> in(-1, 1);
  int num_proved = 0, num_unbalanced = 0, num_balanced = 0;
  for (int trial = 0; trial < 150; ++trial) {
    FreeBodies larger, part;
    for (std::uint32_t i = 0; i < 3; ++i)
      larger.bodies.push_back({{i, 0}, Vec3(in(random), in(random), i), 1 + i * 0.5, 2});
    part.bodies.assign(larger.bodies.begin(), larger.bodies.begin() + 2);
    if (trial % 3 == 0) part.bodies[1].load = Vec3(in(random), 0, in(random)-1);
    for (int k = 0; k < 36; ++k) {
      const Vec3 point(in(random), in(random), in(random) + 0.5);
      const Vec3 normal = Vec3(in(random), in(random), 0.1 * (trial % 6) - 0.6 + 0.3 * in(random));
      const Index on = k / 12, from = k % 12 < 8 || on == 0 ? BodyContact::kGround : on - 1;
      const ContactPoint p{point, normal.normalized(), kGap, ContactFeatures::VertexFace, k, 0};
      const BodyContact touch{on, from, Support::floor(), 0.3, p};
      const bool also_larger = trial % 2 == 0 || k % 5 > 0;
      if (also_larger) (k % 4 == 0 ? larger.more : larger.touches).push_back(touch);
      if (on < 2) (k % 4 == 1 ? part.more : part.touches).push_back(touch);
    }
    const PartForces forces = contact_forces(larger, kEps);
    if (!forces.solved || forces.balanced()) continue;
    const bool proved = clearly_unbalanced(part, kEps, larger, forces);
    const bool balanced = contact_forces(part, kEps).balanced();
    EXPECT_FALSE(proved && balanced) << "trial " << trial;
    num_proved += proved;
    ++(balanced ? num_balanced : num_unbalanced);
  }
  std::printf("%d of %d proved, %d balanced\n", num_proved, num_unbalanced, num_balanced);
  EXPECT_GT(num_proved, num_unbalanced / 4);
  EXPECT_GT(num_balanced, 10);
}

// Forces on a body, and a further push that is worth something: from one start as each alone.
TEST(Parts, GiveWayToPushesTriedInTurnAsToEachAlone) {
  std::mt19937_64 random(8);
  std::uniform_real_distribution<double> in(-1, 1);
  int num_limited = 0, num_free = 0;
  for (int trial = 0; trial < 40; ++trial) {
    LinearProgram program;
    using Entry = LinearProgram::Entry;
    for (int row = 0; row < 6; ++row) program.add_row(row == 2, row == 2);
    for (int k = 0; k < 30; ++k) {
      std::array<Entry, 6> force;
      for (int row = 0; row < 6; ++row) force[row] = {row, in(random) + 0.7 * (row == 2)};
      program.add_column(force, 0, 2);
    }
    for (int row = 0; row < 6; ++row)
      for (const double sign : {1.0, -1.0}) program.add_column(std::array{Entry{row, sign}}, 3);
    std::vector<LinearProgram::Column> pushes(8);
    for (LinearProgram::Column& push : pushes) {
      for (int row = 0; row < 6; ++row) push.entries.push_back({row, 20 * in(random)});
      push.cost = -1, push.upper = 1;
    }
    const std::vector<double> in_turn = program.objectives_with(pushes, true);
    for (size_t k = 0; k < pushes.size(); ++k) {
      LinearProgram alone = program;
      alone.add_column(pushes[k].entries, pushes[k].cost, pushes[k].upper);
      const LinearProgram::Solution solution = alone.solve(true);
      ASSERT_TRUE(solution.optimal);
      EXPECT_NEAR(in_turn[k], solution.objective, 1e-7) << "trial " << trial << ", push " << k;
      EXPECT_NEAR(alone.solve_by_dual(true).objective, solution.objective, 1e-7) << trial;
      ++(solution.objective > -0.99 ? num_limited : num_free);
    }
  }
  std::printf("%d pushes limited, %d not\n", num_limited, num_free);
  EXPECT_GT(num_limited, 100);
}

TEST(Parts, AreJudgedAsByTheProgramOfAll) {
  std::mt19937_64 random(15);
  int num_standing = 0;
  constexpr int kTrials = 60;
  for (int trial = 0; trial < kTrials; ++trial) {
    Stage stage(trial % 3 == 0 ? 0.1 : 0.5);
    add_groove_and_pile(stage, random, 1 + trial % 6, 0.3);
    update_contacts(stage.scene, kEps);
    const PartVerdict verdict = judged(stage.scene, 200);
    EXPECT_TRUE(verdict.known);
    EXPECT_EQ(verdict.stands, stands_by_program(stage.scene)) << "trial " << trial;
    EXPECT_EQ(verdict.stands, verdict.topples.empty());
    num_standing += verdict.stands;
  }
  EXPECT_GT(num_standing, kTrials / 5);
  EXPECT_LT(num_standing, kTrials * 4 / 5);
}

// A plank on a fixed post and, across a gap that settling leaves open, on a free box.
TEST(Parts, ReachAcrossGapsThatSettlingCountsOn) {
  for (const double gap : {6 * kEps, 8 * kEps, 30 * kEps}) {
    Stage stage(0.5);
    stage.add(box(0.2, 0.2, 0.2), Vec3(-0.4, 0, 0.1 + kGap), {}, true);
    const double height = 0.2 + kGap - gap;
    stage.add(box(0.2, 0.2, height), Vec3(0.4, 0, kGap + height / 2));
    stage.add(box(1, 0.2, 0.03), Vec3(0, 0, 0.215 + 2 * kGap));
    update_contacts(stage.scene, kEps);
    StabilityOptions options;
    options.clearance = kEps;
    EXPECT_EQ(stability(stage.scene, options).stable(), gap < kCarryingTolerance * kEps) << gap;
    EXPECT_EQ(judged(stage.scene, 200).stands, gap < kCarryingTolerance * kEps) << gap;
  }
}

// A certified part needs no program, however large it is.
TEST(Parts, AreProvedByTheirOpenBodies) {
  std::mt19937_64 random(1);
  Stage stage(0.5);
  add_groove_and_pile(stage, random, 12, 0.01);
  update_contacts(stage.scene, kEps);
  const PartVerdict verdict = judged(stage.scene, 1);
  EXPECT_TRUE(verdict.stands && verdict.known);
}

// Too many open bodies for a proof: those near the change are judged, and the verdict says so. Of
// this stack the upper four turn over the edge of the first; the first two are open.
TEST(Parts, AreUnknownWhereTooManyBodiesAreOpen) {
  Stage stage(0.5);
  add_stack(stage, 5, 0.09);
  update_contacts(stage.scene, kEps);
  const std::vector<ObjectId> all = stage.scene.ids();
  const auto judged_near = [&](ObjectId changed, int limit) {
    return judge_parts(stage.scene, connected_with(stage.scene, all), std::vector{changed}, kEps,
                       limit);
  };
  EXPECT_TRUE(judged_near(all[1], 5).known);
  const PartVerdict above = judged_near(all[1], 1), below = judged_near(all[0], 1);
  EXPECT_FALSE(above.known || below.known);
  EXPECT_EQ(above.topples, std::vector{all[1]});
  EXPECT_FALSE(above.stands);
  EXPECT_TRUE(below.stands);
}

}  // namespace
}  // namespace trivet::test
