// Settling of one body among static ones, by its own interface.

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/tunables.h"
#include "ops/settle/settle.h"
#include "support/random_shapes.h"
#include "support/settle_options.h"

namespace trivet {
namespace {

using Status = SettleOutcome::Status;

constexpr double kEps = 1e-6;

struct Box {
  std::shared_ptr<const Shape> shape;
  explicit Box(const Vec3& half) : shape(test::shape_of(test::box_triangles(half))) {}
  Body body_at(const Vec3& place) const { return {*shape, test::placed({}, place)}; }
};

/// A box that does not move.
struct Fixed {
  const Box& box;
  Vec3 place;
};

Scene scene_of(const std::vector<Fixed>& fixed, bool floor) {
  Scene scene;
  scene.floor = floor;
  for (const Fixed& f : fixed) {
    Object object;
    object.name = std::to_string(scene.num_objects());
    object.shape = f.box.shape;
    object.fixed = object.placed = true;
    object.pose.translation = f.place;
    scene.add(std::move(object));
  }
  return scene;
}

SettleOutcome settled(const Box& box, const Pose& start, const std::vector<Fixed>& fixed,
                      bool floor = true, const SettleOptions& options = test::perfect_friction()) {
  const Scene scene = scene_of(fixed, floor);
  const Neighbourhood others(scene, std::span<const ObjectId>());
  SettleProblem problem;
  problem.shape = box.shape.get();
  problem.start = start;
  problem.others = &others;
  problem.clearance = kEps;
  problem.options = options;
  return settle(problem);
}

const Box& cube() {
  static const Box box(Vec3(0.5, 0.5, 0.5));
  return box;
}

TEST(Settle, FallsAndRests) {
  const SettleOutcome out = settled(cube(), {{}, Vec3(0, 0, 3)}, {});
  EXPECT_EQ(out.status, Status::AtRest);
  ASSERT_EQ(out.steps.size(), 1u);
  EXPECT_NEAR(out.pose.translation.z(), 0.5 + kEps, 0.1 * kEps);
  ASSERT_EQ(out.contacts.size(), 1u);
  EXPECT_TRUE(out.contacts[0].with.is_floor());
  EXPECT_EQ(out.contacts[0].points.size(), 4u);
  EXPECT_GE(out.num_queries, 1);
  EXPECT_GE(out.num_face_pairs, 8);
}

TEST(Settle, KeepsObjectAtRest) {
  const Pose start{{}, Vec3(0, 0, 0.5 + kEps)};
  const SettleOutcome out = settled(cube(), start, {});
  EXPECT_EQ(out.status, Status::AtRest);
  EXPECT_TRUE(out.steps.empty());
  EXPECT_EQ(out.pose.translation, start.translation);
}

TEST(Settle, OpensTooSmallGap) {
  const SettleOutcome out = settled(cube(), {{}, Vec3(0, 0, 0.5 + 0.1 * kEps)}, {});
  EXPECT_EQ(out.status, Status::AtRest);
  ASSERT_FALSE(out.steps.empty());
  EXPECT_EQ(out.steps[0].kind, SettleStep::Kind::Lift);
  EXPECT_LT(out.steps[0].energy_drop, 0);
  for (const ContactPoint& p : out.contacts[0].points) EXPECT_GE(p.gap, kSeparateBelow * kEps);
}

TEST(Settle, FallsOutWithoutSupport) {
  EXPECT_EQ(settled(cube(), {{}, Vec3(0, 0, 3)}, {}, false).status, Status::FallsOut);
  const Box slab(Vec3(1, 1, 0.1));
  const std::vector<Fixed> beside{{slab, Vec3(5, 0, 0)}};
  EXPECT_EQ(settled(cube(), {{}, Vec3(0, 0, 3)}, beside, false).status, Status::FallsOut);
  const std::vector<Fixed> edge{{slab, Vec3(1.4, 0, 0)}};  // tips over it
  EXPECT_EQ(settled(cube(), {{}, Vec3(0, 0, 3)}, edge, false).status, Status::FallsOut);
}

TEST(Settle, StopsAtLimitOfMotions) {
  SettleOptions options = test::perfect_friction();
  options.max_motions = 1;
  const Rotation tilted = Rotation::about_axis(Vec3(1, 2, 3).normalized(), 0.4);
  const SettleOutcome out = settled(cube(), {tilted, Vec3(0, 0, 3)}, {}, true, options);
  EXPECT_EQ(out.status, Status::TooManyMotions);
  EXPECT_LE(out.steps.size(), 2u);
}

TEST(Settle, ReportsCrossingStart) {
  const std::vector<Fixed> fixed{{cube(), Vec3(0.5, 0.5, 0.7)}};
  EXPECT_EQ(settled(cube(), {{}, Vec3(0, 0, 0.6)}, fixed).status, Status::Crossing);
}

TEST(IsAtRest, HoldsOnlyOnSupport) {
  const Scene empty;
  const Neighbourhood others(empty, std::span<const ObjectId>());
  const auto rests = [&](const Vec3& at, const Rotation& rotation = {}) {
    SettleProblem problem;
    problem.options = test::perfect_friction();
    problem.others = &others;
    problem.shape = cube().shape.get();
    problem.start = {rotation, at};
    problem.clearance = kEps;
    return is_at_rest(problem);
  };
  EXPECT_TRUE(rests(Vec3(0, 0, 0.5 + kEps)));
  EXPECT_FALSE(rests(Vec3(0, 0, 0.5 + 15 * kEps)));  // hovers
  EXPECT_FALSE(rests(Vec3(0, 0, 3)));
  // On an edge, exactly and nearly: in balance, but not at rest.
  const double high = std::sqrt(0.5) + kEps;
  EXPECT_FALSE(rests(Vec3(0, 0, high), Rotation::about_axis(Vec3::UnitX(), std::tan(M_PI / 8))));
  EXPECT_FALSE(
      rests(Vec3(0, 0, high), Rotation::about_axis(Vec3::UnitX(), std::tan(M_PI / 8 + 1e-4))));
}

TEST(Settle, ListsContactsByBodyFloorFirst) {
  const Box slab(Vec3(1, 1, 0.1));
  const std::vector<Fixed> fixed{{cube(), Vec3(9, 9, 9)},
                                 {cube(), Vec3(-1 - kEps, 0, 0.5)},
                                 {slab, Vec3(0, 0, 1.1 + 2 * kEps)}};
  const Scene scene = scene_of(fixed, true), no_floor = scene_of(fixed, false);
  const std::vector<ObjectId> ids = scene.ids();
  const Neighbourhood others(scene, std::span<const ObjectId>());
  const Neighbourhood without_floor(no_floor, std::span<const ObjectId>());
  const Body body = cube().body_at(Vec3(0, 0, 0.5 + kEps));
  const auto found = contacts_with(body, others, 2 * kEps, 0.05 * kEps);
  ASSERT_EQ(found.size(), 3u);
  EXPECT_TRUE(found[0].with.is_floor());
  EXPECT_EQ(found[1].with, Support(ids[1]));
  EXPECT_EQ(found[2].with, Support(ids[2]));
  for (const ContactsWith& c : found) EXPECT_FALSE(c.points.empty());
  EXPECT_LT((found[1].points[0].normal - Vec3::UnitX()).norm(), 1e-9);
  EXPECT_LT((found[2].points[0].normal + Vec3::UnitZ()).norm(), 1e-9);
  const auto all = all_points(found, 2 * kEps);
  EXPECT_EQ(all.size(), 12u);  // four corners each
  EXPECT_EQ(contacts_with(body, without_floor, 2 * kEps, 0.05 * kEps).size(), 2u);
}

TEST(Settle, StepsLeadFromStartToEnd) {
  test::Random random(1);
  const Box box(Vec3(0.3, 0.2, 0.1));
  const std::vector<Fixed> fixed{{cube(), Vec3(0, 0, 0.5 + 1e-5)}};
  for (int i = 0; i < 50; ++i) {
    const Rotation rotation = random.rotation();
    const Pose start{rotation, random.beside(1, 2)};
    const SettleOutcome out = settled(box, start, fixed);
    ASSERT_EQ(out.status, Status::AtRest);
    ASSERT_FALSE(out.steps.empty());
    EXPECT_EQ(out.steps[0].kind, SettleStep::Kind::Fall);
    EXPECT_EQ(out.steps.back().pose_after.translation, out.pose.translation);
    double height = start.translation.z();
    for (const SettleStep& s : out.steps) height -= s.energy_drop;
    EXPECT_NEAR(height, out.pose.translation.z(), 1e-9);
  }
}

}  // namespace
}  // namespace trivet
