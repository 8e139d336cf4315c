// PUT at a free place: the requested conditions hold at the end, for any shape.

#include <gtest/gtest.h>

#include "box.h"
#include "core/contact/contact_points.h"
#include "ops/check/check.h"
#include "ops/free_places/distance_query.h"
#include "ops/free_places/place_region.h"
#include "ops/operations/perform.h"
#include "ops/placement/neighbourhood.h"

namespace trivet {
namespace {

/// A table on the floor, and objects to put on it.
struct TableRoom {
  Scene scene;
  TableRoom() {
    const ObjectId table = scene.add(test::box_object("table", Vec3(0.6, 0.4, 0.35)));
    EXPECT_TRUE(put(scene, table, {{}, Vec3(0, 0, 0.5)}).ok());
  }
  OperationResult put_on(const std::string& name, const PlaceOptions& place,
                         const Rotation& rotation = {}) {
    PutOperation o;
    o.object = name;
    o.start.rotation = rotation;
    o.place = place;
    return perform(scene, o);
  }
  const Object& at(const std::string& name) { return std::as_const(scene).at(*scene.find(name)); }
};

TEST(PutSomewhere, FillsTableWithoutTouching) {
  test::Random random(5);
  TableRoom room;
  PlaceOptions place;
  place.on = "table";
  place.keep = 0.02;
  int num_placed = 0;
  for (int i = 0; i < 40; ++i) {
    const std::string name = "thing" + std::to_string(i);
    room.scene.add(i % 3 == 0   ? test::object_of(name, test::cylinder(0.05, 0.12, 24))
                   : i % 3 == 1 ? test::box_object(name, Vec3(0.06, 0.09, 0.02))
                                : test::object_of(name, test::torus(0.06, 0.015, 20, 8)));
    place.seed = static_cast<std::uint64_t>(i);
    const OperationResult result = room.put_on(name, place, random.rotation());
    if (!result.ok()) {
      EXPECT_NE(result.reason().find("no free place"), std::string::npos) << result.reason();
      continue;
    }
    ++num_placed;
    ASSERT_EQ(room.at(name).contacts.size(), 1u);
    EXPECT_EQ(room.scene.at(room.at(name).contacts[0].with.object()).name, "table");
  }
  EXPECT_GT(num_placed, 12);
  EXPECT_TRUE(check_scene(room.scene).ok());
  // Requested: at least 2 cm between any two.
  std::vector<Body> bodies;
  for (const ObjectId id : room.scene.ids()) {
    const Object& o = std::as_const(room.scene).at(id);
    if (o.placed && o.name != "table") bodies.emplace_back(*o.shape, o.world_from_object());
  }
  for (size_t i = 0; i < bodies.size(); ++i)
    for (size_t j = 0; j < i; ++j)
      EXPECT_TRUE(contact_points(bodies[i], bodies[j], 0.0199, 0).empty());
}

TEST(PutSomewhere, PutsNearestToPointOnFloor) {
  TableRoom room;
  room.scene.add(test::box_object("crate", Vec3(0.2, 0.2, 0.2)));
  PlaceOptions place;
  place.on = "floor";
  place.near = Vec2(0, 0);
  ASSERT_TRUE(room.put_on("crate", place).ok());
  const Vec3 at = room.at("crate").pose.translation;
  EXPECT_NEAR(at.z(), 0.2, 1e-4);
  EXPECT_GE(std::abs(at.y()), 0.6);  // the table is narrow that way
  EXPECT_LE(at.head<2>().norm(), 0.65);
}

// The smallest of them has a diagonal of 15 cm; the clearance follows what is near.
TEST(PutSomewhere, KeepsAnyDistanceOnTheFloor) {
  for (const double keep : {1.0, 30.0, 500.0, 1500.0, 1e4})
    for (const bool near : {false, true}) {
      TableRoom room;
      room.scene.add(test::box_object("cup", Vec3(0.04, 0.04, 0.05)));
      PlaceOptions place;
      place.on = "floor";
      place.keep = keep;
      if (near) place.near = Vec2(0.1, 0);
      const OperationResult result = room.put_on("cup", place);
      ASSERT_TRUE(result.ok()) << keep << (near ? " near: " : ": ") << result.reason();
      const Body cup = body_of(room.at("cup")), table = body_of(room.at("table"));
      EXPECT_FALSE(nearer_than(keep, cup, table)) << keep;
      EXPECT_TRUE(!near || nearer_than(1.01 * keep + 0.1, cup, table)) << keep;
    }
}

TEST(PutSomewhere, SaysWhyADistanceIsTooLarge) {
  for (const double keep : {1e8, 1e12, 1e15})
    for (const bool near : {false, true}) {
      TableRoom room;
      room.scene.add(test::box_object("cup", Vec3(0.04, 0.04, 0.05)));
      PlaceOptions place;
      place.on = "floor";
      place.keep = keep;
      if (near) place.near = Vec2(0.1, 0);
      const std::string reason = room.put_on("cup", place).reason();
      EXPECT_NE(reason.find("cannot be kept"), std::string::npos) << reason;
      EXPECT_NE(reason.find("accepted: a distance to keep of up to 2.359e+07"), std::string::npos)
          << reason;
    }
}

TEST(PutSomewhere, KeepsAnyDistanceFromNothing) {
  Scene scene;
  scene.add(test::box_object("cup", Vec3(0.04, 0.04, 0.05)));
  PutOperation o;
  o.object = "cup";
  o.place.emplace();
  o.place->on = "floor";
  o.place->keep = 1e15;
  const OperationResult result = perform(scene, o);
  EXPECT_TRUE(result.ok()) << result.reason();
}

// All vertices of the object at rest, and not only its centre.
TEST(PutSomewhere, LiesInItsRegion) {
  test::Random random(11);
  const std::vector<Vec2> triangle{{0, -0.3}, {0.5, 0}, {0, 0.3}};
  const std::vector<Vec2> square{{0.7, 0.6}, {1.1, 0.6}, {1.1, 1}, {0.7, 1}};
  int num_placed = 0, num_beyond_box = 0;
  for (int i = 0; i < 60; ++i) {
    TableRoom room;
    room.scene.add(i % 2 == 0 ? test::box_object("thing", Vec3(0.06, 0.03, 0.02))
                              : test::object_of("thing", test::torus(0.06, 0.015, 20, 8)));
    PlaceOptions place;
    place.on = i % 3 == 0 ? "floor" : "table";
    place.region = i % 3 == 0 ? square : triangle;
    place.seed = static_cast<std::uint64_t>(i);
    if (i % 5 == 0) place.keep = 0.05;
    if (i % 4 == 1) place.near = Vec2(0.5, 0);  // where it does not fit
    const OperationResult result = room.put_on("thing", place, random.rotation());
    ASSERT_TRUE(result.ok()) << i << ": " << result.reason();
    ++num_placed;
    const PlaceRegion region(place.region);
    const Body body = body_of(room.at("thing"));
    EXPECT_TRUE(region.holds(body)) << i;
    Vec2 centre = body.world_box.centre().head<2>();
    if (centre.x() > 0.25) ++num_beyond_box;
  }
  EXPECT_EQ(num_placed, 60);
  EXPECT_GT(num_beyond_box, 20);  // not all in one corner
}

// Without the region, the nearest place to this point is at the point.
TEST(PutSomewhere, IsNearestToThePointInItsRegion) {
  for (const bool has_region : {false, true}) {
    TableRoom room;
    room.scene.add(test::box_object("cube", Vec3::Constant(0.05)));
    PlaceOptions place;
    place.on = "table";
    place.near = Vec2(0.3, 0.1);
    if (has_region) place.region = {{-0.2, -0.2}, {0.2, -0.2}, {0.2, 0.2}, {-0.2, 0.2}};
    ASSERT_TRUE(room.put_on("cube", place).ok());
    const Vec3 at = room.at("cube").pose.translation;
    EXPECT_NEAR(at.x(), has_region ? 0.15 : 0.3, 1e-3);
    EXPECT_NEAR(at.y(), 0.1, 1e-2);
  }
}

TEST(PutSomewhere, SaysWhyItsRegionHasNoPlace) {
  const std::vector<std::pair<std::vector<Vec2>, std::string>> cases = {
      {{{0, 0}, {0.09, 0}, {0.09, 0.09}, {0, 0.09}}, "\"cube\" fits nowhere on \"table\" in its"},
      {{{5, 0}, {6, 0}, {6, 1}, {5, 1}}, "\"cube\" fits nowhere on \"table\" in its region"},
      {{{0.54, -0.1}, {0.9, -0.1}, {0.9, 0.1}, {0.54, 0.1}}, "no free place for \"cube\""},
      {{{0, 0}, {0, 1}, {1, 0}}, "region: 3 corners is not accepted"}};
  for (const auto& [region, says] : cases) {
    TableRoom room;
    room.scene.add(test::box_object("cube", Vec3::Constant(0.05)));
    PlaceOptions place;
    place.on = "table";
    place.region = region;
    place.least_margin = 0.02;
    const OperationResult result = room.put_on("cube", place);
    EXPECT_FALSE(result.ok());
    EXPECT_NE(result.reason().find(says), std::string::npos) << result.reason();
    EXPECT_FALSE(room.at("cube").placed);
  }
}

// A cube of 0.1 m at the table's edge: half of it may hang over, unless it is to stand well.
TEST(PutSomewhere, StandsWithTheMarginThatIsAskedFor) {
  for (const double margin : {0.0, 0.01, 0.03, 0.045}) {
    TableRoom room;
    room.scene.add(test::box_object("cube", Vec3::Constant(0.05)));
    PlaceOptions place;
    place.on = "table";
    place.near = Vec2(0.7, 0);
    place.least_margin = margin;
    const OperationResult result = room.put_on("cube", place);
    ASSERT_TRUE(result.ok()) << result.reason();
    EXPECT_GE(room.at("cube").stability_margin, margin);
    EXPECT_NEAR(room.at("cube").pose.translation.x(), 0.6 - margin, 2e-3);
  }
  TableRoom room;
  room.scene.add(test::box_object("cube", Vec3::Constant(0.05)));
  PlaceOptions place;
  place.on = "table";
  place.least_margin = 0.051;  // more than it ever has
  const OperationResult result = room.put_on("cube", place);
  ASSERT_TRUE(result.refusal);
  EXPECT_EQ(result.refusal->cause, Refusal::Cause::NoFreePlace);
  ASSERT_TRUE(result.refusal->first);
  EXPECT_EQ(result.refusal->first->cause, Refusal::Cause::StandsBadly);
  EXPECT_NE(result.reason().find("tips over an edge 0.05 m away; accepted: 0.051 m or more"),
            std::string::npos)
      << result.reason();
  EXPECT_FALSE(room.at("cube").placed);
}

// On a slope of 15 degrees, which needs friction of 0.27, or on the flat part above it.
TEST(PutSomewhere, NeedsNoMoreFrictionThanIsAccepted) {
  for (const bool slippery : {false, true}) {
    Scene scene;
    Object ramp = test::object_of(
        "ramp", test::prism({{-1, 0}, {0.5, 0}, {0.5, 0.268}, {0, 0.268}}, 0.4), true);
    ramp.placed = true;
    ramp.state = ObjectState::Fixed;
    ramp.pose.translation.z() = 1e-5;
    scene.add(std::move(ramp));
    scene.add(test::box_object("cube", Vec3::Constant(0.05)));
    PutOperation o;
    o.object = "cube";
    o.place.emplace();
    o.place->on = "ramp";
    o.place->near = Vec2(-0.4, 0);
    if (slippery) o.place->most_friction = 0.1;
    const OperationResult result = perform(scene, o);
    ASSERT_TRUE(result.ok()) << result.reason();
    const Object& cube = scene.at(*scene.find("cube"));
    if (slippery)
      EXPECT_LE(cube.least_friction, 0.1);
    else
      EXPECT_NEAR(cube.least_friction, 0.268, 0.01);
    EXPECT_EQ(cube.pose.translation.x() > -0.01, slippery);
  }
}

// More than there is on a table: all is blocked, and the maps stay small.
TEST(PutSomewhere, RefusesAnyDistanceOnATable) {
  for (const double keep : {10.0, 1e6, 1e12, 1e15}) {
    TableRoom room;
    room.scene.add(test::box_object("mat", Vec3(0.1, 0.1, 0.01)));
    room.scene.add(test::box_object("cup", Vec3(0.04, 0.04, 0.05)));
    PlaceOptions place;
    place.on = "table";
    ASSERT_TRUE(room.put_on("mat", place).ok());
    place.keep = keep;
    EXPECT_NE(room.put_on("cup", place).reason().find("no free place"), std::string::npos);
    place.near = Vec2(0, 0);
    EXPECT_NE(room.put_on("cup", place).reason().find("no free place"), std::string::npos);
  }
}

TEST(PutSomewhere, TheSameSeedGivesTheSameBits) {
  Vec3 first;
  for (int run = 0; run < 2; ++run) {
    TableRoom room;
    room.scene.add(test::box_object("crate", Vec3(0.1, 0.1, 0.1)));
    PlaceOptions place;
    place.on = "table";
    place.seed = 77;
    ASSERT_TRUE(room.put_on("crate", place).ok());
    if (run == 0) first = room.at("crate").pose.translation;
    EXPECT_EQ(room.at("crate").pose.translation, first);
  }
}

TEST(PutSomewhere, RefusesWithReason) {
  TableRoom room;
  room.scene.add(test::box_object("slab", Vec3(0.61, 0.41, 0.1)));
  PlaceOptions place;
  place.on = "table";
  place.near = Vec2(0, 0);
  ASSERT_TRUE(room.put_on("slab", place).ok());  // overhangs a little, all around
  room.scene.add(test::box_object("cup", Vec3(0.04, 0.04, 0.05)));
  const auto reason_of = [&](const std::string& name, const std::string& on) {
    place.on = on;
    const OperationResult result = room.put_on(name, place);
    EXPECT_FALSE(result.ok());
    return result.reason();
  };
  EXPECT_NE(reason_of("cup", "table").find("no free place for \"cup\" on \"table\""),
            std::string::npos);
  EXPECT_NE(reason_of("cup", "moon").find("no object \"moon\""), std::string::npos);
  EXPECT_NE(reason_of("cup", "cup").find("on itself"), std::string::npos);
  EXPECT_NE(reason_of("table", "slab").find("what it carries"), std::string::npos);
  EXPECT_FALSE(room.at("cup").placed);
  room.scene.floor = false;
  EXPECT_NE(reason_of("cup", "floor").find("no floor"), std::string::npos);
}

}  // namespace
}  // namespace trivet
