// Loads of an object move with it; objects left without support are named. The paper's Fig. 6: see
// figures/.
#include <algorithm>

#include "pile.h"

namespace trivet {
namespace {

using test::box_triangles;
using test::Pile;
using test::Stage;
using End = OperationResult::End;

// The table moves, and everything on it keeps its place relative to it.
TEST(Group, MovesWithLoads) {
  Pile s;
  const Scene before = s.scene;
  const OperationResult result = s.run(TranslateOperation{{"table"}, Vec3(-1.0 / 3, 0.1, 0.7)});
  ASSERT_TRUE(result.ok()) << result.reason();
  EXPECT_EQ(result.carried, (std::vector<std::string>{"a", "b", "c"}));
  const Vec3 by = s.position("table") - before.at(*before.find("table")).pose.translation;
  for (const char* name : {"a", "b", "c"}) {
    const Vec3 shift = s.position(name) - before.at(*before.find(name)).pose.translation - by;
    EXPECT_LE(shift.cwiseAbs().maxCoeff(), 3e-16) << name;
    EXPECT_EQ(s.at(name).state, ObjectState::Stable) << name;
  }
  EXPECT_EQ(s.at("table").state, ObjectState::Held);
  EXPECT_EQ(s.position("beside"), before.at(*before.find("beside")).pose.translation);
}

TEST(Group, TurnsWithLoads) {
  Pile s;
  TurnOperation o;
  o.object = "table", o.angle_deg = 90;
  const OperationResult result = s.run(o);
  ASSERT_TRUE(result.ok()) << result.reason();
  EXPECT_NEAR((s.position("b").head<2>() - Vec2(0, 0.2)).norm(), 0, s.clearance());
  EXPECT_NEAR((s.position("c").head<2>() - Vec2(-0.05, 0.2)).norm(), 0, s.clearance());
  EXPECT_EQ(s.at("c").state, ObjectState::Stable);
}

// A protruding load collides first.
TEST(Group, CollidesAsWhole) {
  Pile s;
  s.fix("lamp", box_triangles(Vec3(0.01, 0.01, 0.5)), {0.2, 2, 0.5 + 0.6});
  s.scene.remove(*s.scene.find("beside"));
  // The table passes below the lamp; b (top at 0.7) does not.
  PushOperation o;
  o.object = "table", o.direction = Vec2(0, 1), o.distance = 3, o.slide = false;
  const OperationResult result = s.run(o);
  ASSERT_TRUE(result.ok()) << result.reason();
  EXPECT_EQ(result.blocked_by.name, "lamp");
  EXPECT_NEAR(s.position("b").y(), 2 - 0.01 - 0.1, 1e-5);
  EXPECT_NEAR(s.position("table").y(), 2 - 0.01 - 0.1, 1e-5);
}

TEST(Group, PutCarriesLoads) {
  Pile s;
  const Vec3 a = s.position("a") - s.position("table");
  const OperationResult result = s.run(PutOperation{{"table"}, Pose{{}, Vec3(5, 5, 2)}});
  ASSERT_TRUE(result.ok()) << result.reason();
  EXPECT_NEAR((s.position("a") - s.position("table") - a).norm(), 0, 1e-13);
  EXPECT_EQ(s.at("a").state, ObjectState::Stable);
  EXPECT_NEAR(s.position("table").z(), 0.25, 1e-5);
}

TEST(Group, DoesNotMoveFixedOrLocked) {
  Pile s;
  s.edit("c", [](Object& o) { o.locked = true; });
  s.refused(TranslateOperation{{"table"}, Vec3(0, 0, 1)}, "\"c\" is locked");
  s.refused(PickUpOperation{{"c"}, 1, {}}, "\"c\" is locked");
  EXPECT_TRUE(s.run(PickUpOperation{{"a"}, 0.1, {}}).ok());
}

// Objects of one group move as one, even without contact.
TEST(Group, MovesMembersAlong) {
  Pile s;
  s.edit("a", [](Object& o) { o.group = "g"; });
  s.edit("beside", [](Object& o) { o.group = "g"; });
  const OperationResult result = s.run(TranslateOperation{{"a"}, Vec3(0, 1, 0.2)});
  EXPECT_EQ(result.carried, std::vector<std::string>{"beside"});
  EXPECT_NEAR(s.position("beside").y(), 1, 1e-12);
}

/// Same result as with a group of the two, bit for bit.
template <class Move>
void expect_as_grouped(Move move) {
  SCOPED_TRACE(op_name(move));
  Pile grouped, together;
  for (const char* name : {"table", "beside"}) grouped.edit(name, [](Object& o) { o.group = "g"; });
  move.object = "table";
  ASSERT_TRUE(grouped.run(move).ok());
  move.together = {"beside", "table", "beside"};
  const OperationResult result = together.run(move);
  ASSERT_TRUE(result.ok()) << result.reason();
  EXPECT_EQ(result.carried, (std::vector<std::string>{"a", "b", "c", "beside"}));
  EXPECT_EQ(test::snapshot(together.scene), test::snapshot(grouped.scene));
  EXPECT_GT((together.position("beside") - Pile().position("beside")).norm(), 0.05);
}

TEST(Together, MovesLikeGroup) {
  PushOperation push;
  push.direction = Vec2(1, 0.5), push.distance = 0.3;
  expect_as_grouped(push);
  TurnOperation turn;
  turn.angle_deg = 30;
  expect_as_grouped(turn);
  PickUpOperation pick_up;
  pick_up.distance = 0.2;
  expect_as_grouped(pick_up);
  expect_as_grouped(TranslateOperation{{}, Vec3(-1.0 / 3, 0.1, 0.7)});
  expect_as_grouped(RotateOperation{{}, Vec3::UnitZ(), 20});
}

TEST(Together, HoldsAllObjects) {
  Pile s;
  TranslateOperation move{{"table"}, Vec3(0, 0, 0.7)};
  move.together = {"beside"};
  EXPECT_TRUE(s.run(move).unsupported.empty());
  EXPECT_EQ(s.at("table").state, ObjectState::Held);
  EXPECT_EQ(s.at("beside").state, ObjectState::Held);
  EXPECT_EQ(s.at("b").state, ObjectState::Stable);
}

// Each settles individually, not as one body: b, which lies on the table, is carried over its edge.
TEST(Together, SettlesObjectsOneByOne) {
  Pile s;
  TranslateOperation move{{"b"}, Vec3(0, 0.6, 0.1)};
  move.together = {"beside"};
  move.settle = true;
  const OperationResult result = s.run(move);
  ASSERT_TRUE(result.ok()) << result.reason();
  EXPECT_TRUE(result.unsupported.empty());
  EXPECT_EQ(result.settled, (std::vector<std::string>{"beside", "b"}));
  for (const char* name : {"b", "c", "beside"}) EXPECT_EQ(s.at(name).state, ObjectState::Stable);
  EXPECT_NEAR(s.position("b").z(), 0.1, 2 * s.clearance());
  EXPECT_NEAR(s.position("beside").z(), 0.1, 2 * s.clearance());
  EXPECT_NEAR((s.position("beside") - s.position("b")).x(), 0.8, 2 * s.clearance());
}

TEST(Together, SettlesObjectsHeldBefore) {
  for (const bool grouped : {false, true}) {
    Pile s;
    TranslateOperation move{{"a"}, Vec3(0, 0, 0.1)};
    if (grouped)
      for (const char* name : {"a", "beside"}) s.edit(name, [](Object& o) { o.group = "g"; });
    else
      move.together = {"beside"};
    ASSERT_TRUE(s.run(move).ok());
    EXPECT_EQ(s.at("beside").state, ObjectState::Held);
    move.by.setZero();
    move.settle = true;
    ASSERT_TRUE(s.run(move).ok());
    EXPECT_NE(s.at("a").state, ObjectState::Held);
    EXPECT_NE(s.at("beside").state, ObjectState::Held);
    EXPECT_NEAR(s.position("beside").z(), 0.1, 3 * s.clearance());
  }
}

TEST(Together, NamesUnknownFixedLockedAndUnplaced) {
  Pile s;
  s.fix("lamp", box_triangles(Vec3(0.01, 0.01, 0.5)), {3, 2, 1});
  s.edit("b", [](Object& o) { o.locked = true; });
  s.scene.add(test::object_of("away", box_triangles(Vec3(0.1, 0.1, 0.1))));
  const auto reason = [&](const std::string& name) {
    TranslateOperation move{{"beside"}, Vec3(0, 0, 0.1)};
    move.together = {"a", name};
    return s.run(move).reason();
  };
  const std::string along = " and would have to move along: ";
  EXPECT_EQ(reason("nobody"), "there is no object \"nobody\"");
  EXPECT_EQ(reason("lamp"), "\"lamp\" is fixed" + along + "unfix it first");
  EXPECT_EQ(reason("b"), "\"b\" is locked" + along + "unlock it first");
  EXPECT_EQ(reason("away"), "\"away\" is not in the scene: put it there first");
  EXPECT_EQ(reason("a"), "");
}

/// A plank on two posts, with a box on its middle.
struct Bridge : Stage {
  Bridge() {
    put("left", box_triangles(Vec3(0.1, 0.1, 0.25)), {-0.4, 0, 1});
    put("right", box_triangles(Vec3(0.1, 0.1, 0.25)), {0.4, 0, 1});
    put("plank", box_triangles(Vec3(0.6, 0.1, 0.02)), {0, 0, 1});
    put("box", box_triangles(Vec3(0.05, 0.05, 0.05)), {0, 0, 1});
  }
};

// Removal of a support: the plank goes with the post that moves, off the other one.
TEST(Group, NamesObjectsLeftUnsupported) {
  for (const bool settle_left : {false, true}) {
    Bridge s;
    s.options = test::objects_alone();
    const OperationResult result = s.run(TranslateOperation{{"left", settle_left}, Vec3(-1, 0, 0)});
    ASSERT_TRUE(result.ok()) << result.reason();
    EXPECT_EQ(result.end, End::Reached);
    EXPECT_EQ(result.carried, (std::vector<std::string>{"plank", "box"}));
    if (!settle_left) {
      EXPECT_EQ(result.unsupported, std::vector<std::string>{"plank"});
      EXPECT_EQ(s.at("plank").state, ObjectState::Unsupported);
      EXPECT_EQ(s.at("box").state, ObjectState::Stable);
      continue;
    }
    EXPECT_TRUE(result.unsupported.empty());
    ASSERT_FALSE(result.settled.empty());
    EXPECT_EQ(result.settled[0], "plank");
    for (const char* name : {"left", "right", "plank", "box"})
      EXPECT_EQ(s.at(name).state, ObjectState::Stable) << name;
  }
}

// By default what is left without support falls.
TEST(Group, LetsObjectsLeftUnsupportedGiveWay) {
  Bridge s;
  const double before = s.position("plank").z();
  const OperationResult result = s.run(TranslateOperation{{"left"}, Vec3(-1, 0, 0)});
  ASSERT_TRUE(result.ok()) << result.reason();
  EXPECT_TRUE(result.unsupported.empty());
  ASSERT_FALSE(result.gave_way.empty());
  EXPECT_EQ(result.gave_way[0].name, "plank");
  EXPECT_GT(result.gave_way[0].moved, 0.1);
  EXPECT_LT(s.position("plank").z(), before - 0.1);
  for (const char* name : {"left", "right", "plank", "box"})
    EXPECT_EQ(s.at(name).state, ObjectState::Stable) << name;
}

// A tilted table drops its load: named, or settled on request.
TEST(Group, NamesOrSettlesLoadsOfTiltedSupport) {
  for (const bool settle_left : {false, true}) {
    Stage s;
    s.options = test::objects_alone();
    s.put("tray", box_triangles(Vec3(0.5, 0.3, 0.02)), {0, 0, 1});
    s.put("ball", box_triangles(Vec3(0.02, 0.02, 0.2)), {0.3, 0, 1});
    TurnOperation o;
    o.object = "tray", o.about = TurnOperation::About::Line, o.angle_deg = 40;
    o.point = Vec3(-0.5, 0, 0);
    o.settle_left = settle_left;
    const OperationResult result = s.run(o);
    ASSERT_TRUE(result.ok()) << result.reason();
    EXPECT_EQ(result.carried, std::vector<std::string>{"ball"});
    if (settle_left) {
      EXPECT_TRUE(result.unsupported.empty());
      EXPECT_EQ(result.settled, std::vector<std::string>{"ball"});
      EXPECT_EQ(s.at("ball").state, ObjectState::Stable);
    } else {
      EXPECT_EQ(result.unsupported, std::vector<std::string>{"ball"});
      EXPECT_EQ(s.at("ball").state, ObjectState::Unsupported);
    }
  }
}

/// A plank that overhangs the end of a table, above a post without contact: the post is nearer than
/// kCarryingTolerance clearances, and the plank would hardly sink.
struct Propped : Stage {
  Propped() {
    put("table", box_triangles(Vec3(0.25, 0.25, 0.125)), {0, 0, 0.5});
    put("post", box_triangles(Vec3(0.0625, 0.0625, 0.125)), {0.5, 0, 0.5});
    const double e = clearance();
    Transaction transaction(scene);
    transaction.clear_contacts(*scene.find("table"));
    transaction.commit();
    edit("table", [&](Object& table) {
      table.pose.translation.z() += 4 * e;
      table.fixed = true, table.state = ObjectState::Fixed;
    });
    const ObjectId plank =
        scene.add(test::object_of("plank", box_triangles(Vec3(0.375, 0.0625, 0.03125))));
    const OperationResult result = stand(scene, plank, {{}, Vec3(0.3125, 0, 0.28125 + 6 * e)});
    EXPECT_TRUE(result.ok()) << result.reason();
    EXPECT_EQ(at("plank").state, ObjectState::Stable);
    EXPECT_EQ(at("plank").contacts.size(), 2u);
    EXPECT_TRUE(at("post").contacts.back().across_gap && at("post").contacts.back().is_carried);
    EXPECT_LT(at("plank").stability_margin, 0);
  }
};

// Sequence 76: an object that supports without contact goes away.
TEST(Group, NamesObjectThatLeanedOnNearbyOne) {
  for (const bool settle_left : {false, true}) {
    for (const Operation& operation :
         {Operation{TranslateOperation{{"post", settle_left}, Vec3(0, 0.5, 0)}},
          Operation{DeleteOperation{{"post", settle_left}}},
          Operation{TranslateOperation{{"plank", settle_left}, Vec3(0, 0.1875, 0)}}}) {
      Propped s;
      s.options = test::objects_alone();
      const OperationResult result = s.run(operation);
      ASSERT_TRUE(result.ok()) << result.reason();
      if (object_name(operation) == "plank") {
        EXPECT_EQ(s.at("plank").state, ObjectState::Held);
      } else if (settle_left) {
        EXPECT_EQ(result.settled, std::vector<std::string>{"plank"});
        EXPECT_EQ(s.at("plank").state, ObjectState::Stable);
        EXPECT_LT(s.position("plank").z(), 0.28);
      } else {
        EXPECT_EQ(result.unsupported, std::vector<std::string>{"plank"});
        EXPECT_EQ(s.at("plank").state, ObjectState::Unsupported);
      }
    }
  }
}

// The same when the plank moves along with the table, and the post stays.
TEST(Group, NamesCarriedObjectThatLeanedOnNearbyOne) {
  Propped s;
  s.options = test::objects_alone();
  s.edit("table", [](Object& table) { table.fixed = false, table.state = ObjectState::Held; });
  const OperationResult result = s.run(TranslateOperation{{"table"}, Vec3(-0.5, 0, 0)});
  ASSERT_TRUE(result.ok()) << result.reason();
  EXPECT_EQ(result.carried, std::vector<std::string>{"plank"});
  EXPECT_EQ(result.unsupported, std::vector<std::string>{"plank"});
}

}  // namespace
}  // namespace trivet
