// The nearest free place: known answers, and brute force over all points.

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "box.h"
#include "core/contact/triangle_distance.h"
#include "core/scene/transaction.h"
#include "ops/free_places/distance_query.h"
#include "ops/operations/perform.h"

namespace trivet {
namespace {

constexpr double kHalf = 0.1;                           // of the cube to place
constexpr double kTolerance = 2 * kHalf / 4096 + 5e-5;  // guaranteed accuracy, and clearances

/// A scene no larger than its single object, a table of 1 m, and a cube to place.
struct SmallRoom {
  Scene scene;
  SmallRoom() {
    const ObjectId table = scene.add(test::box_object("table", Vec3(0.5, 0.5, 0.35)));
    EXPECT_TRUE(put(scene, table, {{}, Vec3(0, 0, 0.5)}).ok());
    scene.add(test::box_object("cube", Vec3::Constant(kHalf)));
  }
  OperationResult put_on(const std::string& on, std::optional<Vec2> at, double keep,
                         std::uint64_t seed = 0, const std::string& name = "cube") {
    PutOperation o;
    o.object = name;
    o.place.emplace();
    o.place->on = on;
    o.place->near = at;
    o.place->keep = keep;
    o.place->seed = seed;
    return perform(scene, o);
  }
  Vec3 position(const std::string& name = "cube") const {
    return scene.at(*scene.find(name)).pose.translation;
  }
};

/// Distance from an upright cube at p to a box, seen from above.
double distance(const Vec2& p, const Vec2& centre, const Vec2& half) {
  return ((p - centre).cwiseAbs() - half - Vec2::Constant(kHalf)).cwiseMax(0).norm();
}

TEST(NearestPlace, IsBesideOnlyObject) {
  for (const double keep : {0.0, 0.1, 0.2, 0.5, 2.0, 100.0}) {
    for (std::uint64_t seed = 0; seed < 2; ++seed) {
      SmallRoom room;
      const OperationResult result = room.put_on("floor", {}, keep, seed);
      ASSERT_TRUE(result.ok()) << keep << ": " << result.reason();
      EXPECT_GE(distance(room.position().head<2>(), {0, 0}, {0.5, 0.5}), keep);
    }
  }
}

TEST(NearestPlace, IsNearestToPointOffCentre) {
  struct Case {
    Vec2 at;
    double keep;
    Vec2 expected;
  };
  const Case cases[] = {{{0.2, 0.1}, 0.05, {0.65, 0.1}}, {{0.3, 0}, 0, {0.6, 0}},
                        {{0.3, 0}, 0.5, {1.1, 0}},       {{0.3, -0.29}, 0, {0.6, -0.29}},
                        {{0.001, 0}, 0, {0.6, 0}},       {{0, -0.002}, 2, {0, -2.6}},
                        {{0.1, 0.4}, 0.02, {0.1, 0.62}}, {{0.55, 0.55}, 0, {0.6, 0.55}}};
  for (const Case& c : cases) {
    SmallRoom room;
    const OperationResult result = room.put_on("floor", c.at, c.keep);
    ASSERT_TRUE(result.ok()) << result.reason();
    const Vec2 found = room.position().head<2>();
    EXPECT_GE(distance(found, {0, 0}, {0.5, 0.5}), c.keep);
    EXPECT_NEAR((found - c.at).norm(), (c.expected - c.at).norm(), kTolerance)
        << found.transpose() << " instead of " << c.expected.transpose();
  }
}

TEST(NearestPlace, IsPointItselfIfFree) {
  for (const Vec2& at : {Vec2(5, 5), Vec2(-0.75, 0.3), Vec2(123.4, -7)}) {
    SmallRoom room;
    ASSERT_TRUE(room.put_on("floor", at, 0.1).ok());
    EXPECT_LE((room.position().head<2>() - at).norm(), 1e-9);
  }
  SmallRoom room;
  ASSERT_TRUE(room.put_on("table", Vec2(0.123, 0.0456), 0.3).ok());
  EXPECT_LE((room.position().head<2>() - Vec2(0.123, 0.0456)).norm(), 1e-9);
}

TEST(NearestPlace, IsAtTableEdgeForPointBeside) {
  SmallRoom room;
  const OperationResult result = room.put_on("table", Vec2(3, 0.2), 0);
  ASSERT_TRUE(result.ok()) << result.reason();
  EXPECT_NEAR(room.position().x(), 0.5, 2e-3);
  EXPECT_LT(room.position().x(), 0.5);
  EXPECT_NEAR(room.position().y(), 0.2, 0.02);
}

TEST(NearestPlace, KeepsAnyDistanceOnEmptyFloor) {
  for (const double keep : {0.5, 5.0, 1e6}) {
    SmallRoom room;
    const OperationResult result = room.put_on("table", {}, keep);
    EXPECT_TRUE(result.ok()) << result.reason();
  }
}

TEST(NearestPlace, KeepsLargeDistanceOnTableWithJustEnoughRoom) {
  SmallRoom room;
  room.scene.add(test::box_object("post", Vec3(0.02, 0.02, 0.2)));
  ASSERT_TRUE(room.put_on("table", Vec2(-0.47, -0.47), 0, 0, "post").ok());
  // The cube may overhang: its centre up to (0.5, 0.5), its corner at (0.4, 0.4), the post's at
  // (-0.45, -0.45).
  for (const double keep : {1.19, 1.21}) {
    const OperationResult result = room.put_on("table", {}, keep, 3);
    EXPECT_EQ(result.ok(), keep < 1.2) << keep << ": " << result.reason();
    if (result.ok()) {
      EXPECT_GE(distance(room.position().head<2>(), {-0.47, -0.47}, {0.02, 0.02}), keep);
    }
  }
}

TEST(NearestPlace, RefusesFixedAndLockedWithReason) {
  for (const bool fixed : {true, false}) {
    SmallRoom room;
    edit_object(room.scene, *room.scene.find("table"),
                [&](Object& table) { (fixed ? table.fixed : table.locked) = true; });
    for (const std::optional<Vec2>& at : {std::optional<Vec2>{}, {Vec2(1, 1)}})
      EXPECT_EQ(
          room.put_on("floor", at, 0, 0, "table").reason(),
          fixed ? "\"table\" is fixed: unfix it first" : "\"table\" is locked: unlock it first");
  }
}

TEST(NearestPlace, HasNoNearerFreePoint) {
  test::Random random(11);
  int num_blocked = 0;
  for (int run = 0; run < 12; ++run) {
    SmallRoom room;
    std::vector<std::pair<Vec2, Vec2>> boxes{{{0, 0}, {0.5, 0.5}}};
    for (int i = 0; i < 5; ++i) {
      const Vec2 half(random.uniform(0.05, 0.4), random.uniform(0.05, 0.4));
      const Vec2 at(random.uniform(-1.5, 1.5), random.uniform(-1.5, 1.5));
      Object object = test::box_object("box" + std::to_string(i), Vec3(half.x(), half.y(), 0.3));
      object.placed = true;  // boxes may overlap: irrelevant to the cube
      object.fixed = true;
      object.pose.translation = Vec3(at.x(), at.y(), 0.3);
      room.scene.add(object);
      boxes.emplace_back(at, half);
    }
    const double keep = run % 3 == 0 ? 0 : random.uniform(0, 0.4);
    const auto room_at = [&](const Vec2& p) {
      double least = kInfinity;
      for (const auto& [centre, half] : boxes) least = std::min(least, distance(p, centre, half));
      return least;
    };
    const Vec2 near(random.uniform(-1, 1), random.uniform(-1, 1));
    const OperationResult result = room.put_on("floor", near, keep);
    ASSERT_TRUE(result.ok()) << result.reason();
    const Vec2 found = room.position().head<2>();
    EXPECT_GE(room_at(found), keep);
    const double radius = (found - near).norm() - kTolerance;
    num_blocked += radius > 0;
    for (int k = 0; k < 40000 && radius > 0; ++k) {
      const Vec2 p(random.uniform(-1, 1), random.uniform(-1, 1));
      if (p.norm() > 1) continue;
      ASSERT_LT(room_at(near + radius * p), keep + 5e-5)
          << "run " << run << ": " << (near + radius * p).transpose() << " is nearer to "
          << near.transpose() << " than " << found.transpose();
    }
  }
  EXPECT_GT(num_blocked, 6);
}

TEST(NearestPlace, GivesSameBitsOnAnyNumberOfThreads) {
  std::vector<Vec3> found;
  for (const int threads : {1, 2, 5}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    for (const std::optional<Vec2>& at : {std::optional<Vec2>{}, {Vec2(0.21, 0.13)}}) {
      SmallRoom room;
      ASSERT_TRUE(room.put_on("floor", at, 0.07, 9).ok());
      found.push_back(room.position());
    }
  }
  for (size_t i = 2; i < found.size(); ++i) EXPECT_EQ(found[i], found[i % 2]);
}

TEST(NearerThan, AgreesWithAllPairsOfFaces) {
  test::Random random(4);
  const auto shape = test::shape_of(test::bumpy_sphere(8, 10, 0.3, 2));
  int num_near = 0;
  for (int run = 0; run < 300; ++run) {
    const Body a(*shape, world_from_object({random.rotation(), Vec3::Zero()}, UpAxis::Z, 1));
    const Vec3 away(random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(-3, 3));
    const Body b(*shape, world_from_object({random.rotation(), away}, UpAxis::Z, 0.5));
    double least = kInfinity;
    for (Index i = 0; i < static_cast<Index>(shape->mesh.triangles.size()); ++i)
      for (Index j = 0; j < static_cast<Index>(shape->mesh.triangles.size()); ++j)
        least = std::min(least, closest_points(a.triangle(i), b.triangle(j)).distance);
    EXPECT_FALSE(nearer_than(least, a, b));
    EXPECT_TRUE(nearer_than(least * (1 + 1e-9) + 1e-12, a, b));
    const double tried = random.uniform(0, 2);
    EXPECT_EQ(nearer_than(tried, a, b), least < tried);
    num_near += least < tried;
  }
  EXPECT_GT(num_near, 60);
  EXPECT_LT(num_near, 240);
}

}  // namespace
}  // namespace trivet
