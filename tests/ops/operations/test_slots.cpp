// Moves of an object along opposing contacts on both sides.
#include "stage.h"

namespace trivet {
namespace {

using test::box_triangles;
using test::Stage;
using End = OperationResult::End;

constexpr double kThick = 0.03125, kDeep = 0.125, kHigh = 0.1875;  // half sizes of a book

/// A book on a board between two books, each `gap` away: in clearances, 1 as PUT leaves it.
struct BetweenBooks : Stage {
  explicit BetweenBooks(double gap) {
    fix("board", box_triangles(Vec3(1, 0.25, 0.03125)), {0, 0, 0.03125 + 1e-5});
    const double c = clearance(), z = 0.0625 + 1e-5 + kHigh + c;
    const double next = 2 * kThick + gap * c;
    const char* names[] = {"left", "book", "right"};
    for (int i = 0; i < 3; ++i) {
      const ObjectId id =
          scene.add(test::object_of(names[i], box_triangles(Vec3(kThick, kDeep, kHigh)), i != 1));
      const OperationResult result = stand(scene, id, {{}, Vec3((i - 1) * next, 0, z)});
      EXPECT_TRUE(result.ok()) << result.reason();
    }
    EXPECT_EQ(at("book").state, ObjectState::Stable);
    EXPECT_EQ(at("book").contacts.size(), 3u);
  }
};

TEST(Slot, TranslatesBookBetweenBooks) {
  for (const double gap : {1.0, 0.75, 0.5, 1.7}) {
    for (const Vec3& by : {Vec3(0, -0.4, 0), Vec3(0, 0, 0.4), Vec3(0, -0.3, 0.3)}) {
      BetweenBooks s(gap);
      const Vec3 before = s.position("book");
      const OperationResult result = s.run(TranslateOperation{{"book"}, by});
      ASSERT_TRUE(result.ok()) << result.reason();
      EXPECT_EQ(result.end, End::Reached) << result.blocked_by.name;
      EXPECT_NEAR((s.position("book") - before - by).norm(), 0, 2 * s.clearance());
    }
  }
}

TEST(Slot, PicksUpAndPullsOutBookBetweenBooks) {
  for (const double gap : {1.0, 0.6}) {
    BetweenBooks s(gap);
    const Vec3 before = s.position("book");
    OperationResult result = s.run(PickUpOperation{{"book"}, 0.5, {}});
    ASSERT_TRUE(result.ok()) << result.reason();
    EXPECT_EQ(result.end, End::Reached) << result.blocked_by.name;
    EXPECT_NEAR(s.position("book").z() - before.z(), 0.5, 2 * s.clearance());

    BetweenBooks t(gap);
    PushOperation pull;
    pull.object = "book", pull.direction = Vec2(0, -1), pull.distance = 0.1875;
    result = t.run(pull);
    ASSERT_TRUE(result.ok()) << result.reason();
    EXPECT_EQ(result.end, End::Reached) << result.blocked_by.name;
    EXPECT_NEAR(t.position("book").y(), -0.1875, 2 * t.clearance());
    EXPECT_EQ(t.at("book").state, ObjectState::Stable);
  }
}

// Against them it does not move.
TEST(Slot, DoesNotPushBookIntoBooks) {
  BetweenBooks s(1);
  for (const double x : {-0.1, 0.1}) {
    const OperationResult result = s.run(TranslateOperation{{"book"}, Vec3(x, 0, 0)});
    ASSERT_TRUE(result.ok()) << result.reason();
    EXPECT_EQ(result.end, End::Blocked);
    EXPECT_LE(result.moved, 2 * s.clearance());
  }
}

// A card lowered into a slot, and taken out again.
TEST(Slot, LowersAndRaisesCard) {
  Stage s;
  s.fix("front", box_triangles(Vec3(0.25, 0.0625, 0.0625)), {0, -0.0625, 0.0625 + 1e-5});
  const double c = s.clearance(), thick = 0.00048828125;  // half
  s.fix("back", box_triangles(Vec3(0.25, 0.0625, 0.0625)),
        {0, 0.0625 + 2 * thick + 2.2 * c, 0.0625 + 1e-5});
  const ObjectId card =
      s.scene.add(test::object_of("card", box_triangles(Vec3(0.0625, thick, 0.0625))));
  ASSERT_TRUE(stand(s.scene, card, {{}, Vec3(0, thick + 1.1 * c, 0.0625 + c)}).ok());
  for (int i = 0; i < 3; ++i) {
    OperationResult result = s.run(TranslateOperation{{"card"}, Vec3(0.05, 0, 0.1)});
    ASSERT_TRUE(result.ok()) << result.reason();
    EXPECT_EQ(result.end, End::Reached) << result.blocked_by.name;
    result = s.run(TranslateOperation{{"card"}, Vec3(-0.05, 0, -0.099)});
    ASSERT_TRUE(result.ok()) << result.reason();
    EXPECT_EQ(result.end, End::Reached) << result.blocked_by.name;
  }
  const OperationResult result = s.run(TranslateOperation{{"card"}, Vec3(0, 0, 0.2)});
  EXPECT_EQ(result.end, End::Reached) << result.blocked_by.name;
}

}  // namespace
}  // namespace trivet
