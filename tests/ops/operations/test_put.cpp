// PUT on various supports.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "ops/operations/arrangements.h"
#include "ops/operations/perform.h"
#include "support/effort.h"

namespace trivet {
namespace {

using test::Arrangement;

/// Supports of an object after a PUT.
struct Outcome {
  bool floor = false, first = false, second = false;  // first and second support of the scene
  Vec3 centre = Vec3::Zero();
};

Outcome outcome_of(const Arrangement& a) {
  Outcome out;
  const auto ids = a.scene.ids();
  for (const ObjectContact& entry : a.scene.at(a.object).contacts) {
    out.floor |= entry.with.is_floor();
    out.first |= entry.with == Support(ids[0]);
    out.second |= ids.size() > 2 && entry.with == Support(ids[1]);
  }
  out.centre = a.scene.at(a.object).centre_of_mass();
  return out;
}

/// Expects that every PUT succeeds.
std::vector<Outcome> expect_all_ok(test::MakeArrangement make, int num) {
  std::vector<Outcome> outcomes;
  int num_motions = 0, most = 0;
  num = test::with_effort(num);
  for (int i = 0; i < num; ++i) {
    SCOPED_TRACE("arrangement " + std::to_string(i));
    Arrangement a = make(i);
    const OperationResult result = test::put_twice(a);
    EXPECT_TRUE(result.ok()) << a.name << ' ' << i << ": " << result.reason();
    if (result.ok()) outcomes.push_back(outcome_of(a));
    num_motions += result.num_motions;
    most = std::max(most, result.num_motions);
  }
  std::printf("%zu of %d ok, %.1f motions in the mean, %d at most\n", outcomes.size(), num,
              1.0 * num_motions / num, most);
  return outcomes;
}

template <class Condition>
double share(const std::vector<Outcome>& outcomes, Condition condition) {
  return 1.0 * std::count_if(outcomes.begin(), outcomes.end(), condition) /
         static_cast<double>(outcomes.size());
}

TEST(Put, LandsOnFloor) {
  const auto out = expect_all_ok(test::on_floor, 160);
  EXPECT_EQ(share(out, [](const Outcome& o) { return o.floor; }), 1);
}

TEST(Put, LandsStickOnSaucer) {
  const auto out = expect_all_ok(test::stick_on_saucer, 48);
  EXPECT_GT(share(out, [](const Outcome& o) { return o.first; }), 0.7);
}

TEST(Put, LandsInBowl) {
  const auto out = expect_all_ok(test::into_bowl, 96);
  EXPECT_GT(share(out, [](const Outcome& o) { return o.first && !o.floor; }), 0.9);
  EXPECT_GT(share(out, [](const Outcome& o) { return o.centre.head<2>().norm() < 0.3; }), 0.9);
}

TEST(Put, LandsTorusOverPeg) {
  const auto out = expect_all_ok(test::torus_over_peg, 60);
  // Around the peg, near its foot.
  const double around = share(
      out, [](const Outcome& o) { return o.centre.head<2>().norm() < 0.05 && o.centre.z() < 0.1; });
  EXPECT_GT(around, 0.4);
}

TEST(Put, LandsOnTwoSupportsOfDifferentHeights) {
  const auto out = expect_all_ok(test::on_two_heights, 96);
  EXPECT_GT(share(out, [](const Outcome& o) { return o.first && o.second; }), 0.2);
}

TEST(Put, LandsAgainstWall) {
  const auto out = expect_all_ok(test::against_wall, 96);
  EXPECT_GT(share(out, [](const Outcome& o) { return o.first && o.floor; }), 0.1);
}

TEST(Put, LandsInWedge) {
  const auto out = expect_all_ok(test::into_wedge, 96);
  EXPECT_GT(share(out, [](const Outcome& o) { return o.first && o.second; }), 0.5);
}

TEST(Put, HangsHookOnBar) {
  const auto out = expect_all_ok(test::hook_on_bar, 48);
  EXPECT_GT(share(out, [](const Outcome& o) { return o.first && !o.floor; }), 0.9);
}

TEST(Put, LandsOnBall) { expect_all_ok(test::onto_ball, 96); }
TEST(Put, LandsOnSlope) { expect_all_ok(test::onto_slope, 96); }

// The default rules: friction of the materials, the whole at rest. Steep slopes and balls let
// things go on; in few arrangements they are wedged.
TEST(PutWithFriction, KeepsInvariants) {
  const SettleOptions options;
  int num = 0, num_ok = 0;
  for (const test::MakeArrangement make :
       {test::on_floor, test::stick_on_saucer, test::into_bowl, test::torus_over_peg,
        test::on_two_heights, test::against_wall, test::into_wedge, test::hook_on_bar,
        test::onto_ball, test::onto_slope})
    for (int i = 0; i < test::with_effort(12); ++i, ++num) {
      Arrangement a = make(i);
      SCOPED_TRACE(a.name + " " + std::to_string(i));
      num_ok += test::put_twice(a, options).ok();
    }
  std::printf("%d of %d ok\n", num_ok, num);
  EXPECT_GE(num_ok, 0.95 * num);
}

// It leans on three points of a cone, its centre 4.3e-5 outside the support polygon; the next
// contact is 32 clearances away, and the turn that closes this gap lowers the centre by only 0.053
// clearances.
TEST(Put, MakesLastClosingTurnOfTorus) {
  Arrangement a = test::torus_over_peg(221);
  const OperationResult result = test::put_twice(a);
  EXPECT_TRUE(result.ok()) << result.reason();
}

// --- the paper's rules, for comparison -------------------------------------------------------

int num_refused(test::MakeArrangement make, int num) {
  SettleOptions literal;
  literal.literal_paper_rules = true;
  int refused = 0;
  for (int i = 0; i < num; ++i) {
    Arrangement a = make(i);
    refused += !put(a.scene, a.object, a.start, literal).ok();
  }
  return refused;
}

TEST(PutByLiteralRules, IsNeverStuckOnFloor) {
  EXPECT_EQ(num_refused(test::on_floor, test::with_effort(160)), 0);
}

TEST(PutByLiteralRules, IsStuckInSomeOtherScenes) {
  const std::vector<std::pair<const char*, test::MakeArrangement>> kinds{
      {"saucer", test::stick_on_saucer}, {"bowl", test::into_bowl},
      {"peg", test::torus_over_peg},     {"two heights", test::on_two_heights},
      {"wall", test::against_wall},      {"wedge", test::into_wedge},
      {"hook", test::hook_on_bar},       {"ball", test::onto_ball},
      {"slope", test::onto_slope}};
  const int num = test::with_effort(48);
  int refused = 0;
  for (const auto& [name, make] : kinds) {
    const int n = num_refused(make, num);
    std::printf("  %-12s %d of %d refused\n", name, n, num);
    refused += n;
  }
  const double part = 1.0 * refused / (num * static_cast<int>(kinds.size()));
  EXPECT_GT(part, 0.01);
  EXPECT_LT(part, 0.4);
}

TEST(PutByLiteralRules, AcceptsWedgedObjectOnRequest) {
  SettleOptions literal, accept;
  literal.literal_paper_rules = accept.literal_paper_rules = accept.accept_wedged = true;
  int num_wedged = 0;
  for (int i = 0; i < 48; ++i) {
    Arrangement refused = test::against_wall(i), accepted = test::against_wall(i);
    const OperationResult result = put(refused.scene, refused.object, refused.start, literal);
    const OperationResult with = put(accepted.scene, accepted.object, accepted.start, accept);
    EXPECT_TRUE(with.ok()) << with.reason();
    const ObjectState state = accepted.scene.at(accepted.object).state;
    EXPECT_EQ(state, result.ok() ? ObjectState::Stable : ObjectState::Wedged);
    if (result.ok()) continue;
    ++num_wedged;
    EXPECT_TRUE(result.reason().starts_with("\"object\" is wedged between ") ||
                result.reason().starts_with("\"object\" is wedged against "))
        << result.reason();
    EXPECT_FALSE(refused.scene.at(refused.object).placed);
  }
  EXPECT_GT(num_wedged, 0);
}

}  // namespace
}  // namespace trivet
