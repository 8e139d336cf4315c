// Lines of sight and of reach, edges, what is under something, how well things stand; each with a
// judge of its own.
#include <cmath>

#include "ops/arrange/arrange_testing.h"
#include "ops/arrange/sights.h"
#include "ops/arrange/stable_poses.h"
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
  stage.relate("cup", RelationKind::On, "table");
  Relation& view = stage.relate("cup", RelationKind::View);
  view.eye = Vec3(0, -1.2, 0.8);
  view.overlap = 1;
  return stage;
}

// By the shadow of the screen on the plane of the cup's corners, without rays.
bool is_behind_screen(const Vec3& corner, const Vec3& eye, double screen_height) {
  const double t = (-0.01 - eye.y()) / (corner.y() - eye.y());
  if (!(t > 0 && t < 1)) return false;
  const Vec3 at = eye + t * (corner - eye);
  return std::abs(at.x()) < 0.2 && at.z() < 0.7 + screen_height;
}

TEST(Sights, WhatIsToBeSeenIsNotHidden) {
  int num_behind = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    Stage stage = screen_stage(0.3);
    const ArrangeResult result = stage.run(seed);
    expect_true(stage, result);
    const Aabb box = stage.box("cup");
    EXPECT_FALSE(is_behind_screen(box.centre(), Vec3(0, -1.2, 0.8), 0.3)) << seed;
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

TEST(Sights, LaterThingsDoNotStepIntoView) {
  int num_done = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    Stage stage = screen_stage(0.02);
    // As wide as the cup is far: without the relation it would often stand before it.
    stage.add("board", box_between(Vec3(-0.25, -0.01, 0), Vec3(0.25, 0.01, 0.3)), {"", {}, {0}});
    stage.relate("board", RelationKind::On, "table");
    const ArrangeResult result = stage.run(seed);
    ASSERT_TRUE(result.ok()) << result.reason();
    expect_true(stage, result);
    const Aabb board = stage.box("board");
    const Vec3 eye(0, -1.2, 0.8), cup = stage.box("cup").centre();
    const double t = (board.centre().y() - eye.y()) / (cup.y() - eye.y());
    const Vec3 at = eye + t * (cup - eye);
    EXPECT_FALSE(t < 1 && at.x() > board.lower.x() && at.x() < board.upper.x()) << seed;
    ++num_done;
  }
  EXPECT_EQ(num_done, 6);
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

TEST(Sights, ShareThatIsSeenIsThatOfTheTruth) {
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
    Relation view;
    view.kind = RelationKind::View;
    view.a = "target";
    view.eye = Vec3(0, 0, 1);
    view.overlap = 1, view.tolerance = 1;
    // From the eye the screen's side is at 2 low on the target's front; beyond it, its own side.
    const double seen = std::min(1.0, std::max(0.0, 0.5 + 2 * low));
    EXPECT_NEAR(1 - sight_cost({world, -1, {}, false}, view), seen, 1.0 / 8 + 1e-9) << low;
    num_partly += seen > 0.1 && seen < 0.9;
  }
  EXPECT_GT(num_partly, 15);
}

TEST(Reach, IsAnArmsLengthThatNothingCutsOff) {
  for (const bool with_wall : {false, true}) {
    Stage stage;
    stage.fix("desk", box_between(Vec3(-0.8, -0.4, 0), Vec3(0.8, 0.4, 0.7)), Vec3(0, 0, 1e-5));
    stage.fix("chair", box_between(Vec3(-0.2, -0.2, 0), Vec3(0.2, 0.2, 0.45)), Vec3(0, -0.7, 1e-5));
    if (with_wall)
      stage.fix("pane", box_between(Vec3(-2, -0.005, 0), Vec3(2, 0.005, 2)), Vec3(0, -0.45, 1e-5));
    stage.add_cube("phone", 0.1);
    stage.relate("phone", RelationKind::On, "desk");
    Relation& reach = stage.relate("phone", RelationKind::Reach, "chair");
    reach.eye_height = 1.0, reach.upper = 0.7, reach.tolerance = 0.01;
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

TEST(Under, StandsBelowTheTop) {
  Triangles desk = box_between(Vec3(-0.6, -0.4, 0.7), Vec3(0.6, 0.4, 0.73));
  for (const double x : {-0.58, 0.58})
    desk = joined(desk, box_between(Vec3(x - 0.02, -0.4, 0), Vec3(x + 0.02, 0.4, 0.7)));
  for (const double height : {0.4, 0.8}) {
    Stage stage;
    stage.fix("desk", desk, Vec3(1, 0.5, 1e-5));
    stage.add("basket", box_between(Vec3(-0.15, -0.15, 0), Vec3(0.15, 0.15, height)));
    stage.relate("basket", RelationKind::Under, "desk").overlap = 0.9;
    const ArrangeResult result = stage.run();
    if (height > 0.7) {
      EXPECT_EQ(result.status, ArrangeResult::Status::Conflict);
      continue;
    }
    expect_true(stage, result);
    const Aabb box = stage.box("basket");
    const double inside = std::min(box.upper.y(), 0.9) - std::max(box.lower.y(), 0.1);
    EXPECT_GE(inside, 0.75 * (box.upper.y() - box.lower.y()));  // a grid of 8 x 8
    EXPECT_GT(box.lower.x(), 0.4);
    EXPECT_LT(box.upper.x(), 1.6);
  }
}

TEST(AtEdge, IsThatFarInside) {
  for (const bool any : {false, true}) {
    Stage stage;
    stage.fix("table", box_between(Vec3(-0.5, -0.4, 0), Vec3(0.5, 0.4, 0.7)), Vec3(0, 0, 1e-5));
    stage.add_cube("clock");
    stage.relate("clock", RelationKind::On, "table");
    Relation& edge = stage.relate("clock", RelationKind::AtEdge, "table");
    edge.lower = 0.02, edge.upper = 0.03;
    if (!any) edge.side = Side::Left;
    for (const std::uint64_t seed : {1, 2, 3}) {
      expect_true(stage, stage.run(seed));
      const Aabb box = stage.box("clock");
      const double left = box.lower.x() + 0.5, right = 0.5 - box.upper.x();
      const double front = box.lower.y() + 0.4, back = 0.4 - box.upper.y();
      const double gap = any ? std::min({left, right, front, back}) : left;
      EXPECT_GE(gap, 0.02 - 1.1e-3);
      EXPECT_LE(gap, 0.03 + 1.1e-3);
    }
  }
}

TEST(Steadiness, KeepsTheCentreOfMassOffTheEdge) {
  double least = kInfinity;
  for (const double margin : {0.0, 0.03}) {
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
      Stage stage;
      stage.fix("post", box_between(Vec3(-0.1, -0.1, 0), Vec3(0.1, 0.1, 0.5)), Vec3(0, 0, 1e-5));
      stage.add("tray", box_between(Vec3(-0.15, -0.15, 0), Vec3(0.15, 0.15, 0.02)), {"", {}, {0}});
      stage.relate("tray", RelationKind::On, "post");
      if (margin > 0) stage.arrangement.steadiness.push_back({{"tray"}, margin, kInfinity});
      const ArrangeResult result = stage.run(seed);
      expect_true(stage, result);
      const Vec3 centre = stage.box("tray").centre();
      // It tips over the post's edge that its centre is nearest to.
      const double here = 0.1 - std::max(std::abs(centre.x()), std::abs(centre.y()));
      EXPECT_GE(here, margin > 0 ? margin - 1e-6 : -kInfinity);
      if (margin == 0) least = std::min(least, here);
    }
  }
  EXPECT_LT(least, 0.03);  // without the condition it is nearer
}

TEST(Steadiness, CountsWithWhatComesToLieOnIt) {
  int num_refused = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    Stage stage;
    stage.fix("post", box_between(Vec3(-0.1, -0.1, 0), Vec3(0.1, 0.1, 0.5)), Vec3(0, 0, 1e-5));
    stage.add("tray", box_between(Vec3(-0.15, -0.15, 0), Vec3(0.15, 0.15, 0.01)), {"", {}, {0}});
    stage.relate("tray", RelationKind::On, "post");
    stage.relate("tray", RelationKind::At).point = Vec2(0, 0);
    stage.add_cube("load", 0.1);
    stage.relate("load", RelationKind::On, "tray");
    stage.arrangement.steadiness.push_back({{"tray"}, 0.08, kInfinity});
    const ArrangeResult result = stage.run(seed);
    expect_true(stage, result);
    EXPECT_GE(stage.at("tray").stability_margin, 0.08);
    num_refused += result.num_refused;
  }
  EXPECT_GT(num_refused, 0);
}

TEST(Patterns, ThingsStandAlongALine) {
  Stage stage;
  Pattern along;
  along.kind = Pattern::Kind::Along;
  along.on = "floor";
  along.line = {Vec2(0, 0), Vec2(1, 0), Vec2(1, 1)};
  along.front = Pattern::Front::Onwards;
  for (int i = 0; i < 5; ++i) {
    stage.add_cube("post_" + std::to_string(i));
    along.things.push_back("post_" + std::to_string(i));
  }
  stage.arrangement.patterns = {along};
  expect_true(stage, stage.run());
  const Vec2 wanted[] = {{0, 0}, {0.5, 0}, {1, 0}, {1, 0.5}, {1, 1}};
  for (int i = 0; i < 5; ++i) {
    const std::string name = "post_" + std::to_string(i);
    EXPECT_LT((stage.box(name).centre().head<2>() - wanted[i]).norm(), 1e-3);
    const Vec3 front = -stage.at(name).pose.rotation.matrix().col(1);
    EXPECT_GT(i < 3 ? front.x() : front.y(), 0.999) << i;
  }
  stage.arrangement.patterns.front().spacing = 0.51;
  const ArrangeResult result = stage.run();
  ASSERT_EQ(result.status, ArrangeResult::Status::Conflict);
  EXPECT_NEAR(result.conflict->missing.value(), 0.04, 1e-9);
}

TEST(Things, LieOnTheirSideAndTurnAtWill) {
  std::vector<double> yaws;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    Stage stage;
    stage.add("bottle", box_between(Vec3(-0.04, -0.05, 0), Vec3(0.04, 0.05, 0.25)),
              {"", {PoseChoice::Kind::Side}, {}, true});
    expect_true(stage, stage.run(seed));
    EXPECT_LT(stage.box("bottle").upper.z(), 0.11);
    const Vec3 up = stage.at("bottle").pose.rotation.matrix().col(2);
    yaws.push_back(std::fmod(std::atan2(up.y(), up.x()) * 180 / M_PI + 360, 22.5));
  }
  std::sort(yaws.begin(), yaws.end());
  EXPECT_GT(yaws.back() - yaws.front(), 1);  // not of one grid of angles
}

TEST(Relations, PerpendicularTurnsByAQuarter) {
  Stage stage;
  stage.fix("desk", box_between(Vec3(-0.5, -0.3, 0), Vec3(0.5, 0.3, 0.7)), Vec3(0, 0, 1e-5));
  stage.add("rack", box_between(Vec3(-0.4, -0.1, 0), Vec3(0.4, 0.1, 0.5)));
  stage.relate("rack", RelationKind::Perpendicular, "desk").tolerance = 2;
  stage.relate("rack", RelationKind::Near, "desk").upper = 0.5;
  expect_true(stage, stage.run());
  EXPECT_LT(std::abs(stage.at("rack").pose.rotation.matrix()(1, 1)), 0.04);
}

// Places are sampled by their cost; afterwards each thing has its own.
TEST(Improve, LowersSoftCostsAndNeverRaisesThem) {
  double before = 0, after = 0;
  int num_improved = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed)
    for (const int most : {0, 12}) {
      Stage stage;
      stage.fix("table", box_between(Vec3(-0.5, -0.4, 0), Vec3(0.5, 0.4, 0.7)), Vec3(0, 0, 1e-5));
      for (int i = 0; i < 6; ++i) {
        const std::string name = "cube_" + std::to_string(i);
        stage.add_cube(name, 0.05 + 0.01 * i);
        stage.relate(name, RelationKind::On, "table");
        Relation& at = stage.relate(name, RelationKind::At);
        at.point = Vec2(-0.25 + 0.25 * (i % 3), i < 3 ? -0.15 : 0.15);
        at.tolerance = 0.05, at.weight = 1;
      }
      stage.arrangement.max_improvements = most;
      const ArrangeResult result = stage.run(seed);
      expect_true(stage, result);
      double cost = 0;
      for (const ArrangeResult::Holds& r : result.relations) cost += r.hard ? 0 : r.cost * r.cost;
      (most ? after : before) += cost;
      num_improved += result.num_improvements;
    }
  EXPECT_GT(num_improved, 0);
  EXPECT_LT(after, 0.5 * before);
}

TEST(Conflict, OffersTheCheapestWishToDrop) {
  Stage stage;
  stage.add_cube("jug");
  stage.relate("jug", RelationKind::At).point = Vec2(0, 0);
  stage.add_cube("cup");
  Relation& near = stage.relate("cup", RelationKind::Near, "jug");
  near.upper = 0.5;
  stage.relate("cup", RelationKind::At).point = Vec2(0.7, 0);
  stage.arrangement.max_attempts = 1;
  const ArrangeResult result = stage.run();
  ASSERT_EQ(result.status, ArrangeResult::Status::Conflict);
  ASSERT_TRUE(result.conflict->cheapest);
  // Without it there is a place.
  auto& relations = stage.arrangement.relations;
  relations.erase(relations.begin() + static_cast<std::ptrdiff_t>(*result.conflict->cheapest));
  expect_true(stage, stage.run());
}

}  // namespace
}  // namespace trivet::test
