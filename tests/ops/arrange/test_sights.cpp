// Lines of sight and of reach; each with a judge of its own.
#include <atomic>
#include <cmath>

#include "ops/arrange/arrange_testing.h"
#include "ops/arrange/conflict.h"
#include "ops/arrange/placer.h"
#include "ops/arrange/relations.h"
#include "ops/arrange/sight_grid.h"
#include "ops/arrange/sights.h"
#include "support/random_shapes.h"

namespace trivet::test {
namespace {

// A table, a screen on it, and an eye before it.
Stage screen_stage(double screen_height) {
  Stage stage;
  stage.fix("table", box_between(Vec3(-0.5, -0.4, 0), Vec3(0.5, 0.4, 0.7)), Vec3(0, 0, 1e-5));
  stage.fix("screen", box_between(Vec3(-0.2, -0.01, 0), Vec3(0.2, 0.01, screen_height)),
            Vec3(0, 0, 0.70002));
  stage.add_cube("cup", 0.08);
  stage.relate<relations::On>("cup", "table");
  Relation& view = stage.relate<relations::View>("cup");
  view.as<relations::View>()->eye = Vec3(0, -1.2, 0.8);
  view.as<relations::View>()->part = 1;
  return stage;
}

// By the shadow of the screen on the plane of the cup's corners, without rays.
bool is_behind_screen(const Vec3& corner, const Vec3& eye, double screen_height) {
  const double t = (-0.01 - eye.y()) / (corner.y() - eye.y());
  if (!(t > 0 && t < 1)) return false;
  const Vec3 at = eye + t * (corner - eye);
  return std::abs(at.x()) < 0.2 && at.z() < 0.7 + screen_height;
}

// Half as far from the middle as the vertices: farther from the rim than the grid's rays are apart.
std::vector<Vec3> inner_points(const Stage& stage, const std::string& name) {
  const Object& object = stage.at(name);
  const Vec3 centre = stage.box(name).centre();
  std::vector<Vec3> out;
  for (const Vec3& v : object.shape->mesh.vertices)
    out.emplace_back(0.5 * (centre + object.world_from_object().apply(v)));
  return out;
}

TEST(Sights, WhatIsToBeSeenIsNotHidden) {
  int num_behind = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    Stage stage = screen_stage(0.3);
    const ArrangeResult result = stage.run(seed);
    expect_true(stage, result);
    const Aabb box = stage.box("cup");
    for (const Vec3& point : inner_points(stage, "cup"))
      EXPECT_FALSE(is_behind_screen(point, Vec3(0, -1.2, 0.8), 0.3)) << seed;
    num_behind += box.centre().y() > 0 ? 1 : 0;
  }
  EXPECT_GT(num_behind, 0);  // beside the screen's shadow
}

TEST(Sights, WithoutTheRelationSomeAreHidden) {
  int num_hidden = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    Stage stage = screen_stage(0.3);
    stage.arrangement.relations.pop_back();
    expect_true(stage, stage.run(seed));
    num_hidden += is_behind_screen(stage.box("cup").centre(), Vec3(0, -1.2, 0.8), 0.3);
  }
  EXPECT_GT(num_hidden, 0);
}

// By the shadow of the board's middle plane on the cup's corners, without rays.
bool is_behind_board(const Aabb& board, const Vec3& corner, const Vec3& eye) {
  const double t = (board.centre().y() - eye.y()) / (corner.y() - eye.y());
  const Vec3 at = eye + t * (corner - eye);
  return t > 0 && t < 1 && at.x() > board.lower.x() && at.x() < board.upper.x() &&
         at.z() < board.upper.z();
}

TEST(Sights, LaterThingsDoNotStepIntoView) {
  int num_hidden_without = 0;
  for (const bool with_view : {true, false})
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
      Stage stage = screen_stage(0.02);
      if (!with_view) stage.arrangement.relations.pop_back();
      // As wide as the cup is far: without the relation it often stands before it.
      stage.add("board", box_between(Vec3(-0.25, -0.01, 0), Vec3(0.25, 0.01, 0.3)), {"", {}, {0}});
      stage.relate<relations::On>("board", "table");
      const ArrangeResult result = stage.run(seed);
      expect_true(stage, result);
      for (const Vec3& point : inner_points(stage, "cup")) {
        const bool hidden = is_behind_board(stage.box("board"), point, Vec3(0, -1.2, 0.8));
        EXPECT_FALSE(with_view && hidden) << seed;
        num_hidden_without += hidden && !with_view;
      }
    }
  EXPECT_GT(num_hidden_without, 0);
}

TEST(Sights, AreNamedInConflicts) {
  Stage stage = screen_stage(0.6);
  stage.fix("wall", box_between(Vec3(-2, -0.5, 0), Vec3(2, -0.45, 2)), Vec3(0, 0, 1e-5));
  const ArrangeResult result = stage.run();
  ASSERT_EQ(result.status, ArrangeResult::Status::Conflict);
  EXPECT_NE(result.reason().find("\"cup\" in view of its point"), std::string::npos)
      << result.reason();
  EXPECT_FALSE(stage.at("cup").placed);
}

// Lines of sight are looked at in few of tens of thousands of places, until a conflict is to be
// named: below a hole in a roof there are places that the few miss.
TEST(Sights, AreNamedOnlyWhereNoPlaceIsLeft) {
  Random random(11);
  for (int round = 0; round < 12; ++round) {
    const bool closed = round == 0;
    const Vec3 eye(random.uniform(-0.8, 0.8), random.uniform(-0.8, 0.8), 2);
    const double half = closed ? 0 : 0.0152;
    Stage stage;
    stage.fix("table", box_between(Vec3(-1, -1, 0), Vec3(1, 1, 0.7)), Vec3(0, 0, 1e-5));
    stage.fix("left", box_between(Vec3(-2, -2, 1.5), Vec3(eye.x() - half, 2, 1.51)));
    stage.fix("right", box_between(Vec3(eye.x() + half, -2, 1.5), Vec3(2, 2, 1.51)));
    stage.fix("front", box_between(Vec3(-2, -2, 1.52), Vec3(2, eye.y() - half, 1.53)));
    stage.fix("back", box_between(Vec3(-2, eye.y() + half, 1.52), Vec3(2, 2, 1.53)));
    stage.add_cube("cup", 0.05);
    stage.relate<relations::On>("cup", "table");
    Relation& view = stage.relate<relations::View>("cup");
    view.as<relations::View>()->eye = eye, view.as<relations::View>()->part = 1;
    Transaction transaction(stage.scene);
    World world(transaction, stage.arrangement, {});
    const Conflict conflict = find_conflict(world, 0, "");
    EXPECT_EQ(!conflict.relations.empty(), closed) << in_english(conflict.text);
  }
}

// Stopped when its only thing is looked for; the conflict is not named, which takes seconds.
TEST(Sights, StopWithTheirArrangement) {
  Stage stage = screen_stage(0.6);
  stage.fix("wall", box_between(Vec3(-2, -0.5, 0), Vec3(2, -0.45, 2)), Vec3(0, 0, 1e-5));
  const auto before = state_of(stage.scene);
  std::atomic<bool> cancel{false};
  const ArrangeResult result =
      arrange(stage.scene, stage.arrangement, {}, {nullptr, &cancel, 0},
              [&](const std::string&, std::size_t, std::size_t) { cancel = true; });
  EXPECT_EQ(result.status, ArrangeResult::Status::Cancelled) << result.reason();
  EXPECT_FALSE(result.conflict);
  EXPECT_EQ(state_of(stage.scene), before);
}

TEST(Sights, StopWhileTheirConflictIsNamed) {
  Stage stage = screen_stage(0.6);
  stage.fix("wall", box_between(Vec3(-2, -0.5, 0), Vec3(2, -0.45, 2)), Vec3(0, 0, 1e-5));
  Transaction transaction(stage.scene);
  std::atomic<bool> cancel{false};
  Interrupt interrupt({nullptr, &cancel, 0});
  World world(transaction, stage.arrangement, {{}, {}, &interrupt});
  const auto cup = static_cast<size_t>(world.thing_of("cup"));
  EXPECT_FALSE(find_conflict(world, cup, "").relations.empty());
  cancel = true;
  EXPECT_THROW(find_conflict(world, cup, ""), ArrangeStopped);
  EXPECT_THROW(Placer(world, cup, 1).candidates(Obstacles::All, {}, 1), ArrangeStopped);
}

TEST(Sights, MatchTrueVisibleShare) {
  Random random(5);
  int num_partly = 0;
  for (int round = 0; round < 60; ++round) {
    Stage stage;
    const double low = random.uniform(-0.35, 0.35);  // of the screen's left side
    stage.fix("target", box_between(Vec3(-0.5, 2, -0.5), Vec3(0.5, 2.1, 0.5)), Vec3(0, 0, 1));
    stage.fix("screen", box_between(Vec3(low, 1, -2), Vec3(3, 1.01, 2)), Vec3(0, 0, 1));
    stage.add_cube("far");
    stage.arrangement.things.front().object = "far";
    Transaction transaction(stage.scene);
    const World world(transaction, stage.arrangement, {});
    relations::View whole;
    whole.eye = Vec3(0, 0, 1);
    whole.part = 1;
    Relation view;
    view.kind = whole;
    view.a = "target";
    view.tolerance = 1;
    // From the eye the screen's side is at 2 low on the target's front; beyond it, its own side.
    const double seen = std::min(1.0, std::max(0.0, 0.5 + 2 * low));
    EXPECT_NEAR(1 - sight_cost({world, -1, {}, false}, view), seen, 1.0 / 8 + 1e-9) << low;
    num_partly += seen > 0.1 && seen < 0.9;
  }
  EXPECT_GT(num_partly, 15);
}

// A corner of a long wall is nearly abeam of one who looks at its middle.
TEST(Sights, MeetAWallWithACornerAbeam) {
  Random random(6);
  const Aabb wall{Vec3(-5, 0, -2), Vec3(5, 0.1, 2)};
  for (int round = 0; round < 200; ++round) {
    const double y = random.uniform(1, 2.2), abeam = (5 - std::sqrt(25 - 4 * y * y)) / 2;
    const Vec3 eye(abeam * (1 - random.uniform(1e-6, 0.02)), -y, 0);
    int num_met = 0;
    for (const Ray& ray : rays_to(eye, wall)) {
      const Vec3 at = ray.at(y / ray.direction.y());
      num_met += ray.direction.y() > 0 && std::abs(at.x()) < 5 && std::abs(at.z()) < 2;
    }
    EXPECT_GE(num_met, 2) << round;
  }
}

TEST(Reach, BoundsCostOfBlockedPoints) {
  Stage stage;
  stage.fix("phone", box_between(Vec3(-0.1, 2, 0), Vec3(0.1, 2.1, 0.1)), Vec3(0, 0, 1e-5));
  stage.fix("pane", box_between(Vec3(-9, 1, -1), Vec3(9, 1.01, 9)), Vec3::Zero());
  stage.add_cube("far");
  Transaction transaction(stage.scene);
  const World world(transaction, stage.arrangement, {});
  relations::Reach far;
  far.eye = Vec3(0, 0, 0.05);
  far.upper = 3;
  Relation reach;
  reach.kind = far;
  reach.a = "phone";
  reach.tolerance = 0.01;
  EXPECT_EQ(sight_cost({world, -1, {}, false}, reach), relations::kMostSightCost);
}

// Windows come from outlines, costs from rays: one eye for both, however b lies.
TEST(Sights, WindowsHideNoPlaceThatRaysLeave) {
  Random random(8);
  int num_reached = 0, num_under = 0;
  const Triangles angle = joined(box_between(Vec3(0, 0, 0), Vec3(0.5, 0.1, 0.1)),
                                 box_between(Vec3(0, 0, 0.1), Vec3(0.1, 0.3, 0.4)));
  for (int round = 0; round < 60; ++round) {
    Stage stage;
    stage.scene.add(object_of("b", angle));
    stage.add_cube("a", 0.2);
    Transaction transaction(stage.scene);
    transaction.edit(*stage.scene.find("b"), [&](Object& object) {
      object.placed = true;
      object.pose = {random.rotation(), Vec3(0, 0, 1.5)};
    });
    Relation& reach = stage.relate<relations::Reach>("a", "b");
    reach.as<relations::Reach>()->eye_height = -0.5, reach.as<relations::Reach>()->upper = 0.7,
    reach.tolerance = 0.01;
    stage.relate<relations::Under>("a", "b").tolerance = 0.01;
    const World world(transaction, stage.arrangement, {});
    const Outline moving = world.outline(world.things().front(), Pose{}), b = world.outline("b");
    for (int k = 0; k < 40; ++k) {
      const Vec2 at = random.in_cube(0.9).head<2>();
      for (const Relation& r : world.arrangement().relations) {
        if (sight_cost({world, 0, {{}, Vec3(at.x(), at.y(), 0.4)}}, r) > 0.5) continue;
        ++(r.as<relations::Under>() ? num_under : num_reached);
        for (const HalfPlane& h : half_planes(r, moving, &b, true))
          EXPECT_LE(h.normal.dot(at), h.bound + 1e-9) << in_english(r.text());
      }
    }
  }
  EXPECT_GT(num_reached, 200);
  EXPECT_GT(num_under, 50);
}

TEST(Reach, IsAnArmsLengthThatNothingCutsOff) {
  for (const bool with_wall : {false, true}) {
    Stage stage;
    stage.fix("desk", box_between(Vec3(-0.8, -0.4, 0), Vec3(0.8, 0.4, 0.7)), Vec3(0, 0, 1e-5));
    stage.fix("chair", box_between(Vec3(-0.2, -0.2, 0), Vec3(0.2, 0.2, 0.45)), Vec3(0, -0.7, 1e-5));
    if (with_wall)
      stage.fix("pane", box_between(Vec3(-2, -0.005, 0), Vec3(2, 0.005, 2)), Vec3(0, -0.45, 1e-5));
    stage.add_cube("phone", 0.1);
    stage.relate<relations::On>("phone", "desk");
    Relation& reach = stage.relate<relations::Reach>("phone", "chair");
    reach.as<relations::Reach>()->eye_height = 1.0, reach.as<relations::Reach>()->upper = 0.7,
    reach.tolerance = 0.01;
    for (const std::uint64_t seed : {1, 2, 3, 4}) {
      const ArrangeResult result = stage.run(seed);
      if (with_wall) {
        ASSERT_EQ(result.status, ArrangeResult::Status::Conflict);
        EXPECT_NE(result.reason().find("in reach of \"chair\""), std::string::npos)
            << result.reason();
        continue;
      }
      expect_true(stage, result);
      const Aabb box = stage.box("phone");
      const Vec3 shoulder(0, -0.7, 1.00001);
      const Vec3 nearest = shoulder.cwiseMax(box.lower).cwiseMin(box.upper);
      EXPECT_LE((nearest - shoulder).norm(), 0.71);
    }
  }
}

}  // namespace
}  // namespace trivet::test
