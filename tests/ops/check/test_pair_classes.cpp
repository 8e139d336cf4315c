// Pairs in three classes: known distances.
#include <gtest/gtest.h>

#include "ops/check/pair_classes.h"
#include "ops/mend/boxes.h"

namespace trivet::test {
namespace {

const Vec3 kHalf(0.05, 0.05, 0.05);

PairClasses classes_of(Scene scene) {
  update_contacts(scene);
  return pair_classes(scene, check_scene(scene));
}

TEST(PairClasses, EveryPairIsInOneOfThem) {
  Boxes s;
  s.add("sunk", kHalf, {0, 0, 0.047});     // through the floor
  s.add("on it", kHalf, {0, 0, 0.1475});   // 0.5 mm above that one
  s.add("flush", kHalf, {1, 0, 0.05});     // on the floor, without a gap
  s.add("in it", kHalf, {1.06, 0, 0.05});  // on the floor, 4 cm into that one
  const PairClasses pairs = classes_of(s.scene);
  EXPECT_EQ(pairs.num_through, 2u);
  ASSERT_EQ(pairs.touching.size(), 2u);
  EXPECT_EQ(pairs.touching[0].a, "flush");
  EXPECT_EQ(pairs.touching[0].b, "floor");
  EXPECT_EQ(pairs.touching[0].gap, 0);
  EXPECT_EQ(pairs.touching[1].a, "in it");
  EXPECT_EQ(pairs.num_judged(), 4u * 3 / 2 + 4);
  EXPECT_EQ(pairs.num_apart, 6u);
}

TEST(PairClasses, RoundingIsNoInterpenetration) {
  Boxes s;
  s.add("by rounding", kHalf, {0, 0, 0.05 - 1e-9});
  const PairClasses pairs = classes_of(s.scene);
  EXPECT_EQ(pairs.num_through, 0u);
  ASSERT_EQ(pairs.touching.size(), 1u);
  EXPECT_NEAR(pairs.touching[0].gap, -1e-9, 1e-12);
}

TEST(PairClasses, AGapBelowTheClearanceIsTold) {
  Boxes s;
  s.add("a", kHalf, {0, 0, 0.05 + 5e-8});
  const PairClasses pairs = classes_of(s.scene);
  ASSERT_EQ(pairs.touching.size(), 1u);
  EXPECT_NEAR(pairs.touching[0].gap, 5e-8, 1e-12);
}

TEST(PairClasses, FixedPairsAndThoseThatMayPassAreInNone) {
  Boxes s;
  s.add("wall", kHalf, {0, 0, 0.04}, true);
  s.add("shelf", kHalf, {0.02, 0, 0.05}, true);
  const ObjectId ghost = s.add("ghost", kHalf, {0.01, 0, 0.05});
  auto rules = std::make_shared<PairRules>();
  PairRule rule;
  rule.may_pass = true;
  rules->set(0, 1, rule);
  edit_object(s.scene, ghost, [](Object& object) { object.pair_kind = 1; });
  s.scene.pair_rules = rules;
  EXPECT_EQ(classes_of(s.scene).num_judged(), 0u);
}

}  // namespace
}  // namespace trivet::test
