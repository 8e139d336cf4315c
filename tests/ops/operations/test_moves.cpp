// TURN, PICK-UP, TRANSLATE and ROTATE, and their stops. The paper's Fig. 5: see figures/.
#include "turn_stage.h"

namespace trivet {
namespace {

using test::box_triangles;
using test::BoxOnFloor;
using test::Stage;
using test::turn;
using End = OperationResult::End;

double cosine(const Rotation& r) { return r.matrix()(0, 0); }

// In the other direction the edge would enter the floor.
TEST(Turn, StopsAtOnceAgainstFloor) {
  BoxOnFloor s;
  TurnOperation o = turn(TurnOperation::About::Line, -30);
  o.point = Vec3(0.2, 0, 0);
  const OperationResult result = s.run(o);
  EXPECT_EQ(result.end, End::Blocked);
  EXPECT_EQ(result.blocked_by.name, "floor");
  EXPECT_NEAR(result.turned_deg, 0, 1e-3);
}

// A wall at x = 0.21: the corner at distance sqrt(0.05) from the axis meets it at
// cos(a + atan(1 / 2)) = 0.21 / sqrt(0.05).
TEST(Turn, StopsAtWall) {
  BoxOnFloor s;
  s.fix("wall", box_triangles(Vec3(0.05, 1, 1)), {0.26, 0, 1 + 1e-5});
  const OperationResult result = s.run(turn(TurnOperation::About::Normal, 90));
  EXPECT_EQ(result.end, End::Blocked);
  EXPECT_EQ(result.blocked_by.name, "wall");
  // The corner at (0.2, -0.1) goes towards the wall first.
  const double expected = std::atan(0.5) - std::acos(0.21 / std::sqrt(0.05));
  EXPECT_NEAR(result.turned_deg, expected * 180 / M_PI, 0.01);
  EXPECT_NEAR(result.blocked_at.x(), 0.21, 1e-5);
}

TEST(Turn, RefusesContactThatDoesNotExist) {
  BoxOnFloor s;
  TurnOperation o = turn(TurnOperation::About::Normal, 10);
  o.with = "shelf";
  s.refused(o, "\"box\" does not touch \"shelf\"");
  s.put("ball", test::ball(0.1, 9, 12), {1, 1, 1}, Rotation::about_axis(Vec3::UnitX(), 0.1));
  o.with.reset();
  o.about = TurnOperation::About::Line;
  ASSERT_TRUE(s.run(TranslateOperation{{"box"}, Vec3(0, 0, 0.1)}).ok());
  s.refused(o, "does not touch anything");
}

TEST(PickUp, GoesAlongNormalAndDropsLinks) {
  BoxOnFloor s;
  const double z = s.position("box").z();
  const OperationResult result = s.run(PickUpOperation{{"box"}, 0.25, {}});
  ASSERT_TRUE(result.ok()) << result.reason();
  EXPECT_EQ(result.end, End::Reached);
  EXPECT_NEAR((s.position("box") - Vec3(0, 0, z + 0.25)).norm(), 0, s.clearance());
  EXPECT_TRUE(s.at("box").contacts.empty());
  EXPECT_EQ(s.at("box").state, ObjectState::Held);
  EXPECT_FALSE(check_scene(s.scene, 1).ok());  // an object in the air is unsupported
  s.refused(PickUpOperation{{"box"}, 0.25, {}}, "lies on nothing");
  ASSERT_TRUE(s.run(PutOperation{{"box"}, s.at("box").pose}).ok());
  EXPECT_EQ(s.at("box").state, ObjectState::Stable);
  EXPECT_NEAR(s.position("box").z(), z, s.clearance());
}

TEST(PickUp, StopsBelowShelf) {
  BoxOnFloor s;
  s.fix("shelf", box_triangles(Vec3(1, 1, 0.01)), {0, 0, 0.81});
  const OperationResult result = s.run(PickUpOperation{{"box"}, 0.25, "floor"});
  EXPECT_EQ(result.end, End::Blocked);
  EXPECT_EQ(result.blocked_by.name, "shelf");
  EXPECT_NEAR(s.position("box").z(), 0.5, 2 * s.clearance());
}

TEST(Translate, StopsAtCollisionOrIgnoresIt) {
  BoxOnFloor s;
  s.fix("wall", box_triangles(Vec3(0.05, 1, 1)), {1, 0, 1 + 1e-5});
  TranslateOperation o{{"box"}, Vec3(0.9, 0, 0.1)};
  OperationResult result = s.run(o);
  EXPECT_EQ(result.end, End::Blocked);
  EXPECT_EQ(result.blocked_by.name, "wall");
  EXPECT_NEAR(s.position("box").x(), 0.75, 2 * s.clearance());
  EXPECT_EQ(s.at("box").state, ObjectState::Held);

  o.by = Vec3(0.2, 0, 0);
  o.free = true;
  result = s.run(o);
  ASSERT_TRUE(result.ok());
  EXPECT_EQ(result.interpenetrates, std::vector<std::string>{"wall"});
  EXPECT_EQ(s.at("box").state, ObjectState::Invalid);
  EXPECT_GT(check_scene(s.scene, 1).interpenetrating_pairs(), 0);
  // No other move works until that is resolved.
  s.refused(TranslateOperation{{"box"}, Vec3(0.5, 0, 0)}, "passes through \"wall\"");
  s.refused(PickUpOperation{{"box"}, 0.1, {}}, "passes through \"wall\"");
  o.by = Vec3(1, 0, 0);
  o.settle = true;
  result = s.run(o);
  EXPECT_TRUE(result.interpenetrates.empty());
  EXPECT_EQ(s.at("box").state, ObjectState::Stable);
  EXPECT_TRUE(check_scene(s.scene, 1).ok());
}

TEST(Translate, GoesFreelyBelowFloor) {
  BoxOnFloor s;
  TranslateOperation o{{"box"}, Vec3(0, 0, -0.1), false, true};
  o.free = true, o.settle = false;
  EXPECT_EQ(s.run(o).interpenetrates, std::vector<std::string>{"floor"});
  EXPECT_EQ(s.at("box").state, ObjectState::Invalid);
}

TEST(Rotate, TurnsManyTimesAboutCentreOfMass) {
  BoxOnFloor s;
  ASSERT_TRUE(s.run(TranslateOperation{{"box"}, Vec3(0, 0, 1)}).ok());
  const Vec3 before = s.position("box");
  const OperationResult result = s.run(RotateOperation{{"box"}, Vec3(0, 3, 0), 3240 + 45, {}});
  EXPECT_EQ(result.end, End::Reached);
  EXPECT_EQ(result.num_motions, 37);
  EXPECT_NEAR((s.position("box") - before).norm(), 0, 1e-12);
  EXPECT_NEAR(cosine(s.at("box").pose.rotation), std::sqrt(0.5), 1e-12);
}

TEST(Rotate, StopsAtFloor) {
  BoxOnFloor s;
  const OperationResult result = s.run(RotateOperation{{"box"}, Vec3(0, 1, 0), 90, {}});
  EXPECT_EQ(result.end, End::Blocked);
  EXPECT_EQ(result.blocked_by.name, "floor");
}

TEST(Motion, MeasuresTurnsByTangents) {
  for (double angle = -90; angle <= 90; angle += 0.37) {
    EXPECT_NEAR(turn_time(angle), std::tan(angle * M_PI / 360), 1e-15) << angle;
    EXPECT_NEAR(turned_deg(turn_time(angle)), angle, 1e-13) << angle;
  }
  EXPECT_EQ(turn_time(90), 1);
  EXPECT_EQ(turn_time(0), 0);
}

}  // namespace
}  // namespace trivet
