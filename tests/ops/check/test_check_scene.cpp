// Scenes that are not true are found to be so.
#include <gtest/gtest.h>

#include "core/scene/transaction.h"
#include "ops/check/check.h"
#include "ops/operations/arrangements.h"
#include "ops/operations/perform.h"

namespace trivet {
namespace {

using test::heap, test::Room;

TEST(CheckScene, FindsViolations) {
  Room room;
  EXPECT_TRUE(check_scene(room.scene).ok());
  ASSERT_TRUE(put(room.scene, room.object, {{}, Vec3(0, 0, 3)}).ok());
  EXPECT_TRUE(check_scene(room.scene).ok());
  const Vec3 good = room.scene.at(room.object).pose.translation;
  const auto move_to = [&](const Vec3& at) {
    edit_object(room.scene, room.object, [&](Object& o) { o.pose.translation = at; });
  };
  move_to(good + Vec3(0, 0, 0.5));  // hovers
  EXPECT_EQ(check_scene(room.scene).not_at_rest, std::vector<std::string>{"object"});
  move_to(room.scene.at(room.box).pose.translation);
  ASSERT_EQ(check_scene(room.scene).contained.size(), 1u);
  EXPECT_EQ(check_scene(room.scene).contained[0].a, "object");
  EXPECT_EQ(check_scene(room.scene).contained[0].b, "box");
  move_to(Vec3(5, 0, 0.1));  // in the floor
  ASSERT_EQ(check_scene(room.scene).crossings.size(), 1u);
  EXPECT_EQ(check_scene(room.scene).crossings[0].b, "floor");
  EXPECT_EQ(check_scene(room.scene).crossings[0].count, 4);
  move_to(good - Vec3(0, 0, 3e-3));
  EXPECT_GT(check_scene(room.scene).interpenetrating_pairs(), 0);
  EXPECT_FALSE(check_scene(room.scene).ok());
}

TEST(CheckScene, IsTheSameWithAnyNumberOfThreads) {
  Scene scene = heap(16, false);
  const auto lift = [&](size_t i, double by) {
    edit_object(scene, scene.ids()[i], [&](Object& o) { o.pose.translation.z() += by; });
  };
  lift(3, 0.02);  // into something, perhaps
  lift(9, -0.02);
  const SceneCheck one = check_scene(scene, 1, 0, test::perfect_friction());
  EXPECT_FALSE(one.ok());
  for (const int threads : {0, 2, 8}) {
    const SceneCheck many = check_scene(scene, threads, 0, test::perfect_friction());
    EXPECT_EQ(many.not_at_rest, one.not_at_rest);
    EXPECT_EQ(many.smallest_gap, one.smallest_gap);
    ASSERT_EQ(many.crossings.size(), one.crossings.size());
    for (size_t i = 0; i < one.crossings.size(); ++i) {
      EXPECT_EQ(many.crossings[i].a, one.crossings[i].a);
      EXPECT_EQ(many.crossings[i].b, one.crossings[i].b);
      EXPECT_EQ(many.crossings[i].count, one.crossings[i].count);
    }
  }
}

TEST(CheckScene, NamesWhatItDidNotJudgeInTime) {
  const Scene scene = heap(16, false);
  const SceneCheck whole = check_scene(scene, 1, 0, test::perfect_friction());
  EXPECT_TRUE(whole.whole());
  const SceneCheck none = check_scene(scene, 1, 0, test::perfect_friction(), [] { return true; });
  EXPECT_EQ(none.not_judged.size(), scene.ids().size());
  EXPECT_GT(none.num_pairs_not_judged, 0u);
  EXPECT_FALSE(none.ok());
  // All pairs, and then some objects.
  const auto after = static_cast<int>(none.num_pairs_not_judged) + 3;
  int asked = 0;
  const SceneCheck part =
      check_scene(scene, 1, 0, test::perfect_friction(), [&] { return ++asked > after; });
  EXPECT_EQ(part.num_pairs_not_judged, 0u);
  EXPECT_EQ(part.not_judged.size(), scene.ids().size() - 3);
  EXPECT_FALSE(part.ok());
}

TEST(CheckScene, AnotherClearanceIsAskedOfThoseThatDoNotRest) {
  Room room;
  ASSERT_TRUE(put(room.scene, room.object, {{}, Vec3(0, 0, 3)}).ok());
  EXPECT_TRUE(may_rest_by(room.scene, check_scene(room.scene, 0, 1e-6), 1e-5));
  // Across a gap of more than the narrow clearance, and less than the wide one.
  edit_object(room.scene, room.object, [](Object& o) { o.pose.translation.z() += 2e-5; });
  const SceneCheck narrow = check_scene(room.scene, 0, 1e-6);
  ASSERT_FALSE(narrow.not_at_rest.empty());
  for (const double clearance : {2e-6, 2e-5})
    EXPECT_EQ(may_rest_by(room.scene, narrow, clearance),
              check_scene(room.scene, 0, clearance).not_at_rest.empty())
        << clearance;
  EXPECT_FALSE(may_rest_by(room.scene, narrow, 2e-6));
}

TEST(CheckScene, UpdateContactsAgreesWithPut) {
  Scene scene = heap(8, false);
  const Scene before = scene;
  update_contacts(scene, 0, test::perfect_friction());
  for (const ObjectId id : scene.ids()) {
    EXPECT_EQ(scene.at(id).state, before.at(id).state);
    EXPECT_EQ(scene.at(id).contacts.size(), before.at(id).contacts.size());
  }
}

}  // namespace
}  // namespace trivet
