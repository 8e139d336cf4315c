// Heaps whose members hold each other up: parted together, brought into contact together.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <optional>
#include <random>

#include "core/motion/compose.h"
#include "ops/detect/detector.h"
#include "ops/mend/boxes.h"
#include "ops/mend/close_gaps.h"
#include "ops/mend/mend.h"
#include "ops/mend/part_by_turns.h"
#include "ops/operations/perform.h"
#include "ops/placement/clearance.h"
#include "ops/stability/stability.h"

namespace trivet {
namespace {

using namespace trivet::test;

const Vec3 kBoard(0.01, 0.1, 0.15), kSmallBox(0.05, 0.05, 0.05);

std::vector<Placement> placements_of(const Boxes& s) {
  std::vector<Placement> out;
  for (const ObjectId id : s.ids) out.push_back({id, s.scene.at(id).pose});
  return out;
}

std::vector<Placement> taken_out(Boxes& s) {
  for (const ObjectId id : s.ids) edit_object(s.scene, id, [](Object& o) { o.placed = false; });
  return placements_of(s);
}

TEST(PartTogether, TwoGiveWayByHalf) {
  Boxes s;
  s.add("a", kSmallBox, {0, 0, 0.2});
  s.add("b", kSmallBox, {0.096, 0.001, 0.2});
  const std::vector<Placement> given = taken_out(s);
  const std::vector<Placement> out = part_together(s.scene, given, 1e-5);
  EXPECT_NEAR((out[0].pose.translation - given[0].pose.translation - Vec3(-0.002, 0, 0)).norm(), 0,
              2e-5);
  EXPECT_NEAR((out[1].pose.translation - given[1].pose.translation - Vec3(0.002, 0, 0)).norm(), 0,
              2e-5);
}

TEST(PartTogether, WhatStaysTakesNoPart) {
  Boxes s;
  s.add("a", kSmallBox, {0, 0, 0.047});
  const std::vector<Placement> given = taken_out(s);
  s.add("wall", kSmallBox, {0.098, 0, 0.05}, true);
  const std::vector<Placement> out = part_together(s.scene, given, 1e-5);
  EXPECT_NEAR((out[0].pose.translation - Vec3(-0.002, 0, 0.05)).norm(), 0, 3e-5);
}

TEST(PartTogether, WhatIsFreeStaysToTheBit) {
  Boxes s;
  s.add("a", kSmallBox, {0, 0, 0.05});
  s.add("b", kSmallBox, {0.101, 0, 0.05});
  const std::vector<Placement> given = taken_out(s);
  const std::vector<Placement> out = part_together(s.scene, given, 1e-5);
  for (size_t i = 0; i < given.size(); ++i)
    EXPECT_EQ(out[i].pose.translation, given[i].pose.translation);
}

TEST(PartByTurns, ABoardThatIsTurnedIntoABoxTurnsBack) {
  const double degrees = 2;
  Boxes s;
  s.add("board", {0.15, 0.1, 0.01}, {0, 0, 0.2}, false, turn_about(Vec3::UnitY(), degrees));
  s.add("box", {0.02, 0.05, 0.02}, {0.12, 0, 0.2 - 0.03 - 0.0005}, true);
  std::vector<Placement> given = placements_of(s);
  given.pop_back();
  edit_object(s.scene, s.ids[0], [](Object& o) { o.placed = false; });
  const std::vector<Placement> turned = part_by_turns(s.scene, given, 1e-5);
  const std::vector<Placement> shifted = part_together(s.scene, given, 1e-5);
  EXPECT_TRUE(crossings_of(s.scene, turned).empty());
  EXPECT_TRUE(crossings_of(s.scene, shifted).empty());
  const auto way = [&](const std::vector<Placement>& to) {
    return (to[0].pose.translation - given[0].pose.translation).norm();
  };
  EXPECT_LT(way(turned), 0.75 * way(shifted));
  EXPECT_LT(turn_between_deg(turned[0].pose.rotation, {}), degrees);
  EXPECT_EQ(turn_between_deg(shifted[0].pose.rotation, given[0].pose.rotation), 0);
}

/// Two bodies and the floor, coming apart in random ways; of some rows just as far.
std::vector<MotionRow> random_rows(const std::vector<FreeBody>& bodies, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  const auto triple = [&] {
    const double x = normal(random), y = normal(random);
    return Vec3(x, y, normal(random));
  };
  std::vector<MotionRow> out;
  for (int k = 0; k < 5; ++k) {
    const Index from = k < 3 ? 1 : BodyContact::kGround;
    const Vec3 point = 0.1 * triple();
    out.push_back(MotionRow::apart(bodies, 0, from, point, triple().normalized()));
    out.back().least = 1e-3 * normal(random);
    if (k % 2 == 0) out.back().least_push = -kInfinity;
  }
  return out;
}

// The rows of a subset are met just so: by normal equations.
std::optional<std::vector<SmallMotion>> met_by(const std::vector<MotionRow>& rows, int subset) {
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(5, 12);
  Eigen::VectorXd least = Eigen::VectorXd::Zero(5);
  for (int k = 0; k < 5; ++k) {
    if (!(subset >> k & 1)) continue;
    a.row(k).head(6) = rows[k].of_on;
    if (rows[k].from != BodyContact::kGround) a.row(k).tail(6) = rows[k].of_from;
    least[k] = rows[k].least;
  }
  const Eigen::VectorXd m = a.completeOrthogonalDecomposition().solve(least);
  std::vector<SmallMotion> out{m.head(6), m.tail(6)};
  for (int k = 0; k < 5; ++k) {
    const double beyond = rows[k].of(out) - rows[k].least;
    if (beyond < -1e-9 || (rows[k].least_push < 0 && beyond > 1e-9)) return std::nullopt;
  }
  return out;
}

double squared(const std::vector<SmallMotion>& motions) {
  return motions[0].squaredNorm() + motions[1].squaredNorm();
}

TEST(NearestMotions, AreTheBestOfAllSubsetsOfRows) {
  std::mt19937_64 random(1);
  const std::vector<FreeBody> bodies{{ObjectId{}, Vec3(0, 0, 0.1), 1, 0.2},
                                     {ObjectId{}, Vec3(0.1, 0, 0), 1, 0.3}};
  int num_short = 0;
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<MotionRow> rows = random_rows(bodies, random);
    double best = kInfinity;
    for (int subset = 0; subset < 32; ++subset)
      if (const auto m = met_by(rows, subset)) best = std::min(best, squared(*m));
    if (best == kInfinity || best > 1e-4) continue;  // ill posed
    ++num_short;
    const std::vector<SmallMotion> found =
        nearest_motions(rows, {SmallMotion::Zero(), SmallMotion::Zero()}, 1e-10);
    EXPECT_NEAR(std::sqrt(squared(found)), std::sqrt(best), 1e-5) << trial;
  }
  EXPECT_GT(num_short, 150);
}

TEST(NearestMotions, PullNoHarderThanTheyMay) {
  const std::vector<FreeBody> bodies{{ObjectId{}, Vec3::Zero(), 1, 0.2}};
  std::vector<MotionRow> rows{
      MotionRow::apart(bodies, 0, BodyContact::kGround, Vec3::Zero(), Vec3::UnitZ())};
  rows[0].least = -0.003;
  for (const double pull : {0.0, 0.001, 0.01}) {
    rows[0].least_push = -pull, rows[0].push = 0;
    const double z = nearest_motions(rows, {SmallMotion::Zero()}, 1e-10)[0].z();
    EXPECT_NEAR(z, -std::min(pull, 0.003), 1e-7);
  }
}

TEST(SmallMotions, LeadToThePose) {
  const FreeBody body{ObjectId{}, Vec3(0.1, 0.2, 0.3), 1, 0.2};
  const Pose here{turn_about(Vec3(1, 2, 3).normalized(), 50), {0.15, 0.2, 0.25}};
  const Pose there{turn_about(Vec3(1, 2, 2).normalized(), 53), {0.16, 0.19, 0.25}};
  const Pose moved = moved_by(body, here, motion_to(body, here, there));
  EXPECT_NEAR((moved.translation - there.translation).norm(), 0, 1e-12);
  EXPECT_LT(turn_between_deg(moved.rotation, there.rotation), 1e-6);
}

/// Two boards that lean on each other.
Boxes tent() {
  Boxes s;
  s.add("left", kBoard, {-0.0641, 0, 0.1453}, false, turn_about(Vec3::UnitY(), 20));
  s.add("right", kBoard, {0.0641, 0, 0.1453}, false, turn_about(Vec3::UnitY(), -20));
  return s;
}

/// Seven bricks, slabs and bars let fall onto each other in any orientation.
Boxes heap_of_bricks(std::mt19937_64& random) {
  Boxes s;
  std::uniform_real_distribution<double> half(0.015, 0.05), place(-0.05, 0.05), part(-1, 1);
  for (int i = 0; i < 7; ++i) {
    const Vec3 size(half(random), half(random), half(random));
    const ObjectId id = s.add("brick " + std::to_string(i), size, {0, 0, 10});
    edit_object(s.scene, id, [](Object& o) { o.placed = false; });
    const Rotation turn = Rotation{part(random), part(random), part(random), part(random)};
    const double x = place(random), y = place(random);
    EXPECT_TRUE(put(s.scene, id, {turn.normalized(), {x, y, 0.6}}).ok());
  }
  return s;
}

MendedScene mended(Scene& scene, double tolerance, Detector* detector = nullptr) {
  MendOptions options;
  options.tolerance = tolerance;
  options.context.detector = detector;
  return mend_scene(scene, options);
}

bool stands(const Scene& given) {
  Scene scene = given;
  update_contacts(scene);
  return is_true(scene) && stability(scene).status != Stability::Status::Unstable;
}

TEST(CloseGaps, BoardsThatMissEachOtherComeToLean) {
  Boxes s = tent();
  ASSERT_TRUE(mended(s.scene, 0.005).unable.empty());
  const Scene leaning = s.scene;
  edit_object(s.scene, s.ids[0], [](Object& o) { o.pose.translation += Vec3(-0.001, 0, 1e-4); });
  edit_object(s.scene, s.ids[1], [](Object& o) { o.pose.translation += Vec3(0.001, 0, 2e-4); });
  EXPECT_FALSE(stands(s.scene));
  const GapsToClose gaps{default_clearance(s.scene), 0.005};
  EXPECT_TRUE(close_gaps(s.scene, placements_of(s), gaps).not_held.empty());
  EXPECT_TRUE(stands(s.scene));
  for (const ObjectId id : s.ids)
    EXPECT_LT((s.at(id) - leaning.at(id).pose.translation).norm(), 0.0025) << id.index;
}

TEST(CloseGaps, WhatNothingWithinReachHoldsIsNamedAndStays) {
  Boxes s = tent();
  mended(s.scene, 0.005);
  const ObjectId floating = s.add("floating", kSmallBox, {0.5, 0, 0.1});
  const GapsToClose gaps{default_clearance(s.scene), 0.005};
  const ClosedGaps closed = close_gaps(s.scene, placements_of(s), gaps);
  EXPECT_EQ(closed.not_held, std::vector{floating});
  EXPECT_EQ(closed.missed, std::vector{floating});
  EXPECT_EQ(s.at(floating), Vec3(0.5, 0, 0.1));
}

TEST(CloseGaps, EndsNearestToTheGivenPoses) {
  Boxes s;
  const ObjectId id = s.add("box", kSmallBox, {0, 0, 0.0502});
  const std::vector<Placement> given = placements_of(s);
  edit_object(s.scene, id, [](Object& o) { o.pose.translation += Vec3(0.002, 0.001, 1e-4); });
  const GapsToClose gaps{default_clearance(s.scene), 0.005};
  EXPECT_TRUE(close_gaps(s.scene, given, gaps).not_held.empty());
  EXPECT_NEAR((s.at(id) - Vec3(0, 0, 0.05)).norm(), 0, 1e-5);
}

TEST(CloseGaps, StaysWhereItIsIfTheGivenPosesAreNoAim) {
  Boxes s;
  const ObjectId id = s.add("box", kSmallBox, {0, 0, 0.0502});
  const std::vector<Placement> given = placements_of(s);
  edit_object(s.scene, id, [](Object& o) { o.pose.translation += Vec3(0.002, 0.001, 1e-4); });
  GapsToClose gaps{default_clearance(s.scene), 0.005};
  gaps.near_given = false;
  EXPECT_TRUE(close_gaps(s.scene, given, gaps).not_held.empty());
  EXPECT_NEAR((s.at(id) - Vec3(0.002, 0.001, 0.05)).norm(), 0, 1e-5);
}

TEST(CloseGaps, OfManyCarriersThoseCarryThatTakeTheLeastMotion) {
  const std::vector<std::pair<double, double>> posts{
      {-0.2, 0.001}, {-0.1, 0.004}, {0, 0.002}, {0.1, 0.003}, {0.2, 0.001}};  // place, gap
  Boxes s;
  const ObjectId plank = s.add("plank", {0.25, 0.05, 0.01}, {0, 0, 0.21});
  const std::vector<Placement> given = placements_of(s);
  for (const auto& [x, gap] : posts) {
    const double half = 0.5 * (0.2 - gap);
    s.add("post " + std::to_string(x), {0.01, 0.02, half}, {x, 0, half}, true);
  }
  const GapsToClose gaps{default_clearance(s.scene), 0.005};
  EXPECT_TRUE(close_gaps(s.scene, given, gaps).not_held.empty());
  // All others would take more, or stand in the way.
  EXPECT_NEAR((s.at(plank) - Vec3(0, 0, 0.209)).norm(), 0, 1e-5);
  EXPECT_LT(turn_between_deg(s.scene.at(plank).pose.rotation, {}), 0.01);
  EXPECT_TRUE(stands(s.scene));
}

// Bottom up, a board of a tent has nothing to lean on.
TEST(Heaps, AFifthOfTiltedOnesMakesOne) {
  Boxes s = tent();
  ASSERT_TRUE(mended(s.scene, 0.005).unable.empty());
  const Scene leaning = s.scene;
  edit_object(s.scene, s.ids[0], [](Object& o) { o.pose.translation += Vec3(-0.001, 0, 1e-4); });
  edit_object(s.scene, s.ids[1], [](Object& o) { o.pose.translation += Vec3(0.001, 0, 2e-4); });
  for (int i = 0; i < 8; ++i)
    s.add("level " + std::to_string(i), kSmallBox, {0.5 + 0.2 * i, 0, 0.051});
  EXPECT_TRUE(mended(s.scene, 0.005).unable.empty());
  EXPECT_TRUE(stands(s.scene));
  for (int i = 0; i < 2; ++i)
    EXPECT_LT((s.at(s.ids[i]) - leaning.at(s.ids[i]).pose.translation).norm(), 0.0025) << i;
}

void perturb(Boxes& s, double metres, double degrees, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  const auto triple = [&] {
    const double x = normal(random), y = normal(random);
    return Vec3(x, y, normal(random));
  };
  for (const ObjectId id : s.ids) {
    const Vec3 shift = metres * triple(), axis = triple().normalized();
    const double turn = degrees * normal(random);
    edit_object(s.scene, id, [&](Object& o) {
      o.pose.translation += shift;
      o.pose.rotation = (turn_about(axis, turn) * o.pose.rotation).normalized();
    });
  }
}

// Supports by names, of the true heap that are among those of the mended one.
std::pair<int, int> kept_of(const Scene& before, const Scene& after) {
  std::pair<int, int> out;
  for (const ObjectId id : before.ids())
    for (const ObjectContact& c : before.at(id).contacts) {
      if (!holds_up(c)) continue;
      ++out.second;
      const auto& now = after.at(id).contacts;
      out.first += std::any_of(now.begin(), now.end(), [&](const ObjectContact& other) {
        return holds_up(other) && other.with == c.with;
      });
    }
  return out;
}

// The cost is counted, as times differ from machine to machine.
TEST(Heaps, OfBricksAreMendedNearby) {
  std::mt19937_64 random(1);
  const Boxes given = heap_of_bricks(random);
  ASSERT_TRUE(stands(given.scene));
  for (const double noise : {0.001, 0.005}) {
    int near = 0, all = 0, kept = 0, meant = 0;
    for (int run = 0; run < 4; ++run) {
      Boxes s = given;
      perturb(s, noise, noise == 0.001 ? 1 : 3, random);
      const Scene bad = s.scene;
      Detector detector;
      EXPECT_TRUE(mended(s.scene, 0, &detector).unable.empty());
      EXPECT_TRUE(stands(s.scene)) << noise << " " << run;
      EXPECT_LT(detector.work().num_queries, 600 * static_cast<int>(s.ids.size()));
      for (const ObjectId id : s.ids) {
        ++all;
        const double way = (s.at(id) - bad.at(id).pose.translation).norm();
        near += way <= 2 * 1.54 * noise;
        EXPECT_LE(way, 6 * 1.54 * noise) << noise << " " << run;
      }
      const auto [k, m] = kept_of(given.scene, s.scene);
      kept += k, meant += m;
      Scene again = bad;
      mended(again, 0);
      EXPECT_TRUE(same_bits(again, s.scene));
    }
    EXPECT_GE(near, (noise == 0.001 ? 0.95 : 0.8) * all) << noise;
    // Which of several near supports carries is a close choice at 5 mm.
    EXPECT_GE(kept, (noise == 0.001 ? 0.9 : 0.85) * meant) << noise;
  }
}

// All judge by the clearance that was asked for, the whole scene's forces, too.
TEST(Heaps, AreMendedByACoarserClearance) {
  Boxes s = tent();
  MendOptions options;
  options.tolerance = 0.005;
  options.settle.clearance = 20 * default_clearance(s.scene);
  EXPECT_TRUE(mend_scene(s.scene, options).unable.empty());
  update_contacts(s.scene, options.settle.clearance, options.settle);
  EXPECT_TRUE(check_scene(s.scene, 0, options.settle.clearance, options.settle).ok());
}

}  // namespace
}  // namespace trivet
