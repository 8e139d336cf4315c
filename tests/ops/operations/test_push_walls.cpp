// PUSH along walls and ceilings: what it does on a table, turned.
#include <random>

#include "ops/operations/push_axes.h"
#include "push_stage.h"

namespace trivet {
namespace {

using test::box_triangles;
using test::push;
using test::Stage;
using End = OperationResult::End;

constexpr double kGap = 1e-5;

/// A box on a board with a low step, a high one and a wall aslant of it, in the axes of a push: the
/// board is the world's floor, wall or ceiling.
class Board : public Stage {
 public:
  explicit Board(const Mat3& axes) : m_axes(axes) {
    scene.floor = false;
    add("board", {1, 1, 0.25}, {0, 0, 0.25});
    add("low", {0.1, 0.4, 0.004}, {0.3, 0.3, 0.504 + kGap});
    add("high", {0.05, 0.6, 0.05}, {-0.8, 0, 0.55 + kGap});
    add("beside", {0.6, 0.05, 0.1}, {0.2, -0.7, 0.6 + kGap});
    scene.add(test::object_of("box", box_triangles(turned(Vec3(0.1, 0.1, 0.1)))));
    const OperationResult result =
        stand(scene, *scene.find("box"), {{}, to_world({-0.3, 0, 0.6 + 1.2 * clearance()})});
    EXPECT_TRUE(result.ok()) << result.reason();
  }

  Vec3 box() const { return m_axes * position("box"); }

 private:
  Vec3 to_world(const Vec3& v) const { return m_axes.transpose() * v; }
  Vec3 turned(const Vec3& half) const { return to_world(half).cwiseAbs(); }
  void add(const std::string& name, const Vec3& half, const Vec3& at) {
    fix(name, box_triangles(turned(half)), to_world(at));
  }

  Mat3 m_axes;
};

TEST(PushAlongWalls, HasAxesToTheRightAndUpwards) {
  EXPECT_EQ(push_axes(Vec3(0, 0, 3)), Mat3::Identity());
  const Mat3 wall = push_axes(Vec3(2, 0, 0));
  EXPECT_EQ(Vec3(wall.row(0)), Vec3::UnitY());
  EXPECT_EQ(Vec3(wall.row(1)), Vec3::UnitZ());
  EXPECT_EQ(Vec3(push_axes(Vec3(0, 0, -1)).row(1)), Vec3(0, -1, 0));
  for (const double tilt : {0.0, 1e-300, 1e-9, -1e-9, 1e-7}) {
    const Vec3 up(tilt, -tilt, 2);
    EXPECT_EQ(push_axes(up), Mat3::Identity()) << tilt;
    EXPECT_EQ(push_axes(-up), push_axes(Vec3(0, 0, -1))) << tilt;
    EXPECT_TRUE(is_level(up)) << tilt;
    EXPECT_FALSE(is_level(-up)) << tilt;
  }
  EXPECT_FALSE(is_level(Vec3(1e-5, 0, 1)));
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int i = 0; i < 100; ++i) {
    const Vec3 normal(uniform(random), uniform(random), uniform(random));
    const Mat3 axes = push_axes(normal);
    EXPECT_LT((axes * axes.transpose() - Mat3::Identity()).norm(), 1e-14);
    EXPECT_NEAR(axes.determinant(), 1, 1e-14);
    EXPECT_EQ(axes(0, 2), 0) << "the first axis is level";
    EXPECT_GE(axes(1, 2), 0) << "the second one rises";
  }
}

TEST(PushAlongWalls, GoesAsOnATable) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  int ends[8] = {};
  for (int i = 0; i < 24; ++i) {
    PushOperation o = push(uniform(random), uniform(random), 0.2 + 0.5 * std::abs(uniform(random)));
    o.settle = false;
    o.slide = i % 3 > 0;
    o.step_up = i % 2 ? 0.02 : 0.004;
    Board table(Mat3::Identity());
    const OperationResult expected = table.run(o);
    ASSERT_TRUE(expected.ok()) << expected.reason();
    ++ends[static_cast<int>(expected.end)];
    for (const Vec3& normal : {Vec3(1, 0, 0), Vec3(0, -1, 0), Vec3(-1, 0, 0), Vec3(0, 0, -1)}) {
      Board wall(push_axes(normal));
      o.normal = normal;
      const OperationResult result = wall.run(o);
      ASSERT_TRUE(result.ok()) << result.reason();
      EXPECT_EQ(result.end, expected.end) << i;
      EXPECT_EQ(result.blocked_by.name, expected.blocked_by.name) << i;
      EXPECT_LT((wall.box() - table.box()).norm(), 3 * table.clearance()) << i;
    }
  }
  EXPECT_GE(ends[static_cast<int>(End::Reached)], 4);
  EXPECT_GE(ends[static_cast<int>(End::Step)], 2);
}

TEST(PushAlongWalls, FallsWhenItIsReleased) {
  Stage room;
  room.fix("wall", box_triangles(Vec3(0.1, 1, 1)), {-0.1, 0, 1 + kGap});
  room.put("box", box_triangles(Vec3(0.1, 0.1, 0.1)), {0.1 + 1.2 * room.clearance(), 0, 0.2});
  PushOperation o = push(0.3, 0.4, 0.5);  // to the right and upwards
  o.normal = Vec3::UnitX();
  o.settle = false;
  OperationResult result = room.run(o);
  ASSERT_TRUE(result.ok()) << result.reason();
  EXPECT_NEAR(room.position("box").y(), 0.3, 1e-4);
  EXPECT_NEAR(room.position("box").z(), 0.5, 1e-3);
  EXPECT_EQ(room.at("box").state, ObjectState::Held);
  o.settle = true;
  result = room.run(o);
  ASSERT_TRUE(result.ok()) << result.reason();
  EXPECT_NEAR(room.position("box").y(), 0.6, 1e-4);
  EXPECT_NEAR(room.position("box").z(), 0.1, 1e-3);
  EXPECT_EQ(room.at("box").state, ObjectState::Stable);
}

TEST(PushAlongWalls, RefusesWhereNoSurfaceIsTouched) {
  Stage room;
  room.put("box", box_triangles(Vec3(0.1, 0.1, 0.1)), {0, 0, 0.2});
  PushOperation o = push(1, 0, 0.1);
  o.normal = Vec3::UnitX();
  EXPECT_FALSE(room.run(o).ok());
  o.normal = Vec3::Zero();
  const OperationResult result = room.run(o);
  EXPECT_NE(result.reason().find("normal"), std::string::npos) << result.reason();
}

}  // namespace
}  // namespace trivet
