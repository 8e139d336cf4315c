// Heaps whose members hold each other up: parted together, brought into contact together.
#include <gtest/gtest.h>

#include <random>

#include "core/motion/motion.h"
#include "ops/detect/detector.h"
#include "ops/mend/boxes.h"
#include "ops/mend/close_gaps.h"
#include "ops/mend/mend.h"
#include "ops/mend/part_together.h"
#include "ops/placement/clearance.h"
#include "ops/stability/stability.h"

namespace trivet {
namespace {

using namespace trivet::test;

const Vec3 kBoard(0.01, 0.1, 0.15), kSmallBox(0.05, 0.05, 0.05);

std::vector<Placement> taken_out(Boxes& s) {
  std::vector<Placement> out;
  for (const ObjectId id : s.ids) {
    out.push_back({id, s.scene.at(id).pose});
    edit_object(s.scene, id, [](Object& o) { o.placed = false; });
  }
  return out;
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

/// Tents of two boards each, side by side; a plank across both, and a log in the valley between
/// them.
Boxes heap_of_tents(bool whole) {
  Boxes s;
  const Rotation left = turn_about(Vec3::UnitY(), 20), right = turn_about(Vec3::UnitY(), -20);
  for (const int tent : {0, 1}) {
    if (tent > 0 && !whole) break;
    const std::string name = tent == 0 ? "a" : "b";
    s.add(name + " left", kBoard, {0.27 * tent - 0.0641, 0, 0.1453}, false, left);
    s.add(name + " right", kBoard, {0.27 * tent + 0.0641, 0, 0.1453}, false, right);
  }
  if (!whole) return s;
  s.add("log", {0.03, 0.09, 0.03}, {0.135, 0, 0.14}, false, turn_about(Vec3::UnitY(), 30));
  s.add("plank", {0.2, 0.03, 0.008}, {0.135, 0, 0.3005});
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
  Boxes s = heap_of_tents(false);
  ASSERT_TRUE(mended(s.scene, 0.005).unable.empty());
  const Scene leaning = s.scene;
  edit_object(s.scene, s.ids[0], [](Object& o) { o.pose.translation += Vec3(-0.001, 0, 1e-4); });
  edit_object(s.scene, s.ids[1], [](Object& o) { o.pose.translation += Vec3(0.001, 0, 2e-4); });
  EXPECT_FALSE(stands(s.scene));
  const GapsToClose gaps{default_clearance(s.scene), 0.005};
  EXPECT_TRUE(close_gaps(s.scene, s.ids, gaps).empty());
  EXPECT_TRUE(stands(s.scene));
  for (const ObjectId id : s.ids)
    EXPECT_LT((s.at(id) - leaning.at(id).pose.translation).norm(), 0.0025) << id.index;
}

TEST(CloseGaps, WhatNothingWithinReachHoldsIsNamedAndStays) {
  Boxes s = heap_of_tents(false);
  mended(s.scene, 0.005);
  const ObjectId floating = s.add("floating", kSmallBox, {0.5, 0, 0.1});
  const GapsToClose gaps{default_clearance(s.scene), 0.005};
  EXPECT_EQ(close_gaps(s.scene, s.ids, gaps), std::vector{floating});
  EXPECT_EQ(s.at(floating), Vec3(0.5, 0, 0.1));
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
TEST(Heaps, AHeapOfMutualSupportsIsMendedNearby) {
  Boxes given = heap_of_tents(true);
  ASSERT_TRUE(mended(given.scene, 0.005).unable.empty());
  ASSERT_TRUE(stands(given.scene));
  std::mt19937_64 random(1);
  for (const double noise : {0.001, 0.005}) {
    int near = 0, all = 0, kept = 0, meant = 0;
    for (int run = 0; run < 4; ++run) {
      Boxes s = given;
      perturb(s, noise, noise == 0.001 ? 1 : 3, random);
      const Scene bad = s.scene;
      Detector detector;
      EXPECT_TRUE(mended(s.scene, 0, &detector).unable.empty());
      EXPECT_TRUE(stands(s.scene)) << noise << " " << run;
      EXPECT_LT(detector.work().num_queries, 400 * static_cast<int>(s.ids.size()));
      for (const ObjectId id : s.ids) {
        ++all;
        near += (s.at(id) - bad.at(id).pose.translation).norm() <= 2 * 1.54 * noise;
      }
      const auto [k, m] = kept_of(given.scene, s.scene);
      kept += k, meant += m;
      Scene again = bad;
      mended(again, 0);
      EXPECT_TRUE(same_bits(again, s.scene));
      RecordProperty("queries", std::to_string(detector.work().num_queries));
    }
    std::printf("%g: near %d of %d, kept %d of %d\n", noise, near, all, kept, meant);
    EXPECT_GE(near, 0.8 * all) << noise;
    EXPECT_GE(kept, 0.8 * meant) << noise;
  }
}

}  // namespace
}  // namespace trivet
