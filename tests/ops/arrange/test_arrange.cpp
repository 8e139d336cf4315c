// Relations on settled poses, and the scene as it was.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <set>

#include "core/base/error.h"
#include "core/contact/first_contact.h"
#include "ops/arrange/arrange_testing.h"
#include "ops/arrange/relations.h"
#include "ops/detect/detector.h"
#include "ops/free_places/distance_query.h"

namespace trivet {
namespace {

using test::expect_true;
using test::Stage;
using test::state_of;

TEST(Arrange, PutsThingsOnTheLevelsAskedFor) {
  Stage stage;
  stage.fix("shelf", test::shelf({0.1, 0.4, 0.8}), Vec3(0.5, -0.3, 1e-5));
  const double tops[] = {0.1, 0.4, 0.8};
  for (int i = 0; i < 6; ++i) {
    const std::string name = "cube_" + std::to_string(i);
    stage.add_cube(name);
    stage.relate<relations::On>(name, "shelf").as<relations::On>()->level =
        i % 2 ? i / 2 : i / 2 - 3;
  }
  for (const std::uint64_t seed : {1, 2, 3}) {
    const ArrangeResult result = stage.run(seed);
    expect_true(stage, result);
    for (int i = 0; i < 6; ++i)
      EXPECT_NEAR(stage.box("cube_" + std::to_string(i)).lower.z(), tops[i / 2], 1e-4);
  }
}

TEST(Arrange, KeepsAllRelationsWhereThingsComeToRest) {
  int num_evictions = 0;
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    Stage stage;
    stage.fix("table", test::box_between(Vec3(-0.5, -0.35, 0), Vec3(0.5, 0.35, 0.7)),
              Vec3(0, 0, 1e-5));
    stage.add("plate", test::cylinder(0.12, 0.02, 24), {"", {}, {0}});
    stage.add("knife", test::box_between(Vec3(-0.01, -0.1, 0), Vec3(0.01, 0.1, 0.004)));
    stage.add("cup", test::cylinder(0.04, 0.08, 16));
    stage.add("bowl", test::dish(0.12, 0.06, 0.006, 2, 20));
    stage.add("ball", test::ball(0.03, 12, 16), {"", {PoseChoice::Kind::Free}, {}});
    for (const char* name : {"plate", "knife", "cup", "bowl"})
      stage.relate<relations::On>(name, "table");
    stage.relate<relations::In>("ball", "bowl");
    stage.relate<relations::RightOf>("knife", "plate").as<relations::RightOf>()->upper = 0.03;
    stage.relate<relations::Parallel>("knife", "plate").tolerance = 2;
    Relation& centred = stage.relate<relations::Centred>("knife", "plate");
    centred.as<relations::Centred>()->along.x = false, centred.tolerance = 0.01;
    stage.relate<relations::Behind>("cup", "plate").as<relations::Behind>()->upper = 0.1;
    stage.relate<relations::Near>("cup", "knife").as<relations::Near>()->upper = 0.15;
    stage.relate<relations::Facing>("bowl").as<relations::Facing>()->point = Vec2(0, 0);
    stage.arrangement.relations.back().tolerance = 5;
    stage.arrangement.keeps.push_back({{"cup", "knife", "bowl"}, 0.01, {}});
    const ArrangeResult result = stage.run(seed);
    expect_true(stage, result);
    num_evictions += result.num_evictions;
    // The same by boxes, as the plate looks to -y.
    EXPECT_GE(stage.box("knife").lower.x(), stage.box("plate").upper.x() - 1e-3);
    EXPECT_LE(stage.box("knife").lower.x(), stage.box("plate").upper.x() + 0.031);
    EXPECT_GE(stage.box("cup").lower.y(), stage.box("plate").upper.y() - 1e-3);
    EXPECT_NEAR(stage.box("knife").centre().y(), stage.box("plate").centre().y(), 0.0101);
    const char* const pairs[][2] = {{"cup", "knife"}, {"cup", "plate"}, {"bowl", "plate"}};
    for (const auto& [a, b] : pairs) {
      const Object &p = stage.at(a), &q = stage.at(b);
      EXPECT_FALSE(nearer_than(0.01, Body(*p.shape, p.world_from_object()),
                               Body(*q.shape, q.world_from_object())))
          << a << " " << b;
    }
    for (const ObjectContact& entry : stage.at("ball").contacts)
      EXPECT_EQ(entry.with, Support(*stage.scene.find("bowl")));
  }
  EXPECT_LT(num_evictions, 60);
}

// The first of both comes to lie anywhere: where it leaves no room, it has to move.
TEST(Arrange, MovesWhatLeavesNoRoom) {
  int num_evictions = 0;
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    Stage stage;
    stage.fix("board", test::box_between(Vec3(-0.25, -0.1, 0), Vec3(0.25, 0.1, 0.5)),
              Vec3(0, 0, 1e-5));
    stage.add("small", test::box_between(Vec3(-0.05, -0.05, 0), Vec3(0.05, 0.05, 0.1)),
              {"", {}, {0}});
    stage.add("large", test::box_between(Vec3(-0.14, -0.05, 0), Vec3(0.14, 0.05, 0.1)),
              {"", {}, {0}});
    for (const char* name : {"small", "large"}) {
      stage.relate<relations::On>(name, "board");
      stage.relate<relations::Within>(name).as<relations::Within>()->region = {
          Vec2(-0.25, -0.1), Vec2(0.25, -0.1), Vec2(0.25, 0.1), Vec2(-0.25, 0.1)};
    }
    stage.relate<relations::RightOf>("large", "small");
    const ArrangeResult result = stage.run(seed);
    expect_true(stage, result);
    num_evictions += result.num_evictions;
    EXPECT_GE(stage.box("large").lower.x(), stage.box("small").upper.x() - 1e-3);
  }
  EXPECT_GT(num_evictions, 0);
}

// The back to the wall, which stands askew.
TEST(Arrange, StandsThingsAgainstWalls) {
  Stage stage;
  stage.fix("wall", test::box_between(Vec3(-2, -0.05, 0), Vec3(2, 0.05, 2)), Vec3(0, 1, 1e-5));
  edit_object(stage.scene, *stage.scene.find("wall"),
              [](Object& o) { o.pose.rotation = turned_about_z(20); });
  stage.add("shelf", test::shelf({0.1, 0.8}));
  stage.relate<relations::Against>("shelf", "wall").as<relations::Against>()->upper = 0.005;
  for (const std::uint64_t seed : {1, 2, 3}) {
    expect_true(stage, stage.run(seed));
    const Rotation& r = stage.at("shelf").pose.rotation;
    const Vec2 back = (r.matrix() * Vec3::UnitY()).head<2>();
    const Vec2 normal = turned_about_z(20).matrix().col(1).head<2>();
    EXPECT_LT(std::min(angle_between_deg(back, normal), angle_between_deg(back, Vec2(-normal))), 1);
    const Body shelf = body_of(stage.at("shelf")), wall = body_of(stage.at("wall"));
    EXPECT_TRUE(nearer_than(0.0061, shelf, wall));
  }
}

// A chair that looks at a desk, wherever it comes to stand.
// Pushed from where PUT left it: nothing but a clearance is between them.
TEST(Arrange, ClosesGapsOfZeroByContact) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    Stage stage;
    stage.fix("wall", test::box_between(Vec3(-1, 0, 0), Vec3(1, 0.1, 1)), Vec3(0, 0, 1e-5));
    stage.add("cabinet", test::box_between(Vec3(-0.2, -0.15, 0), Vec3(0.2, 0.15, 0.5)));
    stage.add_cube("bin");
    stage.relate<relations::Against>("cabinet", "wall").as<relations::Against>()->upper = 0;
    stage.relate<relations::LeftOf>("bin", "cabinet").as<relations::LeftOf>()->upper = 0;
    const ArrangeResult result = stage.run(seed);
    expect_true(stage, result);
    const auto is_at = [&](const char* a, const char* b) {
      const auto& contacts = stage.at(a).contacts;
      return std::any_of(contacts.begin(), contacts.end(), [&](const ObjectContact& c) {
        return c.with == Support(*stage.scene.find(b));
      });
    };
    EXPECT_TRUE(is_at("cabinet", "wall")) << seed;
    EXPECT_TRUE(is_at("bin", "cabinet")) << seed;
    for (const ArrangeResult::Holds& r : result.relations) EXPECT_LT(r.cost, 0.1) << r.relation;
  }
}

TEST(Arrange, TurnsThingsToFaceOthers) {
  Stage stage;
  stage.fix("desk", test::box_between(Vec3(-0.5, -0.3, 0), Vec3(0.5, 0.3, 0.7)), Vec3(0, 0, 1e-5));
  stage.add("chair", test::box_between(Vec3(-0.2, -0.25, 0), Vec3(0.2, 0.25, 0.5)));
  stage.relate<relations::Facing>("chair", "desk").tolerance = 2;
  stage.relate<relations::Near>("chair", "desk").as<relations::Near>()->upper = 0.8;
  for (const std::uint64_t seed : {1, 2, 3, 4}) {
    expect_true(stage, stage.run(seed));
    const Vec2 front = -stage.at("chair").pose.rotation.matrix().col(1).head<2>();
    EXPECT_LT(angle_between_deg(front, Vec2(-stage.box("chair").centre().head<2>())), 2.1);
  }
}

TEST(Arrange, FollowsSoftRelations) {
  double worst = 0, mean = 0;
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    Stage stage;
    stage.add_cube("cube");
    Relation& r = stage.relate<relations::At>("cube");
    r.as<relations::At>()->point = Vec2(0.4, -0.7);
    r.tolerance = 0.05;
    r.weight = 1;
    const ArrangeResult result = stage.run(seed);
    expect_true(stage, result);
    worst = std::max(worst, result.relations.front().cost);
    mean += (stage.box("cube").centre().head<2>() - *r.as<relations::At>()->point).norm() / 5;
  }
  EXPECT_LT(worst, 2);
  EXPECT_LT(mean, 0.05);
}

TEST(Arrange, GivesTheSameBitsWithAnyThreads) {
  std::set<std::uint64_t> states, others;
  for (const int threads : {1, 2, 8}) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism,
                                      static_cast<size_t>(threads));
    for (const std::uint64_t seed : {5, 6}) {
      Stage stage;
      stage.fix("table", test::box_between(Vec3(-0.4, -0.3, 0), Vec3(0.4, 0.3, 0.7)),
                Vec3(0, 0, 1e-5));
      for (int i = 0; i < 6; ++i) {
        const std::string name = "cube_" + std::to_string(i);
        stage.add_cube(name, 0.06 + 0.01 * i);
        stage.relate<relations::On>(name, "table");
        if (i > 0) {
          Relation& r = stage.relate<relations::Near>(name, "cube_" + std::to_string(i - 1));
          r.as<relations::Near>()->upper = 0.05;
          r.weight = 0.3;
          r.tolerance = 0.05;
        }
      }
      ASSERT_TRUE(stage.run(seed).ok());
      (seed == 5 ? states : others).insert(state_of(stage.scene));
    }
  }
  EXPECT_EQ(states.size(), 1u);
  EXPECT_EQ(others.size(), 1u);
  EXPECT_NE(states, others);
}

TEST(Arrange, ArrangesAnewWhatStands) {
  Stage stage;
  stage.add_cube("cube");
  stage.relate<relations::At>("cube").as<relations::At>()->point = Vec2(0.1, 0.2);
  stage.arrangement.relations.back().tolerance = 0.01;
  expect_true(stage, stage.run());
  stage.arrangement.relations.back().as<relations::At>()->point = Vec2(-0.7, 0.5);
  expect_true(stage, stage.run());
  EXPECT_NEAR(stage.box("cube").centre().x(), -0.7, 0.0101);
}

TEST(Arrange, RefusesWhatCannotBeMeant) {
  const auto message = [](const auto& change) -> std::string {
    Stage stage;
    stage.fix("rock", test::box_triangles(Vec3(0.1, 0.1, 0.1)), Vec3(3, 3, 0.2));
    stage.add_cube("a");
    stage.add_cube("b");
    change(stage);
    const auto before = state_of(stage.scene);
    try {
      stage.run();
    } catch (const Error& e) {
      EXPECT_EQ(state_of(stage.scene), before);
      return e.what();
    }
    return "nothing was refused";
  };
  const auto expect = [&](const auto& change, const std::string& says) {
    const std::string is = message(change);
    EXPECT_NE(is.find(says), std::string::npos) << is;
  };
  expect([](Stage& s) { s.relate<relations::On>("a", "rok"); }, "did you mean \"rock\"");
  expect(
      [](Stage& s) {
        s.arrangement.things.pop_back();
        s.relate<relations::Near>("a", "b");
      },
      "\"b\" stands nowhere");
  expect([](Stage& s) { s.relate<relations::Near>("a", "a"); }, "no relation to itself");
  expect([](Stage& s) { s.relate<relations::On>("rock", "a"); }, "none of the things");
  expect([](Stage& s) { s.arrangement.things.push_back({"rock"}); }, "is fixed");
  expect([](Stage& s) { s.arrangement.things.push_back({"a"}); }, "comes twice");
  expect(
      [](Stage& s) {
        s.relate<relations::On>("a", "b");
        s.relate<relations::On>("b", "a");
      },
      "would have to carry itself");
  expect(
      [](Stage& s) {
        s.relate<relations::On>("a", "rock");
        s.relate<relations::On>("a", "floor");
      },
      "says already what carries");
  expect(
      [](Stage& s) {
        s.arrangement.things[0].pose = {PoseChoice::Kind::Number, 6};
      },
      "has no stable pose 6: there are 6");
}

// Far more than maps of heights could show by pixels of a cube.
TEST(Arrange, KeepsDistancesOfManyTimesTheirSize) {
  Stage stage;
  for (const char* name : {"a", "b", "c"}) stage.add_cube(name);
  stage.arrangement.keeps.push_back({{"a", "b", "c"}, 5, {{"a", "b"}}});
  Relation& near = stage.relate<relations::Near>("b", "a");
  near.as<relations::Near>()->upper = 0.2;
  expect_true(stage, stage.run());
  for (const char* other : {"a", "b"})
    EXPECT_GE((stage.box("c").centre() - stage.box(other).centre()).norm(), 5.1) << other;
}

// A cup in a hall, a bolt in a field: pixels of a grid over all of it would be larger than they.
TEST(Arrange, FindsPlacesForSmallThingsInLargeScenes) {
  for (const double size : {8.0, 30.0, 200.0}) {
    Stage stage;
    stage.fix("wall", test::box_between(Vec3(-0.1, -0.1, 0), Vec3(0.1, 0.1, 1)),
              Vec3(size, size, 1e-3));
    stage.add_cube("cup");
    expect_true(stage, stage.run());
  }
}

TEST(Arrange, StopsWhenItIsCancelled) {
  Stage stage;
  stage.add_cube("a");
  const std::atomic<bool> cancel{true};
  const auto before = state_of(stage.scene);
  const ArrangeResult result = arrange(stage.scene, stage.arrangement, {}, {nullptr, &cancel, 0});
  EXPECT_EQ(result.status, ArrangeResult::Status::Cancelled);
  EXPECT_EQ(state_of(stage.scene), before);
}

// Every place that is offered: an exact fall meets the support first, and keeps the distance.
TEST(PlaceField, OffersWhatFallsOntoTheSupport) {
  test::Random random(9);
  int num_offered = 0, num_blocked = 0;
  for (int round = 0; round < 4; ++round) {
    Stage stage;
    stage.fix("table", test::box_between(Vec3(-0.5, -0.4, 0), Vec3(0.5, 0.4, 0.7)),
              Vec3(0, 0, 1e-5));
    for (int i = 0; i < 5; ++i)
      stage.fix(
          "post_" + std::to_string(i),
          test::box_between(Vec3(-0.03, -0.05, 0), Vec3(0.03, 0.05, random.uniform(0.05, 0.3))),
          Vec3(random.uniform(-0.4, 0.4), random.uniform(-0.3, 0.3), 0.70002));
    stage.add("stick", test::stick(0.3), {"", {PoseChoice::Kind::AsModelled}, {}});
    const ObjectId id = *stage.scene.find("stick"), table = *stage.scene.find("table");
    const double clearance = 1e-6, keep = round % 2 ? 0.04 : 0.0;
    Landing landing{{table}, 0.70001 + 4e-6, std::nullopt, Vec2(-0.5, -0.4), Vec2(0.5, 0.4)};
    const Rotation rotation = turned_about_z(random.uniform(0, 360));
    const PlaceField field(stage.scene, id, rotation, landing,
                           ConvexRegion(Vec2(-0.5, -0.4), Vec2(0.5, 0.4)), clearance,
                           drop_brackets_of(nullptr));
    std::vector<ObjectId> posts;
    for (const ObjectId other : stage.scene.ids())
      if (other != id && other != table) posts.push_back(other);
    const std::vector<char> clear = field.clear_of(posts, keep);
    const Object& stick = stage.scene.at(id);
    for (size_t i = 0; i < field.size(); i += 7) {
      if (!clear[i] || !field.is_over_support(i)) {
        ++num_blocked;
        continue;
      }
      const Body flat = body_of(stick, {rotation, Vec3::Zero()});
      const Pose start{rotation, Vec3(field.at(i).x(), field.at(i).y(),
                                      landing.start_z - flat.world_box.lower.z() + clearance)};
      Body body = body_of(stick, start);
      std::vector<Body> fixed{body_of(stage.scene.at(table))};
      for (const ObjectId post : posts) fixed.push_back(body_of(stage.scene.at(post)));
      const FirstContact found = first_contact(
          {{&body, 1}, fixed, true, Motion::translation(-Vec3::UnitZ(), 2), {clearance}});
      ASSERT_EQ(found.status, FirstContact::Status::Contact);
      EXPECT_EQ(found.fixed, 0);
      Affine landed = body.world_from_object;
      landed.translation.z() -= found.time;
      for (size_t k = 1; keep > 0 && k < fixed.size(); ++k)
        EXPECT_FALSE(nearer_than(keep, Body(*stick.shape, landed), fixed[k]));
      ++num_offered;
    }
  }
  EXPECT_GT(num_offered, 200);
  EXPECT_GT(num_blocked, 200);
}

}  // namespace
}  // namespace trivet
