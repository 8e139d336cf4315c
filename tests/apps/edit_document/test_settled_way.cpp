// Playback paths: intermediate poses and end.
#include <cmath>

#include "apps/edit/document/settled_way.h"
#include "apps/edit_document/testing.h"
#include "core/motion/pose_interpolation.h"
#include "support/random_shapes.h"

namespace trivet::edit::test {
namespace {

using trivet::test::Random;

double apart(const Pose& a, const Pose& b) {
  return (a.translation - b.translation).norm() +
         (a.rotation.matrix() - b.rotation.matrix()).norm();
}

Pose turned(const Pose& pose, const Vec3& centre, const Vec3& axis, double angle) {
  const Rotation r = Rotation::about_axis(axis, std::tan(0.5 * angle));
  return {(r * pose.rotation).normalized(),
          Vec3(centre + r.matrix() * (pose.translation - centre))};
}

TEST(SettledWay, TurnsAboutAxisOfStepBetweenPoses) {
  Random random(20261122);
  for (int i = 0; i < 200; ++i) {
    const Pose from{random.rotation(), random.in_cube(1)};
    const Vec3 centre = random.in_cube(1), axis = random.direction();
    const double angle = random.uniform(1e-4, 3);
    const Pose to = turned(from, centre, axis, angle);
    EXPECT_LT(apart(interpolate_pose(from, to, 0), from), 1e-9);
    EXPECT_LT(apart(interpolate_pose(from, to, 1), to), 1e-9);
    for (const double part : {0.25, 0.5, 0.9})
      EXPECT_LT(apart(interpolate_pose(from, to, part), turned(from, centre, axis, part * angle)),
                1e-7);
  }
}

TEST(SettledWay, GoesStraightBetweenPoses) {
  const Pose from{{}, Vec3(1, 2, 3)}, to{{}, Vec3(2, 2, 1)};
  EXPECT_EQ(interpolate_pose(from, to, 0.5).translation, Vec3(1.5, 2, 2));
  const Pose upside_down{{0, 1, 0, 0}, Vec3(2, 2, 1)};
  const Pose half = interpolate_straight(from, upside_down, 0.5);
  EXPECT_EQ(half.translation, Vec3(1.5, 2, 2));
  EXPECT_LT(apart(half, {Rotation{1, 1, 0, 0}.normalized(), half.translation}), 1e-12);
  EXPECT_LT(apart(interpolate_straight(from, upside_down, 1), upside_down), 1e-12);
}

class Watched : public testing::Test {
 protected:
  Watched() : document(folder.file("recovery")) {
    document.done(document->open_demo("spoon-saucer"));
  }

  std::shared_ptr<const SettledWay> way() const { return document->snapshot()->way; }

  /// Expects a path without jumps that ends at the object's pose.
  void expect_continuous() {
    const SettledWay& w = *way();
    const Pose end = document->snapshot()->find(w.moved.front())->object->pose;
    EXPECT_EQ(apart(pose_on(w, 1), end), 0);
    EXPECT_LT(apart(pose_on(w, 0), w.poses.front()), 1e-12);
    Pose last = w.poses.front();
    for (int i = 1; i <= 1000; ++i) {
      const Pose now = pose_on(w, i / 1000.0);
      EXPECT_LT((now.translation - last.translation).norm(), 0.01 * (w.length() + w.size)) << i;
      last = now;
    }
  }

  TemporaryFolder folder;
  Recorder document;
};

TEST_F(Watched, PutFallsFromStartAndTopples) {
  PutOperation put;
  put.object = "spoon";
  put.start = {Rotation::about_axis(Vec3::UnitX(), 0.9), Vec3(0.4, 0.1, 0.3)};  // upright
  ASSERT_TRUE(document.done(document->perform(put))) << document.last_text();
  ASSERT_TRUE(way());
  EXPECT_EQ(apart(way()->poses.front(), put.start), 0);
  EXPECT_GT(way()->poses.size(), 3u) << "it falls, and tips over";
  expect_continuous();
  ASSERT_TRUE(document.done(document->undo()));
  EXPECT_FALSE(way()) << "an undo has no path";
}

TEST_F(Watched, CarriesLoadsAlong) {
  PushOperation push;
  push.object = "saucer";
  push.direction = Vec2(1, 0.2);
  push.distance = 0.2;
  const Vec3 spoon =
      document.object("spoon").pose.translation - document.object("saucer").pose.translation;
  ASSERT_TRUE(document.done(document->perform(push))) << document.last_text();
  ASSERT_TRUE(way());
  ASSERT_EQ(way()->moved.size(), 2u);
  EXPECT_EQ(way()->moved[1], document.id("spoon"));
  expect_continuous();
  const Pose middle = pose_on(*way(), 0.5);
  const Pose carried = carried_pose(middle, way()->poses.back(), document.object("spoon").pose);
  EXPECT_LT((carried.translation - middle.translation - spoon).norm(), 1e-9);
}

TEST_F(Watched, PlaysOnlySettlingAfterDrag) {
  PushOperation push;
  push.object = "spoon";
  document->begin_drag(push);
  const Vec3 at = document.object("spoon").pose.translation;
  document->drag_to(at + Vec3(-0.02, 0.01, 0));
  ASSERT_TRUE(document->wait_until_idle());
  const Pose in_hand = document.object("spoon").pose;
  document->drag_to(at + Vec3(-0.02, 0.01, 0));
  ASSERT_TRUE(document.done(document->end_drag())) << document.last_text();
  if (way()) {
    EXPECT_EQ(apart(way()->poses.front(), in_hand), 0);
    expect_continuous();
  } else {
    EXPECT_LT(apart(document.object("spoon").pose, in_hand), 1e-5);
  }
}

}  // namespace
}  // namespace trivet::edit::test
