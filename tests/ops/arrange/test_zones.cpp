// Space that is kept free beside objects: puzzles, and a judge of its own.
#include "ops/arrange/arrange_testing.h"
#include "ops/arrange/convex_region.h"
#include "ops/arrange/zones.h"
#include "support/random_shapes.h"

namespace trivet::test {
namespace {

// A desk against a wall; only a strip before it is left, as deep as the chair and a bit.
Stage desk_stage() {
  Stage stage;
  stage.fix("desk", box_between(Vec3(-0.6, -0.3, 0), Vec3(0.6, 0.3, 0.7)), Vec3(0, 0, 1e-5));
  stage.add("chair", box_between(Vec3(-0.2, -0.2, 0), Vec3(0.2, 0.2, 0.9)), {"", {}, {0}});
  stage.relate<relations::InFrontOf>("chair", "desk").as<relations::InFrontOf>()->upper = 0.1;
  stage.arrangement.relations.back().as<relations::InFrontOf>()->overlap = 1;
  return stage;
}

void add_drawers(Stage& stage, double left) {
  stage.arrangement.zones.push_back(
      {"desk", "drawers", Vec3(left, -0.9, 0.1), Vec3(0.6, -0.3, 0.6)});
}

TEST(Zones, ChairStandsBesideTheDrawers) {
  Stage stage = desk_stage();
  add_drawers(stage, 0.1);
  expect_true(stage, stage.run());
  EXPECT_LT(stage.box("chair").upper.x(), 0.1 + kZoneSlack);
}

TEST(Zones, ChairThatNeedsTheDrawersPlaceIsAConflict) {
  Stage stage = desk_stage();
  add_drawers(stage, -0.3);  // 0.3 m are left beside them, 0.4 are needed
  const Scene before = stage.scene;
  const ArrangeResult result = stage.run();
  ASSERT_EQ(result.status, ArrangeResult::Status::Conflict);
  EXPECT_EQ(result.conflict->thing, "chair");
  const std::vector<std::string> both{"\"chair\" in_front_of \"desk\"",
                                      "out of the zone \"drawers\" of \"desk\""};
  EXPECT_EQ(in_english(result.conflict->constraints), both) << result.reason();
  EXPECT_EQ(result.conflict->objects, std::vector<std::string>{"desk"});
  EXPECT_FALSE(stage.at("chair").placed);
}

TEST(Zones, ThingsNeedTheirOwn) {
  for (const bool with_post : {false, true}) {
    Stage stage = desk_stage();
    add_drawers(stage, 0.1);
    // Legs go to either side, over the drawers' zone, too: zones may overlap.
    stage.arrangement.zones.push_back(
        {"chair", "legs", Vec3(-0.4, -0.6, 0.1), Vec3(0.4, -0.2, 0.5)});
    if (with_post)
      stage.fix("post", box_between(Vec3(-0.8, -0.05, 0), Vec3(0.8, 0.05, 0.3)),
                Vec3(0, -0.95, 1e-5));
    const ArrangeResult result = stage.run();
    if (!with_post) {
      expect_true(stage, result);
      continue;
    }
    ASSERT_EQ(result.status, ArrangeResult::Status::Conflict);
    EXPECT_NE(result.reason().find("zone \"legs\" of \"chair\" clear of \"post\""),
              std::string::npos)
        << result.reason();
  }
}

TEST(Zones, OthersGiveWayForThem) {
  Stage stage;
  stage.add("cupboard", box_between(Vec3(-0.3, -0.2, 0), Vec3(0.3, 0.2, 1.8)), {"", {}, {0}});
  stage.add("box", box_between(Vec3(-0.35, -0.3, 0), Vec3(0.35, 0.3, 0.4)), {"", {}, {0}});
  // The box is larger and comes first, wherever it likes; before the cupboard's doors is a wall, or
  // 0.7 m to the box.
  const std::vector<Vec2> room{{-0.4, -1}, {0.4, -1}, {0.4, 1}, {-0.4, 1}};
  stage.fix("wall", box_between(Vec3(-0.5, -1.1, 0), Vec3(0.5, -1.001, 2)), Vec3(0, 0, 1e-5));
  for (const char* name : {"cupboard", "box"})
    stage.relate<relations::Within>(name).as<relations::Within>()->region = room;
  stage.arrangement.zones.push_back(
      {"cupboard", "doors", Vec3(-0.3, -0.9, 0.05), Vec3(0.3, -0.2, 1.7)});
  int num_evictions = 0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    Stage again = stage;
    const ArrangeResult result = again.run(seed);
    expect_true(again, result);
    num_evictions += result.num_evictions;
  }
  EXPECT_GT(num_evictions, 0);
}

TEST(Zones, MayHoldWhatCarriesTheObject) {
  Stage stage;
  stage.fix("table", box_between(Vec3(-0.5, -0.4, 0), Vec3(0.5, 0.4, 0.7)), Vec3(0, 0, 1e-5));
  stage.add_cube("lamp", 0.2);
  stage.relate<relations::On>("lamp", "table");
  stage.arrangement.zones.push_back({"lamp", "light", Vec3(-0.2, -0.2, -0.3), Vec3(0.2, 0.2, 0)});
  expect_true(stage, stage.run());
}

// Upright boxes turned about z: in a zone when the rectangles and the heights overlap.
bool is_in(const Stage& stage, const std::string& name, const Zone& zone) {
  const auto corners = [](const Object& object, const Vec3& lower, const Vec3& upper) {
    std::vector<Vec2> out;
    for (const Vec2& p : {Vec2(lower.x(), lower.y()), Vec2(upper.x(), lower.y()),
                          Vec2(upper.x(), upper.y()), Vec2(lower.x(), upper.y())})
      out.push_back(object.world_from_object().apply(Vec3(p.x(), p.y(), lower.z())).head<2>());
    return out;
  };
  const Object& owner = stage.at(zone.object);
  const Object& other = stage.at(name);
  const Aabb box = other.shape->box;
  const double low = owner.pose.translation.z();
  if (stage.box(name).lower.z() >= low + zone.upper.z() - 2 * kZoneSlack) return false;
  if (stage.box(name).upper.z() <= low + zone.lower.z() + 2 * kZoneSlack) return false;
  const Vec3 slack = Vec3::Constant(2 * kZoneSlack);
  return distance(corners(owner, zone.lower + slack, zone.upper - slack),
                  corners(other, box.lower, box.upper)) == 0;
}

TEST(Zones, AreFreeByAJudgeOfItsOwn) {
  Random random(17);
  int num_done = 0, num_judged = 0, num_evictions = 0;
  for (int round = 0; round < 12; ++round) {
    Stage stage;
    const std::vector<Vec2> room{{-0.55, -0.5}, {0.55, -0.5}, {0.55, 0.5}, {-0.55, 0.5}};
    for (int i = 0; i < 6; ++i) {
      const std::string name = "box_" + std::to_string(i);
      const Vec3 half(random.uniform(0.05, 0.12), random.uniform(0.05, 0.12), 0);
      const double high = random.uniform(0.1, 0.3);
      stage.add(name, box_between(-half, Vec3(half.x(), half.y(), high)), {"", {}, {0, 30, 90}});
      stage.relate<relations::Within>(name).as<relations::Within>()->region = room;
      if (i % 2 == 0)
        stage.arrangement.zones.push_back(
            {name, "front", Vec3(-half.x(), -half.y() - random.uniform(0.1, 0.25), 0.02),
             Vec3(half.x(), -half.y(), random.uniform(0.03, 0.3))});
    }
    const ArrangeResult result = stage.run(static_cast<std::uint64_t>(round));
    num_evictions += result.num_evictions;
    if (!result.ok()) continue;
    ++num_done;
    expect_true(stage, result);
    for (const Zone& zone : stage.arrangement.zones)
      for (const Thing& thing : stage.arrangement.things) {
        if (thing.object == zone.object) continue;
        EXPECT_FALSE(is_in(stage, thing.object, zone)) << round << " " << thing.object;
        ++num_judged;
      }
  }
  EXPECT_GE(num_done, 10);
  EXPECT_GT(num_judged, 100);
}

}  // namespace
}  // namespace trivet::test
