// Free places: known answers, and an exact fall for every offered place.

#include <gtest/gtest.h>

#include <set>

#include "core/contact/first_contact.h"
#include "core/scene/transaction.h"
#include "ops/free_places/places.h"
#include "support/solids.h"

namespace trivet {
namespace {

constexpr double kClearance = 2e-6;
constexpr double kTop = 0.75;

class Room {
 public:
  Scene scene;

  ObjectId add(const std::string& name, const std::vector<Triangle>& triangles,
               std::optional<Vec3> at) {
    Object object;
    object.name = name;
    object.shape = test::shape_of(triangles);
    if (at) {
      object.pose.translation = *at;
      object.placed = true;
    }
    return scene.add(object);
  }
  ObjectId add_table() {
    return add("table", test::box_triangles(Vec3(1, 0.5, 0.02)), Vec3(0, 0, kTop - 0.02));
  }
  /// Adds a box that stands on the table.
  ObjectId add_box(const std::string& name, const Vec3& half, double x, double y) {
    return add(name, test::box_triangles(half), Vec3(x, y, kTop + half.z() + kClearance));
  }
  ObjectId add_cube() { return add("cube", test::box_triangles(Vec3(0.1, 0.1, 0.1)), {}); }

  /// First contact of an object falling from there; nullopt: the floor.
  std::optional<ObjectId> met_first(ObjectId id, const Pose& start) const {
    std::vector<ObjectId> ids;
    std::vector<Body> bodies;
    for (const ObjectId other : scene.ids()) {
      if (other == id || !scene.at(other).placed) continue;
      ids.push_back(other);
      bodies.emplace_back(*scene.at(other).shape, scene.at(other).world_from_object());
    }
    const Body body(*scene.at(id).shape, world_from_object(start, UpAxis::Z, scene.at(id).scale));
    FirstContactQuery query;
    query.moving = {&body, 1};
    query.fixed = bodies;
    query.floor = true;
    query.motion = Motion::translation(-Vec3::UnitZ(), 10);
    query.clearance.distance = kClearance;
    const FirstContact found = first_contact(query);
    EXPECT_EQ(found.status, FirstContact::Status::Contact);
    if (found.fixed == FirstContact::kFloor) return std::nullopt;
    return ids[found.fixed];
  }
};

TEST(Places, AreNearestBesideObstacle) {
  for (const double keep : {0.0, 0.05}) {
    Room room;
    const ObjectId table = room.add_table(), cube = room.add_cube();
    room.add_box("box", Vec3(0.15, 0.15, 0.15), 0.2, 0.1);
    PlaceRequest request;
    request.on = table;
    request.near = Vec2(0.2, 0.1);
    request.keep = keep;
    const Places places = find_places(room.scene, cube, {&cube, 1}, request, kClearance);
    ASSERT_FALSE(places.starts.empty());
    const Vec2 away = places.starts.front().translation.head<2>() - *request.near;
    EXPECT_GE(away.cwiseAbs().maxCoeff(), 0.25 + keep);
    EXPECT_LE(away.norm(), 0.25 + keep + 4 * places.spacing);
  }
}

TEST(Places, FallOntoSupportFromEveryOffer) {
  test::Random random(3);
  Room room;
  const ObjectId table = room.add_table();
  for (int i = 0; i < 6; ++i)
    room.add_box("box" + std::to_string(i), Vec3(0.05, 0.08, random.uniform(0.02, 0.3)),
                 random.uniform(-0.9, 0.9), random.uniform(-0.4, 0.4));
  const ObjectId ball = room.add("ball", test::bumpy_sphere(12, 16, 0.2, 5), {});
  edit_object(room.scene, ball, [](Object& o) { o.scale = 0.08; });
  for (int i = 0; i < 8; ++i) {
    PlaceRequest request;
    request.on = table;
    request.rotation = random.rotation();
    request.seed = static_cast<std::uint64_t>(i);
    const Places places = find_places(room.scene, ball, {&ball, 1}, request, kClearance);
    EXPECT_EQ(places.num_judged - places.num_beside - places.num_blocked,
              static_cast<std::int64_t>(places.starts.size()));
    ASSERT_GT(places.starts.size(), 500u);
    for (size_t k = 0; k < 60; ++k) {
      Pose start = places.starts[k];
      EXPECT_EQ(room.met_first(ball, start), table);
    }
  }
}

TEST(Places, DependOnSeedAlone) {
  Room room;
  const ObjectId table = room.add_table(), cube = room.add_cube();
  PlaceRequest request;
  request.on = table;
  std::set<std::pair<double, double>> firsts;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    request.seed = seed;
    const Places a = find_places(room.scene, cube, {&cube, 1}, request, kClearance);
    const Places b = find_places(room.scene, cube, {&cube, 1}, request, kClearance);
    ASSERT_FALSE(a.starts.empty());
    EXPECT_EQ(a.starts[0].translation, b.starts[0].translation);
    firsts.emplace(a.starts[0].translation.x(), a.starts[0].translation.y());
  }
  EXPECT_GT(firsts.size(), 15u);
}

TEST(Places, AreEmptyOnFullTable) {
  Room room;
  const ObjectId table = room.add_table(), cube = room.add_cube();
  for (int i = 0; i < 10; ++i)
    for (int j = 0; j < 5; ++j)
      room.add_box("box" + std::to_string(i) + "_" + std::to_string(j), Vec3(0.05, 0.05, 0.05),
                   -0.9 + 0.2 * i, -0.4 + 0.2 * j);
  PlaceRequest request;
  request.on = table;
  const Places places = find_places(room.scene, cube, {&cube, 1}, request, kClearance);
  EXPECT_TRUE(places.starts.empty());
  EXPECT_GT(places.num_blocked, 1000);
}

TEST(Places, WorkUnderCeilingAndOnLowerBoard) {
  Room room;
  const auto boards =
      test::joined(test::moved(test::box_triangles(Vec3(0.4, 0.2, 0.01)), Vec3(0, 0, 0.3)),
                   test::moved(test::box_triangles(Vec3(0.4, 0.2, 0.01)), Vec3(0, 0, 0.8)));
  const ObjectId shelf = room.add("shelf", boards, Vec3(0, 0, 0));
  room.add("ceiling", test::box_triangles(Vec3(5, 5, 0.1)), Vec3(0, 0, 2.5));
  const ObjectId cube = room.add_cube();
  PlaceRequest request;
  request.on = shelf;
  for (const auto& [from, board] : {std::pair<std::optional<double>, double>{{}, 0.81},
                                    std::pair<std::optional<double>, double>{0.4, 0.31}}) {
    request.from = from;
    const Places places = find_places(room.scene, cube, {&cube, 1}, request, kClearance);
    ASSERT_GT(places.starts.size(), 100u);
    EXPECT_EQ(room.met_first(cube, places.starts[0]), shelf);
    EXPECT_GT(places.starts[0].translation.z() - 0.1, board);
    EXPECT_LT(places.starts[0].translation.z() - 0.1, board + 0.1);
  }
}

TEST(Places, LieOnFloorBesideObjects) {
  Room room;
  room.add("block", test::box_triangles(Vec3(0.5, 0.5, 0.5)), Vec3(0, 0, 0.5 + kClearance));
  const ObjectId cube = room.add_cube();
  PlaceRequest request;
  request.near = Vec2(0, 0);
  const Places places = find_places(room.scene, cube, {&cube, 1}, request, kClearance);
  ASSERT_FALSE(places.starts.empty());
  const Vec2 at = places.starts[0].translation.head<2>();
  EXPECT_GE(at.cwiseAbs().maxCoeff(), 0.6);
  EXPECT_LE(at.norm(), 0.6 + 4 * places.spacing);
  EXPECT_EQ(room.met_first(cube, places.starts[0]), std::nullopt);
}

}  // namespace
}  // namespace trivet
