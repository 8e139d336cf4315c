// PUSH: the paper's rules for steps, edges, walls and curved surfaces. Its Fig. 4: see figures/.
#include <algorithm>

#include "push_stage.h"

namespace trivet {
namespace {

using test::box_triangles;
using test::push;
using test::Stage;
using test::Table;
using End = OperationResult::End;

// Climbs a step of exactly the threshold, but not one higher by a few clearances.
TEST(Push, ClimbsUpToThreshold) {
  for (const double excess : {-4.0, 4.0}) {
    Table t;
    t.fix("step", box_triangles(Vec3(0.2, 0.5, 0.0078125)), {0.2, 0, t.top() + 0.0078125 + 1e-5});
    PushOperation o = push(1, 0, 0.7);
    o.step_up = 0.015625 + 1e-5 - excess * t.clearance();
    const OperationResult result = t.run(o);
    EXPECT_EQ(result.end, excess < 0 ? End::Reached : End::Step) << excess;
  }
}

// It came to rest with a clearance a little larger than that of the push, for which it does not
// touch.
TEST(Push, GoesDownOntoWhatItIsKnownToLieOn) {
  Table t;
  const double clearance = t.clearance();
  Pose pose = t.at("box").pose;
  pose.translation.z() = t.top() + 0.1 + 1.9 * clearance;
  SettleOptions before;
  before.clearance = clearance;
  ASSERT_TRUE(stand(t.scene, *t.scene.find("box"), pose, before).ok());
  t.options.clearance = 0.8 * clearance;
  const OperationResult result = t.run(push(1, 0, 0.2));
  ASSERT_TRUE(result.ok()) << result.reason();
  EXPECT_EQ(result.end, End::Reached);
  EXPECT_NEAR(t.position("box").x(), -0.3, 1e-5);
  EXPECT_LT(t.position("box").z(), pose.translation.z());
}

// Released there it would fall: it is pulled back to where its centre is over the edge.
TEST(Push, StaysOnTable) {
  for (const double distance : {3.0, 1.55}) {
    Table t;
    const OperationResult result = t.run(push(1, 0, distance));
    ASSERT_TRUE(result.ok()) << result.reason();
    EXPECT_EQ(result.end, End::Edge);
    EXPECT_NEAR(t.position("box").x(), 1, 1e-5);
    EXPECT_EQ(t.at("box").state, ObjectState::Stable);
  }
}

// Detects even tiny obstacles and gaps: a needle of 0.1 mm, a slit of 0.1 mm.
TEST(Push, DetectsTinyObstaclesAndSlits) {
  Table t;
  t.fix("needle", box_triangles(Vec3(5e-5, 5e-5, 0.05)), {0.3, 0.02, t.top() + 0.05 + 1e-5});
  OperationResult result = t.run(push(1, 0, 1));
  EXPECT_EQ(result.end, End::Blocked == result.end ? End::Blocked : End::Step);
  EXPECT_EQ(result.blocked_by.name, "needle");
  EXPECT_NEAR(t.position("box").x(), 0.3 - 5e-5 - 0.1, 2.1 * t.clearance());

  // A needle pushed over a slit between two tables, deeper than step_down, stops there.
  Stage slit;
  slit.fix("left", box_triangles(Vec3(0.5, 0.5, 0.25)), {-0.5, 0, 0.25 + 1e-5});
  slit.fix("right", box_triangles(Vec3(0.5, 0.5, 0.25)), {0.501, 0, 0.25 + 1e-5});
  slit.put("box", box_triangles(Vec3(1e-4, 1e-4, 1e-4)), {-0.3, 0, 0.6});
  result = slit.run(push(1, 0, 0.6));
  EXPECT_EQ(result.end, End::Edge);
  EXPECT_NEAR(slit.position("box").x(), 0, 1e-5);
}

TEST(Push, SlidesAlongWallAndPastItsEnd) {
  Table t;
  // A wall along x + y = 0.2, turned by 45 degrees.
  const ObjectId wall =
      t.scene.add(test::object_of("wall", box_triangles(Vec3(0.01, 2, 0.2)), true));
  const double r = 0.01;
  const Vec3 n(std::sqrt(0.5), std::sqrt(0.5), 0);
  const Pose pose{Rotation::about_axis(Vec3::UnitZ(), std::tan(M_PI / 8)),
                  Vec3(0.1, 0.1, t.top() + 0.2 + 1e-5) + r * n};
  ASSERT_TRUE(stand(t.scene, wall, pose).ok());
  PushOperation o = push(1, 0, 0.8);
  OperationResult result = t.run(o);
  ASSERT_TRUE(result.ok()) << result.reason();
  EXPECT_EQ(result.end, End::Blocked);
  EXPECT_EQ(result.blocked_by.name, "wall");
  // The foot of the goal (0.3, 0) on the line that the box's corner keeps it from: x + y = 0.
  EXPECT_NEAR(t.position("box").x(), 0.15, 1e-5);
  EXPECT_NEAR(t.position("box").y(), -0.15, 1e-5);

  Table still;
  const ObjectId other =
      still.scene.add(test::object_of("wall", box_triangles(Vec3(0.01, 2, 0.2)), true));
  ASSERT_TRUE(stand(still.scene, other, pose).ok());
  o.slide = false;
  result = still.run(o);
  EXPECT_EQ(result.end, End::Blocked);
  EXPECT_NEAR(still.position("box").x(), 0, 1e-5);
  EXPECT_NEAR(still.position("box").y(), 0, 1e-5);
}

TEST(Push, StopsInCorner) {
  Table t;
  t.fix("wall_x", box_triangles(Vec3(0.01, 0.5, 0.2)), {0.01, 0, t.top() + 0.2 + 1e-5});
  t.fix("wall_y", box_triangles(Vec3(0.3, 0.01, 0.2)), {-0.31, 0.21, t.top() + 0.2 + 1e-5});
  const OperationResult result = t.run(push(1, 1, 1));
  EXPECT_EQ(result.end, End::Blocked);
  EXPECT_NEAR(t.position("box").x(), -0.1, 1e-5);
  EXPECT_NEAR(t.position("box").y(), 0.1, 1e-5);
}

TEST(Push, GoesToPoint) {
  Table t;
  PushOperation o;
  o.object = "box";
  o.to = Vec2(0.25, -0.5);
  EXPECT_EQ(t.run(o).end, End::Reached);
  EXPECT_NEAR((t.position("box").head<2>() - Vec2(0.25, -0.5)).norm(), 0, t.clearance());
}

// Up a slope of 20 degrees and over its ridge: the height is that of the surface at every end.
TEST(Push, FollowsSlopes) {
  const double slope = std::tan(20 * M_PI / 180);
  for (const double end : {0.3, 0.5, 0.8}) {
    Stage s;
    s.options = test::perfect_friction();
    s.fix("roof", test::prism({{0, 0}, {1, 0}, {0.5, 0.5 * slope}}, 0.5), {0, 0, 1e-5});
    s.put("box", test::ball(0.02, 16, 24), {0.1, 0, 0.5});
    PushOperation o;
    o.object = "box";
    o.to = Vec2(end, 0);
    o.settle = false;
    const OperationResult result = s.run(o);
    ASSERT_TRUE(result.ok()) << result.reason();
    EXPECT_EQ(result.end, End::Reached);
    // Brute force: distance of the fall from high above in this orientation.
    Scene copy = s.scene;
    const ObjectId id = *copy.find("box");
    TranslateOperation up{{"box"}, Vec3(0, 0, 0.5)}, down{{"box"}, Vec3(0, 0, -1)};
    ASSERT_TRUE(perform(copy, up).ok());
    ASSERT_TRUE(perform(copy, down).ok());
    EXPECT_NEAR(s.position("box").z(), copy.at(id).pose.translation.z(), 3 * s.clearance()) << end;
  }
}

// A steep slope higher than step_up is a wall: not climbed in small steps.
TEST(Push, DoesNotCreepUpSteepSlopes) {
  for (const double deg : {70.0, 76.0, 84.0, 89.0}) {
    const double slope = std::tan(deg * M_PI / 180), height = 0.04, foot = height / slope;
    Table t;
    t.fix("slope", test::prism({{0, 0}, {0.2, 0}, {0.2, height}, {foot, height}}, 0.5),
          {0, 0, t.top() + 1e-5});
    const double before = t.position("box").z();
    PushOperation o = push(1, 0, 0.5);
    o.step_up = 0.01;
    o.settle = false;
    const OperationResult result = t.run(o);
    ASSERT_TRUE(result.ok()) << result.reason();
    EXPECT_EQ(result.blocked_by.name, "slope") << deg;
    // Its foot is a little above the table: that is one step, of a few clearances.
    EXPECT_NEAR(t.position("box").z(), before, 8 * slope * t.clearance()) << deg;
    EXPECT_NEAR(t.position("box").x(), -0.1, 1e-4) << deg;
    EXPECT_LT(result.steps.size(), 12u) << deg;
  }
}

TEST(Push, RefusesImpossiblePushes) {
  Table t;
  t.scene.add(test::object_of("apple", box_triangles(Vec3(0.1, 0.1, 0.1))));
  PushOperation o = push(1, 0, 1);
  o.object = "table";
  t.refused(o, "\"table\" is fixed");
  o.object = "apple";
  t.refused(o, "\"apple\" is not in the scene");
  o.object = "pear";
  t.refused(o, "there is no object \"pear\"");
  ASSERT_TRUE(t.run(TranslateOperation{{"box"}, Vec3(0, 0, 0.1)}).ok());
  t.refused(push(1, 0, 1), "\"box\" lies on nothing");
}

}  // namespace
}  // namespace trivet
