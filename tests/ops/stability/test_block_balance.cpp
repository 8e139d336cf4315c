// Balance block by block beside the linear program of all bodies.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "ops/stability/block_balance.h"
#include "support/effort.h"
#include "support/random_shapes.h"

namespace trivet::test {
namespace {

constexpr double kClearance = 1e-6, kRadius = 0.05;
constexpr int kRows = 8;

struct BallPile {
  double friction = 0.5;
  bool has_walls = true;
  double share = 1;     // of the balls that are there
  double heaviest = 1;  // newtons; the lightest has 1
};

void touch(FreeBodies& pile, Index on, Index from, const Vec3& point, const Vec3& normal,
           double friction) {
  BodyContact t;
  t.on = on, t.from = from, t.friction = friction;
  t.contact.point = point, t.contact.normal = normal;
  pile.touches.push_back(t);
}

/// Balls of one size in rows on each other, each in the gap of two below.
FreeBodies pile_of_balls(const BallPile& pile, Random& random) {
  FreeBodies out;
  const double step = 2 * kRadius, rise = std::sqrt(3.0) * kRadius;
  for (int row = 0; row < kRows; ++row)
    for (int k = 0; k < kRows - row; ++k) {
      const bool is_there = random.uniform(0, 1) < pile.share;
      const double weight = random.uniform(1, pile.heaviest);
      if (!is_there) continue;
      const Vec3 centre(step * k + kRadius * row, 0, kRadius + rise * row);
      out.bodies.push_back({{}, centre, weight, 2 * kRadius});
    }
  for (Index i = 0; i < static_cast<Index>(out.bodies.size()); ++i) {
    const Vec3 at = out.bodies[i].centre;
    const double radius = 1.001 * kRadius, last = step * (kRows - 1);
    const auto ground = [&](const Vec3& normal) {
      touch(out, i, BodyContact::kGround, at - kRadius * normal, normal, pile.friction);
    };
    if (at.z() < radius) ground(Vec3::UnitZ());
    if (pile.has_walls && at.x() < radius) ground(Vec3::UnitX());
    if (pile.has_walls && at.x() > last - radius) ground(-Vec3::UnitX());
    for (Index j = i + 1; j < static_cast<Index>(out.bodies.size()); ++j) {
      const Vec3 between = at - out.bodies[j].centre;
      if (between.norm() < 2 * radius)
        touch(out, i, j, at - between / 2, between.normalized(), pile.friction);
    }
  }
  return out;
}

using Verdict = BlockBalance::Verdict;

Verdict expect_as_together(const FreeBodies& pile) {
  const BlockBalance by_blocks = balance_by_blocks(pile, kClearance);
  FreeBodies all = pile;
  const PartForces together = contact_forces(all, kClearance);
  EXPECT_TRUE(together.solved);
  if (by_blocks.verdict == Verdict::Stands) {
    EXPECT_TRUE(together.balanced());
  }
  if (by_blocks.verdict != Verdict::Topples) return by_blocks.verdict;
  EXPECT_FALSE(together.balanced());
  EXPECT_FALSE(by_blocks.moves.empty());
  EXPECT_TRUE(std::is_sorted(by_blocks.moves.begin(), by_blocks.moves.end()));
  return by_blocks.verdict;
}

TEST(BlockBalance, HoldsPyramidOfBalls) {
  Random random(1);
  EXPECT_EQ(expect_as_together(pile_of_balls({}, random)), Verdict::Stands);
}

// Without walls the balls at the ends of the lowest row need friction of tan 15 degrees.
TEST(BlockBalance, FindsBallsThatRollApart) {
  Random random(1);
  EXPECT_EQ(expect_as_together(pile_of_balls({0.1, false}, random)), Verdict::Topples);
}

TEST(BlockBalance, FindsBallOverHole) {
  Random random(1);
  FreeBodies pile = pile_of_balls({}, random);
  // A ball in the air touches nothing.
  pile.bodies.push_back({{}, Vec3(0, 0, 2), 1, 2 * kRadius});
  const BlockBalance found = balance_by_blocks(pile, kClearance);
  EXPECT_EQ(found.verdict, Verdict::Topples);
  EXPECT_EQ(found.moves, std::vector<Index>{kRows * (kRows + 1) / 2});
}

TEST(BlockBalance, NeverContradictsProgramOfAll) {
  Random random(7);
  int counts[3] = {0, 0, 0};
  const int num = std::max(20, with_effort(60));
  for (int k = 0; k < num; ++k) {
    SCOPED_TRACE(k);
    const double friction = random.uniform(0, 0.6), share = random.integer(0, 2) > 0 ? 1 : 0.95;
    const bool has_walls = random.integer(0, 1) > 0;
    const BallPile pile{friction, has_walls, share, random.uniform(1, 5)};
    ++counts[static_cast<int>(expect_as_together(pile_of_balls(pile, random)))];
  }
  std::printf("%d stand, %d topple, %d open\n", counts[0], counts[1], counts[2]);
  EXPECT_GE(counts[0], num / 10);
  EXPECT_GE(counts[1], num / 10);
}

// To the bit: nothing is remembered from one call to the next.
TEST(BlockBalance, RepeatsItself) {
  Random random(3);
  const FreeBodies pile = pile_of_balls({0.4, true, 1, 4}, random);
  const BlockBalance a = balance_by_blocks(pile, kClearance),
                     b = balance_by_blocks(pile, kClearance);
  EXPECT_EQ(a.verdict, b.verdict);
  EXPECT_EQ(a.moves, b.moves);
}

}  // namespace
}  // namespace trivet::test
