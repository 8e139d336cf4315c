// Poses, turns and soft relations among which arrangements choose.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "ops/arrange/arrange_testing.h"

namespace trivet::test {
namespace {

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

// One object alone, where there is room: on several supports, at any angle, with conditions.
TEST(Things, AreFoundAPlaceAmongWhatLiesInATray) {
  Stage stage;
  stage.fix("tray", test::tray(0.4, 0.3), Vec3(0, 0, 1e-5));
  for (const char* name : {"brick_1", "brick_2"}) {
    stage.add(name, test::box_between(Vec3(-0.08, -0.05, 0), Vec3(0.08, 0.05, 0.06)));
    stage.relate<relations::In>(name, "tray");
  }
  expect_true(stage, stage.run());
  const Vec3 before = stage.box("brick_1").centre();
  stage.arrangement = {};
  stage.add_cube("cup", 0.08);
  stage.arrangement.things.front().any_yaw = true;
  stage.relate<relations::In>("cup", "tray");
  stage.arrangement.keeps.push_back({{"cup"}, 0.02, {{"cup", "tray"}}});
  stage.arrangement.steadiness.push_back({{"cup"}, 0.02, 0.4});
  for (const std::uint64_t seed : {1, 2, 3}) {
    expect_true(stage, stage.run(seed));
    EXPECT_GT(stage.at("cup").stability_margin, 0.02);
    EXPECT_LT(stage.at("cup").least_friction, 0.4);
    EXPECT_LT(std::abs(stage.box("cup").centre().x()), 0.2);
    EXPECT_LT(std::abs(stage.box("cup").centre().y()), 0.15);
    EXPECT_EQ(stage.box("brick_1").centre(), before);
  }
}

TEST(Relations, PerpendicularTurnsByAQuarter) {
  Stage stage;
  stage.fix("desk", box_between(Vec3(-0.5, -0.3, 0), Vec3(0.5, 0.3, 0.7)), Vec3(0, 0, 1e-5));
  stage.add("rack", box_between(Vec3(-0.4, -0.1, 0), Vec3(0.4, 0.1, 0.5)));
  stage.relate<relations::Perpendicular>("rack", "desk").tolerance = 2;
  stage.relate<relations::Near>("rack", "desk").as<relations::Near>()->upper = 0.5;
  expect_true(stage, stage.run());
  EXPECT_LT(std::abs(stage.at("rack").pose.rotation.matrix()(1, 1)), 0.04);
}

// Places are sampled by their cost; afterwards each thing has its own.
TEST(Improve, LowersSoftCostsAndNeverRaisesThem) {
  double before = 0, after = 0;
  int num_improved = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    double costs[2] = {};
    for (const int most : {0, 12}) {
      Stage stage;
      stage.fix("table", box_between(Vec3(-0.5, -0.4, 0), Vec3(0.5, 0.4, 0.7)), Vec3(0, 0, 1e-5));
      for (int i = 0; i < 6; ++i) {
        const std::string name = "cube_" + std::to_string(i);
        stage.add_cube(name, 0.05 + 0.01 * i);
        stage.relate<relations::On>(name, "table");
        Relation& at = stage.relate<relations::At>(name);
        at.as<relations::At>()->point = Vec2(-0.25 + 0.25 * (i % 3), i < 3 ? -0.15 : 0.15);
        at.tolerance = 0.05, at.weight = 1;
      }
      stage.arrangement.max_improvements = most;
      const ArrangeResult result = stage.run(seed);
      expect_true(stage, result);
      for (const ArrangeResult::Holds& r : result.relations)
        costs[most ? 1 : 0] += r.hard ? 0 : r.cost * r.cost;
      num_improved += result.num_improvements;
    }
    EXPECT_LE(costs[1], costs[0]) << seed;
    before += costs[0], after += costs[1];
  }
  EXPECT_GT(num_improved, 0);
  EXPECT_LT(after, 0.5 * before);
}

TEST(Conflict, OffersTheCheapestWishToDrop) {
  Stage stage;
  stage.add_cube("jug");
  stage.relate<relations::At>("jug").as<relations::At>()->point = Vec2(0, 0);
  stage.add_cube("cup");
  Relation& near = stage.relate<relations::Near>("cup", "jug");
  near.as<relations::Near>()->upper = 0.5;
  stage.relate<relations::At>("cup").as<relations::At>()->point = Vec2(0.7, 0);
  stage.arrangement.max_attempts = 1;
  const ArrangeResult result = stage.run();
  ASSERT_EQ(result.status, ArrangeResult::Status::Conflict);
  ASSERT_TRUE(result.conflict->cheapest);
  // Without it there is a place.
  auto& relations = stage.arrangement.relations;
  relations.erase(relations.begin() + static_cast<std::ptrdiff_t>(*result.conflict->cheapest));
  expect_true(stage, stage.run());
}

// A plate is held by its knife and its spoon, which stand by it: alone it moves by half a
// centimetre, with them to where it is to be.
TEST(Improve, MovesThingsWithThoseThatStandByThem) {
  double before = 0, after = 0;
  int num_there = 0;
  constexpr int kSeeds = 8;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    for (const int most : {0, 12}) {
      Stage stage;
      stage.fix("table", box_between(Vec3(-0.5, -0.4, 0), Vec3(0.5, 0.4, 0.7)), Vec3(0, 0, 1e-5));
      stage.add("plate", box_between(Vec3(-0.1, -0.1, 0), Vec3(0.1, 0.1, 0.02)), {"", {}, {0}});
      stage.add("knife", box_between(Vec3(-0.01, -0.1, 0), Vec3(0.01, 0.1, 0.01)), {"", {}, {0}});
      stage.add("spoon", box_between(Vec3(-0.01, -0.08, 0), Vec3(0.01, 0.08, 0.01)), {"", {}, {0}});
      for (const char* name : {"plate", "knife", "spoon"})
        stage.relate<relations::On>(name, "table");
      Relation& at = stage.relate<relations::At>("plate");
      at.as<relations::At>()->point = Vec2(0.1, -0.1);
      at.tolerance = 0.2, at.weight = 1;
      const auto beside = [&](const char* name, const char* other) {
        Relation& right = stage.relate<relations::RightOf>(name, other);
        right.as<relations::RightOf>()->lower = 0.005, right.as<relations::RightOf>()->upper = 0.01;
        Relation& level = stage.relate<relations::Centred>(name, other);
        level.as<relations::Centred>()->along.x = false, level.tolerance = 0.003;
      };
      beside("knife", "plate");
      beside("spoon", "knife");
      stage.arrangement.max_improvements = most;
      const ArrangeResult result = stage.run(seed);
      expect_true(stage, result);
      const Vec3 plate = stage.box("plate").centre();
      const double off = (plate.head<2>() - Vec2(0.1, -0.1)).norm();
      (most == 0 ? before : after) += off;
      if (most > 0 && off < 0.01) ++num_there;
    }
  }
  EXPECT_GT(before / kSeeds, 0.02);
  EXPECT_LT(after, 0.5 * before);
  EXPECT_GE(num_there, kSeeds - 2);
}

}  // namespace
}  // namespace trivet::test
