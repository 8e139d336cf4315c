// Edges, what is under something, how well things stand; each with a judge of its own.
#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "ops/arrange/arrange_testing.h"

namespace trivet::test {
namespace {

TEST(Under, StandsBelowTheTop) {
  Triangles desk = box_between(Vec3(-0.6, -0.4, 0.7), Vec3(0.6, 0.4, 0.73));
  for (const double x : {-0.58, 0.58})
    desk = joined(desk, box_between(Vec3(x - 0.02, -0.4, 0), Vec3(x + 0.02, 0.4, 0.7)));
  for (const double height : {0.4, 0.8}) {
    Stage stage;
    stage.fix("desk", desk, Vec3(1, 0.5, 1e-5));
    stage.add("basket", box_between(Vec3(-0.15, -0.15, 0), Vec3(0.15, 0.15, height)));
    stage.relate<relations::Under>("basket", "desk").as<relations::Under>()->part = 0.9;
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
    stage.relate<relations::On>("clock", "table");
    Relation& edge = stage.relate<relations::AtEdge>("clock", "table");
    edge.as<relations::AtEdge>()->lower = 0.02, edge.as<relations::AtEdge>()->upper = 0.03;
    if (!any) edge.as<relations::AtEdge>()->side = Side::Left;
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
      stage.relate<relations::On>("tray", "post");
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

// Metres that the common centre of these is inside the post's edge.
double inside_post(const Stage& stage, const std::vector<std::string>& names) {
  Vec3 moment = Vec3::Zero();
  double volume = 0;
  for (const std::string& name : names) {
    const Vec3 size = stage.box(name).upper - stage.box(name).lower;
    moment += size.prod() * stage.box(name).centre();
    volume += size.prod();
  }
  return 0.1 - (moment / volume).head<2>().cwiseAbs().maxCoeff();
}

Stage tray_on_post() {
  Stage stage;
  stage.fix("post", box_between(Vec3(-0.1, -0.1, 0), Vec3(0.1, 0.1, 0.5)), Vec3(0, 0, 1e-5));
  stage.add("tray", box_between(Vec3(-0.15, -0.15, 0), Vec3(0.15, 0.15, 0.01)), {"", {}, {0}});
  stage.relate<relations::On>("tray", "post");
  stage.relate<relations::At>("tray").as<relations::At>()->point = Vec2(0, 0);
  return stage;
}

TEST(Steadiness, CountsWithWhatComesToLieOnIt) {
  double least = kInfinity;
  for (const double margin : {0.0, 0.07})
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
      Stage stage = tray_on_post();
      stage.add("board", box_between(Vec3(-0.1, -0.1, 0), Vec3(0.1, 0.1, 0.01)), {"", {}, {0}});
      stage.relate<relations::On>("board", "tray");
      stage.relate<relations::Centred>("board", "tray").tolerance = 1e-3;
      stage.add("load", box_between(Vec3(-0.05, -0.05, 0), Vec3(0.05, 0.05, 0.1)), {"", {}, {0}});
      stage.relate<relations::On>("load", "board");
      if (margin > 0) stage.arrangement.steadiness.push_back({{"tray"}, margin, kInfinity});
      expect_true(stage, stage.run(seed));
      const double here = inside_post(stage, {"tray", "board", "load"});
      if (margin > 0) {
        EXPECT_GE(here, margin - 1e-5) << seed;
      } else {
        least = std::min(least, here);
      }
    }
  EXPECT_LT(least, 0.07);  // without the condition it is nearer
}

TEST(Steadiness, JudgesAPatternWhenAllOfItStands) {
  Stage stage = tray_on_post();
  Pattern row;
  row.on = "tray";
  row.gap = 0.01;
  row.align = Pattern::Align::Spread;
  for (const char* const name : {"left", "right"}) {
    stage.add_cube(name, 0.06);
    row.things.push_back(name);
  }
  stage.arrangement.patterns = {row};
  stage.arrangement.steadiness.push_back({{"tray"}, 0.09, kInfinity});
  expect_true(stage, stage.run());
  EXPECT_GE(inside_post(stage, {"tray", "left", "right"}), 0.09);
  EXPECT_LT(inside_post(stage, {"tray", "left"}), 0.09);
}

}  // namespace
}  // namespace trivet::test
