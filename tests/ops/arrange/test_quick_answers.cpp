// Answers that are found sooner than by looking at everything, beside those that do.
#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "ops/arrange/arrange_testing.h"
#include "ops/arrange/conflict_search.h"
#include "ops/arrange/place_field.h"
#include "ops/arrange/place_order.h"
#include "ops/arrange/sights.h"
#include "ops/detect/detector.h"
#include "support/random_shapes.h"

namespace trivet::test {
namespace {

// Places that are left alone are judged as all are, whatever the order.
TEST(PlaceField, JudgesPlacesThatAreLeftAsItJudgesAll) {
  Random random(21);
  int num_fitting = 0, num_others = 0;
  for (int round = 0; round < 12; ++round) {
    Stage stage;
    stage.fix("table", box_between(Vec3(-0.5, -0.4, 0), Vec3(0.5, 0.4, 0.7)), Vec3(0, 0, 1e-5));
    std::vector<ObjectId> posts;
    for (int i = 0; i < 5; ++i) {
      const std::string name = "post_" + std::to_string(i);
      const double height = random.uniform(0.05, 0.3);
      stage.fix(name, box_between(Vec3(-0.03, -0.05, 0), Vec3(0.03, 0.05, height)),
                Vec3(random.uniform(-0.5, 0.5), random.uniform(-0.4, 0.4), 0.70002));
      posts.push_back(*stage.scene.find(name));
    }
    stage.add("stick", stick(0.3), {"", {PoseChoice::Kind::AsModelled}, {}});
    const ObjectId id = *stage.scene.find("stick"), table = *stage.scene.find("table");
    const Landing landing{{table}, 0.70005, std::nullopt, Vec2(-0.5, -0.4), Vec2(0.5, 0.4)};
    const Rotation rotation = turned_about_z(random.uniform(0, 360));
    const ConvexRegion region(Vec2(-0.6, -0.5), Vec2(0.6, random.uniform(-0.4, 0.5)));
    const auto field_of_all = [&] {
      return std::make_unique<PlaceField>(stage.scene, id, rotation, landing, region, 1e-6,
                                          drop_brackets_of(nullptr));
    };
    const double keep = round % 2 ? 0.04 : 0;
    const auto all = field_of_all(), some = field_of_all();
    const std::vector<char> clear = all->clear_of(posts, keep);
    std::vector<size_t> left;
    const double share = round == 0 ? 0 : random.uniform(0, 0.3);
    for (size_t place = 0; place < all->size(); ++place)
      if (place == all->size() / 2 || random.uniform(0, 1) < share) left.push_back(place);
    some->leave(left);
    ASSERT_EQ(some->size(), left.size());
    const auto obstruction = some->obstruction(posts, keep);
    for (size_t k = left.size(); k-- > 0;) {
      ASSERT_EQ(some->at(k), all->at(left[k]));
      const bool is_over = all->is_over_support(left[k]);
      ASSERT_EQ(some->is_over_support(k), is_over) << round << ", " << left[k];
      if (!is_over) continue;
      ASSERT_EQ(obstruction->is_clear(k), clear[left[k]] != 0) << round << ", " << left[k];
      ASSERT_EQ(some->met_at(k), all->met_at(left[k]));
      ++(clear[left[k]] ? num_fitting : num_others);
    }
  }
  EXPECT_GT(num_fitting, 500);
  EXPECT_GT(num_others, 100);
}

// Rooms with screens, some of which hide all, some nothing; eyes in things and behind them.
TEST(Sights, AreDecidedAsTheirCostsSay) {
  Random random(5);
  int num_held = 0, num_broken = 0;
  for (int round = 0; round < 40; ++round) {
    Stage stage;
    stage.fix("desk", box_between(Vec3(-0.6, -0.4, 0), Vec3(0.6, 0.4, 0.7)), Vec3(0, 0, 1e-5));
    for (int i = 0; i < 4; ++i) {
      const double half = random.uniform(0.02, 0.5), high = random.uniform(0.05, 1);
      stage.fix("screen_" + std::to_string(i),
                i % 2 ? box_between(Vec3(-half, -0.01, 0), Vec3(half, 0.01, high))
                      : joined(box_between(Vec3(-half, -0.01, 0), Vec3(-0.01, 0.01, high)),
                               box_between(Vec3(0.01, -0.01, 0), Vec3(half, 0.01, high))),
                Vec3(random.uniform(-0.6, 0.6), random.uniform(-1, 1), 0.70002));
    }
    stage.add("cup", box_between(Vec3(-0.05, -0.05, 0), Vec3(0.05, 0.05, 0.1)));
    const relations::Kind kinds[] = {relations::View(), relations::Reach(), relations::Under()};
    const relations::Kind& kind = kinds[round % 3];
    const bool is_under = round % 3 == 2, is_viewer = round % 3 == 1 && round % 2;
    Relation& relation = is_under    ? stage.relate("cup", kind, "desk")
                         : is_viewer ? stage.relate("desk", kind, "cup")
                                     : stage.relate("cup", kind);
    const double upper = random.uniform(0.2, 1.5), part = random.uniform(0, 1);
    relation.tolerance = random.uniform(0.001, 0.2);
    std::optional<Vec3> eye;
    if (relation.b.empty()) eye = Vec3(0, random.uniform(-1.5, 0), 1.2);
    const auto set = [&]<class K>(K& its) {
      if constexpr (requires { its.upper; }) its.upper = upper;
      if constexpr (requires { its.part; }) its.part = part;
      if constexpr (requires { its.eye; }) its.eye = eye, its.eye_height = 0.3;
    };
    std::visit(set, relation.kind);
    Transaction transaction(stage.scene);
    const World world(transaction, stage.arrangement, {});
    const Relation& judged = world.arrangement().relations.front();
    const bool immovable_only = round % 5 == 0;
    SightJudge judge({world, 0, {}, immovable_only}, judged);
    for (int i = 0; i < 60; ++i) {
      const double low = is_under ? 0.0 : 0.7;
      Vec3 at(random.uniform(-0.7, 0.7), random.uniform(-0.9, 0.9), low + random.uniform(0, 0.4));
      if (i == 0 && eye) at = *eye - Vec3(0, 0, 0.05);  // the eye is in it
      const Pose pose{turned_about_z(random.uniform(0, 360)), at};
      const bool holds = sight_cost({world, 0, pose, immovable_only}, judged) <= 1;
      ASSERT_EQ(judge.holds_at(pose), holds) << round << ", " << i;
      ++(holds ? num_held : num_broken);
    }
  }
  EXPECT_GT(num_held, 300);
  EXPECT_GT(num_broken, 300);
}

// Places in rows, at random and at the target itself, one after the other.
TEST(PlaceCosts, AreMetWhereRelationsAre) {
  Random random(8);
  int num_met = 0, num_broken = 0;
  for (int round = 0; round < 60; ++round) {
    Stage stage;
    stage.fix("desk", box_between(Vec3(-0.3, -0.2, 0), Vec3(0.3, 0.2, 0.7)), Vec3(0, 0, 1e-5));
    stage.add("chair", box_between(Vec3(-0.2, -0.25, 0), Vec3(0.2, 0.25, 0.9)));
    const relations::Kind kinds[] = {relations::Near(), relations::Facing(), relations::Away(),
                                     relations::Same()};
    const bool is_near = round % 4 == 0, is_a = round % 5 != 0 || !is_near;
    Relation& relation =
        stage.relate(is_a ? "chair" : "desk", kinds[round % 4], is_a ? "desk" : "chair");
    const double lower = round % 3 == 0 ? random.uniform(0.01, 0.1) : 0;
    const double upper = lower + random.uniform(0.01, 0.5);
    if (auto* const near = relation.as<relations::Near>()) near->lower = lower, near->upper = upper;
    relation.tolerance = is_near ? 1e-3 : random.uniform(0.1, 60);
    Transaction transaction(stage.scene);
    World world(transaction, stage.arrangement, {});
    const Placer placer(world, 0, 1);
    const Relation& judged = world.arrangement().relations.front();
    const Outline desk = world.outline("desk");
    for (size_t c = 0; c < placer.combinations().size(); c += 5) {
      const Combination& combination = placer.combinations()[c];
      PlaceCosts costs(placer, combination);
      for (int i = 0; i < 200; ++i) {
        Vec2 at(-1 + 0.01 * i, random.uniform(-0.01, 0.01) + 0.1 * double(round % 8));
        if (i % 10 == 0) at = Vec2(random.uniform(-1, 1), random.uniform(-1, 1));
        if (i == 5) at = desk.centre - combination.outline.centre;
        costs.move_to(at);
        const Outline chair = moved(combination.outline, at);
        const double cost =
            is_a ? relation_cost(judged, chair, &desk) : relation_cost(judged, desk, &chair);
        const bool turns = judged.faces();
        const bool is_met = cost <= 1 + (turns ? kFacingSlackDeg / judged.tolerance : 0);
        ASSERT_EQ(costs.meets_hard(), is_met) << round << ", " << c << ", " << i;
        ++(is_met ? num_met : num_broken);
      }
    }
  }
  EXPECT_GT(num_met, 1000);
  EXPECT_GT(num_broken, 1000);
}

// Hidden sets among many: the answer is one of them, as if constraints were left out one by one.
TEST(SmallestEmpty, IsFoundByFewLooks) {
  Random random(3);
  for (int round = 0; round < 60; ++round) {
    const auto count = static_cast<size_t>(random.uniform(1, 400));
    std::vector<std::vector<size_t>> hidden(1 + round % 3);
    for (auto& set : hidden) {
      const auto size = static_cast<size_t>(random.uniform(1, 7));
      for (size_t k = 0; k < size; ++k)
        set.push_back(static_cast<size_t>(random.uniform(0, double(count))) % count);
      std::sort(set.begin(), set.end());
      set.erase(std::unique(set.begin(), set.end()), set.end());
    }
    size_t num_looks = 0;
    const auto leaves_nothing = [&](const std::vector<size_t>& set) {
      ++num_looks;
      return std::any_of(hidden.begin(), hidden.end(), [&](const auto& h) {
        return std::includes(set.begin(), set.end(), h.begin(), h.end());
      });
    };
    const auto found = smallest_empty(count, leaves_nothing);
    ASSERT_TRUE(found);
    EXPECT_TRUE(leaves_nothing(*found));
    const auto smallest = std::min_element(hidden.begin(), hidden.end(),
                                           [](auto& a, auto& b) { return a.size() < b.size(); });
    if (count > 200) {
      EXPECT_LT(num_looks, count + 250) << round;
    }
    if (smallest->size() == 1 || (smallest->size() == 2 && count <= 200)) {
      EXPECT_EQ(found->size(), smallest->size());
    }
    for (size_t k = 0; k < found->size() && found->size() > 1; ++k) {
      std::vector<size_t> fewer = *found;
      fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(k));
      EXPECT_FALSE(leaves_nothing(fewer)) << round;
    }
  }
}

}  // namespace
}  // namespace trivet::test
