// Links that follow a hand: the same bits as by MOVE_JOINT, one step, and what stops them.
#include "core/scene/fingerprint.h"
#include "ops/operations/live_move.h"
#include "ops/session/kitchen.h"

namespace trivet {
namespace {

using namespace test;

MoveJointOperation move_of(const std::string& link) {
  MoveJointOperation out;
  out.object = link;
  out.to = 0;
  return out;
}

/// A link dragged by a hand, and by MOVE_JOINT to the last goal.
struct Dragged {
  OperationResult result, at_once;
  std::uint64_t by_hand = 0, by_operation = 0;
};

Dragged drag(const std::string& text, const std::string& link, const std::vector<double>& goals) {
  Dragged out;
  Furnished kitchen(text), other(text);
  const std::uint64_t before = fingerprint(kitchen.scene());
  LiveMove live = kitchen.session().begin_live(move_of(link), options_of_test().settle);
  for (const double goal : goals) live.follow(goal);
  EXPECT_EQ(fingerprint(kitchen.scene()), before) << "no commit before the end";
  out.result = kitchen.session().finish(live);
  EXPECT_TRUE(check_scene(kitchen.scene(), 1, kClearance).ok());
  out.by_hand = fingerprint(kitchen.scene());
  out.at_once = other.move(link, goals.back());
  out.by_operation = fingerprint(other.scene());
  EXPECT_TRUE(kitchen.session().undo());
  EXPECT_EQ(fingerprint(kitchen.scene()), before) << "a drag is one step";
  EXPECT_TRUE(kitchen.session().redo());
  EXPECT_EQ(fingerprint(kitchen.scene()), out.by_hand);
  return out;
}

TEST(JointsInTheHand, ADrawerEndsWhereItsOperationDoes) {
  for (const std::vector<double>& goals :
       {std::vector{0.3, 0.25, 0.1}, std::vector{0.05, 0.2, 0.123}, std::vector{0.0}}) {
    const Dragged dragged = drag(fixed_kitchen(), "drawer", goals);
    ASSERT_TRUE(dragged.result.ok()) << dragged.result.reason();
    EXPECT_EQ(dragged.result.joint_value, goals.back());
    EXPECT_EQ(dragged.result.carried, std::vector<std::string>{"cube"});
    EXPECT_EQ(dragged.by_hand, dragged.by_operation);
  }
}

TEST(JointsInTheHand, ADrawerShowsWhereItIsWithWhatLiesInIt) {
  Furnished kitchen(fixed_kitchen());
  const Vec3 cube = kitchen.at("cube").pose.translation;
  LiveMove live = kitchen.session().begin_live(move_of("drawer"), options_of_test().settle);
  ASSERT_FALSE(live.refused());
  EXPECT_FALSE(live.has_moved());
  live.follow(0.1);
  EXPECT_EQ(live.result().joint_value, 0.1);
  ASSERT_EQ(live.placements().size(), 2u);
  EXPECT_EQ(live.placements()[0].pose.translation, Vec3(0, -0.1, 3e-6));
  EXPECT_NEAR((live.placements()[1].pose.translation - cube - Vec3(0, 0.2, 0)).norm(), 0, 1e-12);
  EXPECT_EQ(live.result().end, OperationResult::End::Reached);
  // Back where it was: nothing moves, and nothing becomes a step.
  live.follow(0.3);
  EXPECT_FALSE(live.has_moved());
  live.follow(7);
  EXPECT_EQ(live.result().end, OperationResult::End::Limit);
}

// As in JointsOfLayouts: the box that sticks out meets the cabinet.
TEST(JointsInTheHand, ADrawerSaysWhatStopsIt) {
  const Dragged dragged = drag(
      fixed_kitchen(kOpen + R"(, {"op": "put", "object": "tall", "position": [0, -0.3, 0.5]})"),
      "drawer", {0.25, 0.0, 0.02});
  ASSERT_TRUE(dragged.result.ok()) << dragged.result.reason();
  EXPECT_EQ(dragged.result.end, OperationResult::End::Blocked);
  EXPECT_EQ(dragged.result.blocked_by.name, "cabinet");
  EXPECT_EQ(dragged.result.joint_value, dragged.at_once.joint_value);
  EXPECT_EQ(dragged.by_hand, dragged.by_operation);
}

TEST(JointsInTheHand, ALidTurnsByDegrees) {
  const std::string text =
      text_of(R"(, "fixed": true)", "",
              R"(, {"name": "lid", "model": "lid.obj", "position": [0, 0.15, 0.4001],
   "joint": {"in": "cabinet", "hinge": [-1, 0, 0], "at": [0, 0, 0], "lower": 0, "upper": 90}})",
              "");
  const Dragged dragged = drag(text, "lid", {20, 80, 45.5});
  ASSERT_TRUE(dragged.result.ok()) << dragged.result.reason();
  EXPECT_EQ(dragged.result.joint_value, 45.5);
  EXPECT_EQ(dragged.result.turned_deg, 45.5);
  EXPECT_EQ(dragged.by_hand, dragged.by_operation);
}

TEST(JointsInTheHand, AnObjectWithoutAJointIsRefused) {
  Furnished kitchen(fixed_kitchen());
  LiveMove live = kitchen.session().begin_live(move_of("cube"), options_of_test().settle);
  ASSERT_TRUE(live.refused());
  EXPECT_NE(live.result().reason().find("an object that hangs in a joint: \"drawer\""),
            std::string::npos)
      << live.result().reason();
  live.follow(0.2);
  EXPECT_TRUE(live.placements().empty());
  EXPECT_FALSE(kitchen.session().finish(live).ok());
}

// The cube that is pushed onto a trapdoor opens it, for a hand as for an operation.
TEST(JointsInTheHand, APushOntoATrapdoorIsRefused) {
  const std::string text = text_of(
      R"(, "fixed": true)", "",
      R"(, {"name": "sill", "model": "lid.obj", "position": [0, -0.4101, 0.3], "fixed": true},
          {"name": "board", "model": "lid.obj", "position": [0, -0.21, 0.3], "mass": 1,
           "joint": {"in": "cabinet", "hinge": [-1, 0, 0], "friction": 1.1}})",
      R"({"op": "put", "object": "cube", "position": [0, -0.5, 0.5]})");
  Furnished by_hand(text), at_once(text);
  PushOperation push;
  push.object = "cube";
  push.to = Vec2(0, -0.3);
  LiveMove live = by_hand.session().begin_live(push, options_of_test().settle);
  live.follow(Vec3(0, -0.3, 0));
  const OperationResult result = by_hand.session().finish(live);
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.refusal->cause, Refusal::Cause::Topples);
  EXPECT_EQ(result.reason(), at_once.done(push).reason());
}

}  // namespace
}  // namespace trivet
