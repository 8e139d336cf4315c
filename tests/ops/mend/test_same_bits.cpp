// Shortcuts of mending that change nothing: as without them, and the same bits by all threads.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/base/arena.h"
#include "core/motion/compose.h"
#include "ops/mend/boxes.h"
#include "ops/mend/close_gaps.h"
#include "ops/mend/mend.h"
#include "ops/mend/small_motions.h"
#include "ops/mend/starts.h"
#include "ops/placement/clearance.h"

namespace trivet {
namespace {

using namespace trivet::test;

constexpr double kSoft = 1e-3;
constexpr int kPatientSweeps = 40'000;

/// Relaxation that asks each row in each sweep, and does nothing else.
void relax_all(std::vector<MotionRow>& rows, std::vector<SmallMotion>& motions) {
  const auto push = [&](const MotionRow& row, double by) {
    motions[row.on] += by * row.of_on;
    if (row.from != BodyContact::kGround) motions[row.from] += by * row.of_from;
  };
  for (MotionRow& row : rows) {
    row.push = std::max(row.least_push, row.push);
    push(row, row.push);
  }
  double most = kInfinity;
  for (int sweep = 0; sweep < kPatientSweeps && most > 1e-13; ++sweep) {
    most = 0;
    for (MotionRow& row : rows) {
      const double lacks = row.least - row.of(motions) - kSoft * row.push;
      const double to = std::max(row.least_push, row.push + lacks / (row.squared_norm() + kSoft));
      push(row, to - row.push);
      most = std::max(most, std::abs(to - row.push));
      row.push = to;
    }
  }
  ASSERT_LE(most, 1e-13);
}

TEST(NearestMotions, AreThoseOfPatientRelaxation) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  std::uniform_int_distribution<Index> body(-1, 7);
  const auto triple = [&] {
    const double x = normal(random), y = normal(random);
    return Vec3(x, y, normal(random));
  };
  for (int trial = 0; trial < 60; ++trial) {
    std::vector<FreeBody> bodies;
    bodies.reserve(8);
    for (int i = 0; i < 8; ++i) bodies.push_back({ObjectId{}, 0.1 * triple(), 1, 0.2});
    std::vector<MotionRow> rows;
    for (int k = 0; k < 80; ++k) {
      const Index on = k % 8, from = body(random);
      rows.push_back(MotionRow::apart(bodies, on, from == on ? BodyContact::kGround : from,
                                      0.1 * triple(), triple().normalized()));
      // Most are met and far away; some may pull, and some contradict each other.
      rows.back().least = 1e-3 * normal(random) - (k % 4 ? 3e-3 : 0);
      if (k % 5 == 0) rows.back().least_push = trial % 2 ? -1e-3 : -kInfinity;
      if (k % 7 == 0) rows.back().push = 1e-4;
    }
    std::vector<SmallMotion> aims(8);
    for (SmallMotion& aim : aims) aim << 1e-3 * triple(), 1e-3 * triple();
    std::vector<MotionRow> same = rows;
    std::vector<SmallMotion> expected = aims;
    relax_all(same, expected);
    const std::vector<SmallMotion> found = nearest_motions(rows, aims, 1e-12, kSoft);
    for (size_t i = 0; i < found.size(); ++i)
      EXPECT_LT((found[i] - expected[i]).norm(), 1e-9) << trial << ' ' << i;
  }
}

TEST(NearestMotions, AreFoundWhereRowsHoldEachOther) {
  // A tower of bodies, each in contact with the next at nearly the same points: relaxation alone
  // would need far more sweeps than there are.
  std::vector<FreeBody> bodies;
  std::vector<MotionRow> rows;
  bodies.reserve(30);
  for (int i = 0; i < 30; ++i) bodies.push_back({ObjectId{}, Vec3(0, 0, 0.1 * i), 1, 0.2});
  for (int i = 0; i < 30; ++i)
    for (int k = 0; k < 4; ++k) {
      const Vec3 at(k % 2 ? 0.01 : -0.01, k / 2 ? 0.01 : -0.01, 0.1 * i - 0.05);
      rows.push_back(
          MotionRow::apart(bodies, i, i > 0 ? i - 1 : BodyContact::kGround, at, Vec3::UnitZ()));
      rows.back().least = -0.001;
      rows.back().least_push = -kInfinity;
    }
  const std::vector<SmallMotion> found =
      nearest_motions(rows, std::vector<SmallMotion>(30, SmallMotion::Zero()), 1e-11);
  // Each gap of a millimetre is closed, so that the top one sinks by all of them.
  for (int i = 0; i < 30; ++i) EXPECT_NEAR(found[i].z(), -0.001 * (i + 1), 1e-5) << i;
}

/// Two boards that hardly lean on each other.
Boxes tent_with_gaps() {
  Boxes s;
  const Vec3 board(0.01, 0.1, 0.15);
  s.add("left", board, {-0.0651, 0, 0.1454}, false, turn_about(Vec3::UnitY(), 20));
  s.add("right", board, {0.0651, 0, 0.1455}, false, turn_about(Vec3::UnitY(), -20));
  return s;
}

TEST(CloseGaps, ABoundThatNoStepAsksForChangesNothing) {
  const auto closed = [](Boxes& s, double most_step) {
    std::vector<Placement> given;
    for (const ObjectId id : s.ids) given.push_back({id, s.scene.at(id).pose});
    return close_gaps(s.scene, given, {default_clearance(s.scene), 0.005, most_step}).longest_step;
  };
  Boxes free = tent_with_gaps(), bounded = free, cut = free;
  const double longest = closed(free, kInfinity);
  EXPECT_GT(longest, 1e-4);
  EXPECT_EQ(closed(bounded, longest), longest);
  EXPECT_TRUE(same_bits(free.scene, bounded.scene));
  closed(cut, 0.5 * longest);
  EXPECT_FALSE(same_bits(free.scene, cut.scene));
}

TEST(Starts, StraightAboveAnotherFallTheSame) {
  const Pose low{{}, {0.1, 0.2, 0.3}}, high{{}, {0.1, 0.2, 0.4}}, beside{{}, {0.1, 0.21, 0.4}};
  const Pose turned{turn_about(Vec3::UnitZ(), 1), high.translation};
  EXPECT_TRUE(falls_as_another(high, {beside, low}));
  EXPECT_FALSE(falls_as_another(low, {high}));
  EXPECT_FALSE(falls_as_another(beside, {low, high}));
  EXPECT_FALSE(falls_as_another(turned, {low, high}));
}

TEST(Mend, GivesTheSameBitsByAnyNumberOfThreads) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> noise(-0.004, 0.004);
  Boxes bad = tent_with_gaps();
  // Some stacks beside the tent, each in the next.
  for (int i = 0; i < 12; ++i) {
    const int column = i / 3, row = i % 3;
    bad.add("box " + std::to_string(i), {0.05, 0.05, 0.05},
            {0.3 + 0.099 * column + noise(random), noise(random), 0.05 + 0.1 * row}, false,
            turn_about(Vec3(noise(random), noise(random), 0.01).normalized(), 2));
  }
  Scene by_one = bad.scene;
  in_arena(1, [&] { mend_scene(by_one, {}); });
  EXPECT_TRUE(is_true(by_one));
  for (const int num_threads : {2, 4}) {
    Scene by_many = bad.scene;
    in_arena(num_threads, [&] { mend_scene(by_many, {}); });
    EXPECT_TRUE(same_bits(by_many, by_one)) << num_threads;
  }
}

}  // namespace
}  // namespace trivet
