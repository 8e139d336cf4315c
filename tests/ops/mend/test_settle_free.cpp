// Settling and mending of scenes: known answers; what is true stays to the bit.
#include <gtest/gtest.h>

#include <cmath>

#include "ops/mend/boxes.h"
#include "ops/mend/mend.h"

namespace trivet {
namespace {

using namespace trivet::test;

constexpr double kClose = 1e-5;  // some clearances

TEST(SettleScene, ASunkBoxRisesAndAFloatingOneSinks) {
  Boxes s;
  s.add("table", {0.5, 0.5, 0.2}, {0, 0, 0.2}, true);
  const ObjectId sunk = s.add("sunk", {0.05, 0.05, 0.05}, {0, 0, 0.447});
  const ObjectId floats = s.add("floats", {0.05, 0.05, 0.05}, {0.3, 0, 0.46});
  const SettledScene out = settle_scene(s.scene, {});
  EXPECT_TRUE(out.unable.empty());
  ASSERT_EQ(out.moved.size(), 2u);
  EXPECT_NEAR(s.at(sunk).z(), 0.45, kClose);
  EXPECT_NEAR(s.at(floats).z(), 0.45, kClose);
  EXPECT_NEAR(out.moved[0].moved, 0.003, kClose);
  EXPECT_TRUE(is_true(s.scene));
}

TEST(SettleScene, WhatRestsOnASinkingBoxComesAlong) {
  Boxes s;
  const ObjectId lower = s.add("lower", {0.1, 0.1, 0.05}, {0, 0, 0.06});
  const ObjectId upper = s.add("upper", {0.05, 0.05, 0.05}, {0, 0, 0.160001});
  settle_scene(s.scene, {});
  EXPECT_NEAR(s.at(lower).z(), 0.05, kClose);
  EXPECT_NEAR(s.at(upper).z(), 0.15, kClose);
  EXPECT_TRUE(is_true(s.scene));
}

TEST(SettleScene, ATrueSceneStaysToTheBit) {
  Boxes s;
  s.add("a", {0.05, 0.05, 0.05}, {0, 0, 0.05});
  s.add("b", {0.05, 0.05, 0.05}, {0.01, 0, 0.16});
  ASSERT_EQ(settle_scene(s.scene, {}).moved.size(), 1u);
  const Scene before = s.scene;
  EXPECT_TRUE(settle_scene(s.scene, {}).moved.empty());
  EXPECT_TRUE(same_bits(before, s.scene));
  EXPECT_TRUE(mend_scene(s.scene, {}).moved.empty());
  EXPECT_TRUE(same_bits(before, s.scene));
}

TEST(SettleScene, OnlyThoseNamedMove) {
  Boxes s;
  const ObjectId a = s.add("a", {0.05, 0.05, 0.05}, {0, 0, 0.06});
  const ObjectId b = s.add("b", {0.05, 0.05, 0.05}, {1, 0, 0.06});
  SettleSceneOptions options;
  options.only = {"b"};
  settle_scene(s.scene, options);
  EXPECT_EQ(s.at(a).z(), 0.06);
  EXPECT_NEAR(s.at(b).z(), 0.05, kClose);
}

TEST(SettleScene, WithoutAPlaceItStaysAndIsNamed) {
  Boxes s;
  s.add("table", {0.5, 0.5, 0.5}, {0, 0, 0.5}, true);
  const ObjectId deep = s.add("deep", {0.05, 0.05, 0.05}, {0, 0, 0.5});
  const SettledScene out = settle_scene(s.scene, {});
  ASSERT_EQ(out.unable.size(), 1u);
  EXPECT_TRUE(out.moved.empty());
  EXPECT_EQ(s.at(deep), Vec3(0, 0, 0.5));
}

TEST(Intent, KnowsWhatLiesOnWhat) {
  Boxes s;
  const ObjectId table = s.add("table", {0.5, 0.5, 0.2}, {0, 0, 0.2}, true);
  const ObjectId plate = s.add("plate", {0.1, 0.1, 0.01}, {0, 0, 0.405});
  const ObjectId cup = s.add("cup", {0.03, 0.03, 0.05}, {0.01, 0, 0.475});
  const Intent intent = infer_intent(s.scene);
  ASSERT_EQ(intent.objects.size(), 2u);
  EXPECT_EQ(intent.objects[0].id, plate);
  ASSERT_EQ(intent.objects[0].on.size(), 1u);
  EXPECT_EQ(intent.objects[0].on[0].on, Support(table));
  ASSERT_EQ(intent.find(cup)->on.size(), 1u);
  EXPECT_EQ(intent.find(cup)->on[0].on, Support(plate));
  EXPECT_NEAR(intent.find(plate)->gap, -0.005, 1e-3);
}

TEST(Mend, TwoThatOverlapSidewaysPart) {
  Boxes s;
  const ObjectId a = s.add("a", {0.05, 0.05, 0.05}, {0, 0, 0.05});
  const ObjectId b = s.add("b", {0.05, 0.05, 0.05}, {0.096, 0, 0.05});
  const MendedScene out = mend_scene(s.scene, {});
  EXPECT_TRUE(out.unable.empty());
  EXPECT_TRUE(is_true(s.scene));
  EXPECT_NEAR(s.at(b).x() - s.at(a).x(), 0.1, 5e-4);
  EXPECT_NEAR(s.at(b).z(), 0.05, kClose);
  EXPECT_EQ(out.num_kept, out.num_meant);
}

TEST(Mend, ATiltedBoxOnATableIsLevelled) {
  Boxes s;
  s.add("table", {0.5, 0.5, 0.2}, {0, 0, 0.2}, true);
  const Rotation tilt = Rotation::about_axis(Vec3::UnitX(), 0.01);
  const ObjectId box = s.add("box", {0.05, 0.05, 0.05}, {0, 0, 0.452}, false, tilt);
  const MendedScene out = mend_scene(s.scene, {});
  EXPECT_TRUE(is_true(s.scene));
  EXPECT_NEAR(s.at(box).z(), 0.45, 1e-4);
  EXPECT_NEAR(s.at(box).head<2>().norm(), 0, 1e-3);
  EXPECT_EQ(out.num_kept, 1u);
}

TEST(Mend, AStackThatSankRisesWithoutASidewaysMove) {
  Boxes s;
  const ObjectId a = s.add("a", {0.1, 0.1, 0.05}, {0, 0, 0.03});
  const ObjectId b = s.add("b", {0.05, 0.05, 0.05}, {0.01, 0.02, 0.13});
  const MendedScene out = mend_scene(s.scene, {});
  EXPECT_TRUE(is_true(s.scene));
  EXPECT_NEAR(s.at(a).z(), 0.05, kClose);
  EXPECT_NEAR(s.at(b).z(), 0.15, kClose);
  EXPECT_NEAR((s.at(b) - Vec3(0.01, 0.02, 0.15)).norm(), 0, 1e-3);
  EXPECT_TRUE(out.relations.empty());
}

// 12 books of 30 mm, each 0.5 mm in the next: 5.5 mm are missing, shared by both sides.
TEST(Mend, ARowSpreadsAboutItsMiddle) {
  Boxes s;
  s.add("shelf", {0.5, 0.2, 0.2}, {0, 0, 0.2}, true);
  std::vector<ObjectId> books;
  for (int i = 0; i < 12; ++i)
    books.push_back(
        s.add("book " + std::to_string(i), {0.015, 0.08, 0.1}, {0.0295 * (i - 5.5), 0, 0.5}));
  const Scene before = s.scene;
  const MendedScene out = mend_scene(s.scene, {});
  EXPECT_TRUE(out.unable.empty());
  EXPECT_TRUE(is_true(s.scene));
  EXPECT_EQ(out.num_kept, 12u);
  for (int i = 0; i < 12; ++i) {
    EXPECT_LT((s.at(books[i]) - before.at(books[i]).pose.translation).norm(), 0.0035) << i;
    EXPECT_NEAR(s.at(books[i]).z(), 0.5, kClose);
    if (i > 0) {
      EXPECT_GT(s.at(books[i]).x() - s.at(books[i - 1]).x(), 0.03);
    }
  }
}

TEST(Mend, ARowAtAWallGivesWayToTheOtherSide) {
  Boxes s;
  s.add("shelf", {0.5, 0.2, 0.2}, {0, 0, 0.2}, true);
  s.add("wall", {0.01, 0.2, 0.2}, {0.2, 0, 0.6}, true);  // to 0.19
  std::vector<ObjectId> books;
  for (int i = 0; i < 3; ++i)
    books.push_back(s.add("book " + std::to_string(i), {0.015, 0.08, 0.1},
                          {0.176 - 0.029 * (2 - i), 0, 0.5}));  // 1 mm in the wall and each other
  const MendedScene out = mend_scene(s.scene, {});
  EXPECT_TRUE(out.unable.empty());
  EXPECT_TRUE(is_true(s.scene));
  EXPECT_NEAR(s.at(books[2]).x(), 0.175, 5e-4);
  EXPECT_NEAR(s.at(books[1]).x(), 0.145, 5e-4);
  EXPECT_NEAR(s.at(books[0]).x(), 0.115, 5e-4);
}

TEST(Mend, MendedAgainNothingMoves) {
  Boxes s;
  s.add("a", {0.05, 0.05, 0.05}, {0, 0, 0.04});
  s.add("b", {0.05, 0.05, 0.05}, {0.09, 0.01, 0.06});
  s.add("c", {0.04, 0.04, 0.04}, {0.04, 0.01, 0.14});
  mend_scene(s.scene, {});
  ASSERT_TRUE(is_true(s.scene));
  const Scene before = s.scene;
  EXPECT_TRUE(mend_scene(s.scene, {}).moved.empty());
  EXPECT_TRUE(same_bits(before, s.scene));
}

}  // namespace
}  // namespace trivet
