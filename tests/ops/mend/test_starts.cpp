// Exact heights of places, thin things that stand where a row has room, and what is no heap.
#include <gtest/gtest.h>

#include <random>

#include "core/motion/compose.h"
#include "ops/mend/boxes.h"
#include "ops/mend/in_place.h"
#include "ops/mend/starts.h"
#include "ops/placement/clearance.h"

namespace trivet {
namespace {

using namespace trivet::test;

ObjectIntent meant_on(ObjectId id, const std::vector<ObjectId>& supports) {
  ObjectIntent out;
  out.id = id;
  for (const ObjectId on : supports) out.on.push_back({Support(on), 1, false});
  return out;
}

// A box above others of random places and heights: the highest that it covers carries it.
TEST(InContact, IsAtTheHighestSupportBelow) {
  std::mt19937_64 random(11);
  const auto uniform = [&](double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(random);
  };
  constexpr double kClearance = 2e-6, kTolerance = 0.02;
  int num_found = 0;
  for (int run = 0; run < 100; ++run) {
    Boxes s;
    double highest = -kInfinity;
    for (int i = 0; i < 5; ++i) {
      const Vec3 half(uniform(0.0005, 0.03), uniform(0.0005, 0.03), 0.02);
      const Vec3 at(uniform(-0.1, 0.1), uniform(-0.1, 0.1), uniform(0.1, 0.11));
      s.add("support " + std::to_string(i), half, at, true);
      if (std::abs(at.x()) < 0.05 + half.x() && std::abs(at.y()) < 0.05 + half.y())
        highest = std::max(highest, at.z() + half.z());
    }
    const std::vector<ObjectId> supports = s.ids;
    const double given = uniform(0.155, 0.18);
    const ObjectId box = s.add("box", {0.05, 0.05, 0.03}, {0, 0, given});
    const Pose pose = s.scene.at(box).pose;
    const Pose out = in_contact(s.scene, meant_on(box, supports), pose, kTolerance, kClearance);
    // It is looked for from 0.7 tolerances above to a tolerance below.
    const double gap = given - 0.03 - highest;
    if (gap > -0.69 * kTolerance && gap < 0.99 * kTolerance) {
      EXPECT_NEAR(out.translation.z() - 0.03 - highest, kClearance, 1e-7) << run;
      ++num_found;
    } else if (gap > 1.01 * kTolerance + 2e-5 || gap < -0.71 * kTolerance) {
      EXPECT_TRUE(out.translation == pose.translation) << run;
    }
  }
  EXPECT_GT(num_found, 30);
  EXPECT_LT(num_found, 95);
}

TEST(InContact, WhatIsNotPlacedDoesNotCount) {
  Boxes s;
  const ObjectId table = s.add("table", {0.5, 0.5, 0.02}, {0, 0, 0.7}, true);
  const ObjectId tray = s.add("tray", {0.1, 0.1, 0.005}, {0, 0, 0.725});
  const ObjectId box = s.add("box", {0.05, 0.05, 0.05}, {0, 0, 0.782});
  edit_object(s.scene, tray, [](Object& o) { o.placed = false; });
  const Pose pose = s.scene.at(box).pose;
  EXPECT_EQ(in_contact(s.scene, meant_on(box, {tray}), pose, 0.02, 2e-6).translation,
            pose.translation);
  EXPECT_NEAR(in_contact(s.scene, meant_on(box, {tray, table}), pose, 0.02, 2e-6).translation.z(),
              0.770002, 1e-7);
}

// All are taken out before the first comes back: the clearance is then that of the object itself.
TEST(Mend, StandsClearOfTheFloorWhereNothingElseIs) {
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  for (int run = 0; run < 20; ++run) {
    Boxes s;
    for (int i = 0; i < 3; ++i)
      s.add("box " + std::to_string(i), {0.04, 0.03, 0.02 + 0.01 * i},
            {0.2 * i, 0, 0.02 + 0.01 * i + 0.002 * normal(random)}, false,
            turn_about(Vec3(normal(random), normal(random), 1).normalized(), normal(random)));
    EXPECT_TRUE(mend_scene(s.scene, {}).unable.empty()) << run;
    for (const ObjectId id : s.ids)
      EXPECT_GT(s.scene.world_box(id).lower.z(), 0.1 * clearance_of(s.scene, {})) << run;
  }
}

// Let go a hair above its place, a thin book tips onto its neighbour, and takes the room of others.
TEST(Mend, ThinBooksOfATightRowAllStand) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  for (int run = 0; run < 8; ++run) {
    Boxes s;
    s.add("shelf", {0.5, 0.2, 0.2}, {0, 0, 0.2}, true);
    constexpr int kBooks = 14;
    double x = -0.15;
    std::vector<ObjectId> books;
    s.add("left", {0.01, 0.2, 0.2}, {x - 0.011, 0, 0.6}, true);
    for (int i = 0; i < kBooks; ++i) {
      const Vec3 half(0.006 + 0.0015 * (i * 5 % 7), 0.06 + 0.003 * (i % 4), 0.09 + 0.004 * (i % 5));
      const Vec3 off(normal(random), normal(random), normal(random));
      const Vec3 axis = Vec3(normal(random), normal(random), normal(random)).normalized();
      s.add("book " + std::to_string(i), half, Vec3(x + half.x(), 0, 0.4 + half.z()) + 0.003 * off,
            false, turn_about(axis, normal(random)));
      x += 2 * half.x() + 0.0008;
    }
    s.add("right", {0.01, 0.2, 0.2}, {x + 0.011, 0, 0.6}, true);
    MendOptions options;
    options.tolerance = 0.01;
    const MendedScene out = mend_scene(s.scene, options);
    EXPECT_TRUE(out.unable.empty()) << run;
    EXPECT_TRUE(is_true(s.scene)) << run;
    for (const ObjectId id : books) {
      const Aabb box = s.scene.world_box(id);
      EXPECT_NEAR(box.lower.z(), 0.4, 1e-5) << run << ": " << s.scene.at(id).name;
    }
    for (const SettledObject& o : out.moved) EXPECT_LT(o.moved, 0.018) << run << ": " << o.name;
  }
}

std::vector<ObjectId> all_of(const Intent& intent) {
  std::vector<ObjectId> out;
  for (const ObjectIntent& o : intent.objects) out.push_back(o.id);
  return out;
}

TEST(IsHeap, TiltedThingsOnLevelOnesAreNone) {
  Boxes s;
  s.add("table", {0.5, 0.5, 0.02}, {0, 0, 0.7}, true);
  const Rotation tilted = turn_about(Vec3::UnitY(), 25);
  s.add("keyboard", {0.2, 0.08, 0.01}, {-0.2, 0.2, 0.81}, false, tilted);
  s.add("telephone", {0.08, 0.1, 0.03}, {0.2, 0.2, 0.78}, false, tilted);
  s.add("book", {0.08, 0.1, 0.02}, {0.2, -0.2, 0.74});
  const Intent intent = infer_intent(s.scene, 0.02);
  EXPECT_FALSE(is_heap(intent, all_of(intent)));
}

TEST(IsHeap, BoardsOfTentAreOne) {
  Boxes s;
  s.add("left", {0.01, 0.1, 0.15}, {-0.0641, 0, 0.1453}, false, turn_about(Vec3::UnitY(), 20));
  s.add("right", {0.01, 0.1, 0.15}, {0.0641, 0, 0.1453}, false, turn_about(Vec3::UnitY(), -20));
  const Intent intent = infer_intent(s.scene, 0.005);
  EXPECT_TRUE(is_heap(intent, all_of(intent)));
}

TEST(IsHeap, TiltedThingsOnEachOtherAreOne) {
  Boxes s;
  s.add("low", {0.1, 0.1, 0.01}, {0, 0, 0.05}, false, turn_about(Vec3::UnitY(), 25));
  s.add("high", {0.1, 0.1, 0.01}, {0, 0, 0.075}, false, turn_about(Vec3::UnitY(), 25));
  s.add("book", {0.08, 0.1, 0.02}, {0.5, -0.2, 0.02});
  const Intent intent = infer_intent(s.scene, 0.02);
  EXPECT_TRUE(is_heap(intent, all_of(intent)));
}

}  // namespace
}  // namespace trivet
