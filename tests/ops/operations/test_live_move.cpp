// Interactive moves commit the same as their operation, bit for bit.
#include "ops/files/json/text.h"
#include "ops/operations/live_move.h"
#include "ops/operations/perform.h"
#include "ops/placement/neighbourhood.h"
#include "stage.h"
#include "support/random_shapes.h"
#include "support/same_scene.h"

namespace trivet {
namespace {

using namespace test;

/// A table with a slab and a post, a box that carries another, and a bumpy ball.
struct Desk : Stage {
  Desk() {
    fix("table", box_triangles(Vec3(1, 1, 0.25)), {0, 0, 0.25 + 1e-5});
    fix("slab", box_triangles(Vec3(0.2, 0.5, 0.002)), {0.3, 0, 0.5 + 0.002 + 2e-5});
    fix("post", box_triangles(Vec3(0.02, 0.02, 0.3)), {-0.3, 0.3, 0.8 + 2e-5});
    put("box", box_triangles(Vec3(0.1, 0.1, 0.05)), {-0.5, 0, 1});
    put("load", box_triangles(Vec3(0.03, 0.05, 0.02)), {-0.48, 0.01, 1});
    put("ball", bumpy_sphere(8, 12, 0.1, 3), {0, -0.5, 2});
  }
};

// As read from a layout, so that only the written values count.
Operation through_json(const Operation& operation) {
  const nlohmann::json json = nlohmann::json::parse(operation_json(operation).dump());
  return read_operation(JsonPlace(json, "test"));
}

struct Drag {
  Operation operation;
  std::vector<Vec3> goals;
  std::vector<double> amounts;
};

/// @return whether the move was blocked.
bool expect_the_same(const Scene& scene, const Drag& drag) {
  Scene by_hand = scene;
  const std::string before = snapshot(scene);
  LiveMove live(by_hand, drag.operation, {});
  for (const Vec3& goal : drag.goals) live.follow(goal);
  for (const double amount : drag.amounts) live.follow(amount);
  EXPECT_EQ(snapshot(by_hand), before) << "no commit before the end";
  const Operation operation = live.operation();
  const std::vector<Placement> placements = live.placements();
  const OperationResult result = live.finish(by_hand);
  if (!result.ok()) {
    EXPECT_EQ(snapshot(by_hand), before);
  }

  Scene at_once = scene;
  const OperationResult expected = perform(at_once, through_json(operation));
  EXPECT_EQ(result.ok(), expected.ok()) << result.reason() << expected.reason();
  EXPECT_EQ(result.reason(), expected.reason());
  EXPECT_EQ(result.end, expected.end);
  EXPECT_EQ(difference(by_hand, at_once), "");
  return result.ok() && result.end != OperationResult::End::Reached;
}

template <class T>
T of(const std::string& object) {
  T operation;
  operation.object = object;
  return operation;
}

TEST(LiveMove, CommitsSameAsOperation) {
  const unsigned seed = 20261122;
  SCOPED_TRACE(seed);
  Random random(seed);
  const Desk desk;
  int num_stopped = 0;
  constexpr int kNum = 96;
  for (int i = 0; i < kNum; ++i) {
    SCOPED_TRACE(i);
    const std::string name = i % 3 == 0 ? "box" : i % 3 == 1 ? "ball" : "load";
    Drag drag;
    Vec3 hand = desk.position(name);
    for (int k = random.integer(1, 8); k > 0; --k) {
      hand += random.in_cube(0.1);
      drag.goals.push_back(hand);
    }
    switch (i % 8) {
      case 0:
      case 1:
      case 2: {
        auto push = of<PushOperation>(name);
        push.settle = i % 2;
        drag.operation = push;
        break;
      }
      case 3:
      case 4: {
        auto move = of<TranslateOperation>(name);
        move.free = i % 3 == 0;
        move.settle = i % 5 == 0;
        for (Vec3& goal : drag.goals) goal -= desk.position(name);
        drag.operation = move;
        break;
      }
      case 5: {
        auto turn = of<TurnOperation>(name);
        turn.about = static_cast<TurnOperation::About>(random.integer(0, 2));
        turn.settle = i % 2;
        drag = {turn, {}, {random.uniform(-90, 90), 10, random.uniform(-300, 300)}};
        break;
      }
      case 6: {
        auto rotate = of<RotateOperation>(name);
        rotate.axis = random.direction();
        rotate.free = i % 3 == 0;
        drag = {rotate, {}, {random.uniform(-90, 90), random.uniform(-300, 300)}};
        break;
      }
      default:
        drag = {of<PickUpOperation>(name), {}, {0.3, -0.1, random.uniform(0, 0.2)}};
    }
    num_stopped += expect_the_same(desk.scene, drag);
  }
  EXPECT_GT(num_stopped, kNum / 10);
  EXPECT_LT(num_stopped, kNum * 3 / 4);
}

TEST(LiveMove, GoesAroundObstaclesOfStraightPath) {
  Desk desk;
  auto push = of<PushOperation>("box");
  push.settle = false;
  LiveMove live(desk.scene, push, {});
  for (const Vec2& goal : {Vec2(-0.5, 0.1), Vec2(-0.5, 0.5), Vec2(-0.1, 0.6), Vec2(0, 0.3)})
    live.follow(Vec3(goal.x(), goal.y(), 0));
  EXPECT_EQ(live.result().end, OperationResult::End::Reached);
  EXPECT_EQ(live.placements().size(), 2u);  // the load, too
  EXPECT_FALSE(live.contacts().empty());
  ASSERT_TRUE(live.finish(desk.scene).ok());
  EXPECT_NEAR((desk.position("box") - Vec3(0, 0.3, 0)).head<2>().norm(), 0, 1e-5);
}

TEST(LiveMove, RefusesImpossibleMoves) {
  Desk desk;
  EXPECT_TRUE(LiveMove(desk.scene, of<PushOperation>("none"), {}).refused());
  EXPECT_TRUE(LiveMove(desk.scene, of<PushOperation>("table"), {}).refused());
  EXPECT_TRUE(LiveMove(desk.scene, of<DeleteOperation>("box"), {}).refused());
  LiveMove live(desk.scene, of<TranslateOperation>("table"), {});
  live.follow(Vec3(1, 0, 0));
  EXPECT_NE(live.result().reason().find("is fixed"), std::string::npos) << live.result().reason();
  EXPECT_FALSE(live.finish(desk.scene).ok());
}

}  // namespace
}  // namespace trivet
