// An object that hovers is not at rest, however little; what touches only touches.
#include <gtest/gtest.h>

#include <chrono>

#include "ops/check/check.h"
#include "ops/operations/perform.h"
#include "ops/placement/clearance.h"
#include "support/solids.h"

namespace trivet::test {
namespace {

/// A box of edge 0.1 x `scale` at this height over the floor or over a table as large as the scene.
struct Hovering {
  Scene scene;
  ObjectId box;
  double clearance = 0;

  Hovering(double scale, bool on_table, double height) {
    const double half = 0.05 * scale;
    double top = 0;
    if (on_table) {
      const ObjectId table =
          scene.add(object_of("table", box_triangles(scale * Vec3(0.5, 0.5, 0.35)), true));
      EXPECT_TRUE(stand(scene, table, {{}, {0, 0, 0.3501 * scale}}).ok());
      top = scene.world_box(table).upper.z();
    }
    box = scene.add(object_of("box", box_triangles(Vec3(half, half, half))));
    Pose pose{{}, {0, 0, 0}};
    pose.translation.z() = top + height - body_of(scene.at(box), pose).world_box.lower.z();
    const OperationResult result = stand(scene, box, pose);
    EXPECT_TRUE(result.ok()) << result.reason();
    clearance = default_clearance(scene);
  }
  ObjectState state() const { return scene.at(box).state; }
};

TEST(Hover, IsNoRestBeyondTwoClearances) {
  for (const double scale : {0.1, 1.0, 10.0, 200.0})
    for (const bool on_table : {false, true})
      for (double height = 1e-7 * scale; height < 0.1 * scale; height *= 1.7) {
        Hovering h(scale, on_table, height);
        if (std::abs(height / h.clearance - 2) < 0.05) continue;
        SCOPED_TRACE(std::to_string(scale) + " " + std::to_string(height / h.clearance));
        const SceneCheck check = check_scene(h.scene, 1);
        if (height < 2 * h.clearance) {
          EXPECT_EQ(h.state(), ObjectState::Stable);
          EXPECT_TRUE(check.ok());
          continue;
        }
        EXPECT_EQ(h.state(), ObjectState::Unsupported);
        EXPECT_EQ(check.not_at_rest, std::vector<std::string>{"box"});
        ASSERT_EQ(check.hovering.size(), 1u);
        EXPECT_EQ(check.hovering[0].above, on_table ? "table" : "floor");
        EXPECT_NEAR(check.hovering[0].height, height, 1.1 * h.clearance);
        update_contacts(h.scene);
        EXPECT_EQ(h.state(), ObjectState::Unsupported);
      }
}

TEST(Hover, IsNoRestBesideWall) {
  Scene scene;
  const ObjectId wall = scene.add(object_of("wall", box_triangles({0.1, 1, 1}), true));
  ASSERT_TRUE(stand(scene, wall, {{}, {0, 0, 1.01}}).ok());
  const ObjectId box = scene.add(object_of("box", box_triangles({0.05, 0.05, 0.05})));
  const double clearance = default_clearance(scene);
  ASSERT_TRUE(stand(scene, box, {{}, {0.15 + clearance, 0, 0.05 + 6 * clearance}}).ok());
  EXPECT_EQ(scene.at(box).state, ObjectState::Unsupported);
}

// Processor time of a check of boxes on a grid, at this height.
double seconds_of_check(double height) {
  Scene scene;
  const Object box = object_of("", box_triangles({0.05, 0.05, 0.05}));
  for (int i = 0; i < 2000; ++i) {
    Object one = box;
    one.name = "b" + std::to_string(i);
    one.placed = true;
    one.pose.translation = Vec3(0.2 * (i % 50), 0.2 * (i / 50), 0.05 + height);
    scene.add(std::move(one));
  }
  const double clearance = default_clearance(scene);
  const std::clock_t begin = std::clock();
  update_contacts(scene, clearance);
  const SceneCheck check = check_scene(scene, 1, clearance);
  const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  EXPECT_EQ(check.hovering.size(), height > 2 * clearance ? 2000u : 0u);
  return seconds;
}

TEST(Hover, CostsNoMoreThanTwiceStanding) {
  double standing = kInfinity, hovering = kInfinity, low = kInfinity;
  for (int k = 0; k < 3; ++k) {
    standing = std::min(standing, seconds_of_check(1.5e-5));
    low = std::min(low, seconds_of_check(1.5e-4));
    hovering = std::min(hovering, seconds_of_check(1e-3));
  }
  std::printf("2,000 boxes: standing %.3f s, 15 clearances up %.3f s, 1 mm up %.3f s\n", standing,
              low, hovering);
  EXPECT_LT(hovering, 2 * standing + 0.01);
  EXPECT_LT(low, 2 * standing + 0.01);
}

ObjectId add_cube(Scene& scene, const std::string& name) {
  return scene.add(object_of(name, box_triangles({0.5, 0.5, 0.5})));
}

TEST(Touching, FlushCubesStandApart) {
  Scene scene;
  for (const auto& [name, x, y] :
       {std::tuple("c00", 0, 0), {"c01", 0, 1}, {"c10", 1, 0}, {"c11", 1, 1}}) {
    const ObjectId id = add_cube(scene, name);
    const OperationResult result = stand(scene, id, {{}, Vec3(x, y, 0.5)});
    ASSERT_TRUE(result.ok()) << result.reason();
    EXPECT_LT(result.moved, 3 * default_clearance(scene));
    EXPECT_EQ(scene.at(id).state, ObjectState::Stable);
  }
  EXPECT_EQ(check_scene(scene, 1).interpenetrating_pairs(), 0);
}

TEST(Touching, HalfHeightInFloat32Stands) {
  Scene scene;
  const ObjectId id = scene.add(object_of("box", box_triangles({0.05f, 0.05f, 0.05f})));
  const OperationResult result = stand(scene, id, {{}, {0, 0, 0.05}});
  ASSERT_TRUE(result.ok()) << result.reason();
  EXPECT_EQ(scene.at(id).state, ObjectState::Stable);
}

TEST(Touching, IsNotedNotFailed) {
  Scene scene;
  const auto add = [&](const char* name, const Vec3& half, const Vec3& at) {
    Object wall = object_of(name, box_triangles(half), true);
    wall.placed = true;
    wall.pose.translation = at;
    scene.add(std::move(wall));
  };
  add("north", {2, 0.125, 1}, {0, 1.125, 1});
  add("west", {0.125, 1, 1}, {-1.875, 0, 1});
  update_contacts(scene);
  const SceneCheck check = check_scene(scene, 1);
  EXPECT_TRUE(check.ok());
  ASSERT_EQ(check.touching.size(), 1u);
  EXPECT_EQ(check.touching[0].depth, 0);
  EXPECT_GT(check.interpenetrating_pairs(), 0);
}

TEST(Touching, DepthsAreTold) {
  Scene scene;
  const ObjectId first = add_cube(scene, "first"), second = add_cube(scene, "second");
  ASSERT_TRUE(stand(scene, first, {{}, {0, 0, 0.5001}}).ok());
  for (const double depth : {1e-4, 0.01, 0.3}) {
    const OperationResult result = stand(scene, second, {{}, {1 - depth, 0.2, 0.6}});
    ASSERT_FALSE(result.ok());
    EXPECT_NEAR(result.refusal->number("depth"), depth, 2e-3 * depth);
    EXPECT_NEAR(result.refusal->number("x"), 0.5, 0.5 * depth + 1e-6);
    EXPECT_NE(result.reason().find("passes through \"first\", by "), std::string::npos);
  }
  const OperationResult below = stand(scene, second, {{}, {3, 0, 0.49}});
  EXPECT_NEAR(below.refusal->number("depth"), 0.01, 1e-7);
  const OperationResult start = put(scene, second, {{}, {0.9, 0, 0.6}});
  EXPECT_NEAR(start.refusal->number("depth"), 0.1, 1e-3);
}

TEST(Touching, WithoutRoomIsTold) {
  Scene scene;
  for (const double x : {-1.0, 1.0}) {
    const ObjectId wall =
        scene.add(object_of(x < 0 ? "left" : "right", box_triangles({0.5, 0.5, 0.5}), true));
    ASSERT_TRUE(stand(scene, wall, {{}, {x, 0, 0.5001}}).ok());
  }
  const ObjectId id = add_cube(scene, "between");
  const OperationResult result = stand(scene, id, {{}, {0, 0, 0.5001}});
  ASSERT_FALSE(result.ok());
  EXPECT_NE(result.reason().find("touches \"left\""), std::string::npos) << result.reason();
}

}  // namespace
}  // namespace trivet::test
