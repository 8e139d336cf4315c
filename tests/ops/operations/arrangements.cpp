#include "ops/operations/arrangements.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/tunables.h"
#include "core/motion/compose.h"
#include "ops/check/check.h"
#include "ops/operations/perform.h"
#include "ops/placement/clearance.h"
#include "ops/settle/friction_settling.h"

namespace trivet::test {
namespace {

/// The object above the scene, with random rotation, `beside` the middle.
Arrangement above(std::string name, Scene scene, const Triangles& triangles, const Vec3& beside,
                  int index) {
  Random random(1000 + static_cast<unsigned>(index));
  Arrangement out{std::move(name), std::move(scene), {}, {random.rotation(), beside}};
  const Object object = object_of("object", triangles);
  out.start.translation.z() =
      std::max(0.0, out.scene.box().empty() ? 0.0 : out.scene.box().upper.z()) +
      object.shape->mesh.box().diagonal() + 0.1;
  out.object = out.scene.add(object);
  return out;
}

Vec3 small_offset(int index, double half) {
  Random random(2000 + static_cast<unsigned>(index));
  return random.beside(half, 0);
}

}  // namespace

ObjectId add_fixed(Scene& scene, const std::string& name, const Triangles& triangles,
                   const Vec3& at, const Rotation& rotation) {
  const ObjectId id = scene.add(object_of(name, triangles, true));
  const OperationResult result = stand(scene, id, {rotation, at});
  EXPECT_TRUE(result.ok()) << result.reason();
  return id;
}

Triangles some_shape(int index, double size) {
  switch (index % 8) {
    case 0:
      return box_triangles(Vec3(0.5, 0.35, 0.25) * size);
    case 1:
      return tetrahedron(0.7 * size);
    case 2:
      return cylinder(0.25 * size, 0.8 * size, 24);
    case 3:
      return cylinder(0.5 * size, 0.06 * size, 32);  // a plate
    case 4:
      return torus(0.35 * size, 0.12 * size, 20, 10);
    case 5:
      return ball(0.4 * size, 8, 12);
    case 6:
      return stick(size);
    default:
      return hook(0.6 * size, 0.15 * size, 0.05 * size);
  }
}

Arrangement on_floor(int index) {
  return above("floor", {}, some_shape(index, 0.3), small_offset(index, 0.5), index);
}

Arrangement stick_on_saucer(int index) {
  Scene scene;
  add_fixed(scene, "saucer", dish(0.15, 0.03, 0.006, 1.5, 24), Vec3(0, 0, 1e-5));
  return above("saucer", std::move(scene), stick(0.2), small_offset(index, 0.1), index);
}

Arrangement into_bowl(int index) {
  Scene scene;
  add_fixed(scene, "bowl", dish(0.3, 0.25, 0.01, 1.3, 24), Vec3(0, 0, 1e-5));
  return above("bowl", std::move(scene), some_shape(index, 0.15), small_offset(index, 0.12), index);
}

Arrangement torus_over_peg(int index) {
  Scene scene;
  add_fixed(scene, "peg",
            revolved({{0, 0}, {0.2, 0}, {0.2, 0.02}, {0.03, 0.03}, {0.02, 0.4}, {0, 0.42}}, 16),
            Vec3(0, 0, 1e-5));
  Arrangement out =
      above("peg", std::move(scene), torus(0.1, 0.03, 20, 10), small_offset(index, 0.04), index);
  if (index % 2)  // nearly level: falls over the peg
    out.start.rotation = Rotation::about_axis(Vec3::UnitX(), 0.02 * (index % 5));
  return out;
}

Arrangement on_two_heights(int index) {
  Scene scene;
  add_fixed(scene, "low", box_triangles(Vec3(0.1, 0.2, 0.1)), Vec3(-0.18, 0, 0.1 + 1e-5));
  add_fixed(scene, "high", box_triangles(Vec3(0.1, 0.2, 0.16)), Vec3(0.18, 0.02, 0.16 + 1e-5));
  return above("two heights", std::move(scene), some_shape(index, 0.5), small_offset(index, 0.15),
               index);
}

Arrangement against_wall(int index) {
  Scene scene;
  add_fixed(scene, "wall", box_triangles(Vec3(0.05, 1, 0.5)), Vec3(-0.05, 0, 0.5 + 1e-5));
  Arrangement out = above("wall", std::move(scene), some_shape(index, 0.3),
                          Vec3(0.1 + 0.01 * (index % 7), 0, 0), index);
  return out;
}

Arrangement into_wedge(int index) {
  constexpr double kSlope[3] = {0.5, 1.0, 1.3};  // from the horizontal
  const double run = 0.4, rise = run * std::tan(kSlope[index % 3]);
  Scene scene;
  add_fixed(scene, "left", prism({{-run, 0}, {0, 0}, {-run, rise}}, 0.5), Vec3(-1e-4, 0, 1e-5));
  add_fixed(scene, "right", prism({{0, 0}, {run, 0}, {run, rise}}, 0.5), Vec3(1e-4, 0, 1e-5));
  return above("wedge", std::move(scene), some_shape(index, 0.2), small_offset(index, 0.08), index);
}

Arrangement hook_on_bar(int index) {
  Scene scene;
  const double radius = 0.01 + 0.005 * (index % 3);
  Triangles bar = rod({{-0.5, 0, 0}, {0.5, 0, 0}}, radius, index % 2 ? 4 : 12);
  add_fixed(scene, "bar", bar, Vec3(0, 0, 0.6), Rotation::about_axis(Vec3::UnitZ(), 1));
  // The bar runs along y through the bend; the hook's plane is turned against it a little.
  Arrangement out{"hook", std::move(scene), {}, {}};
  out.object = out.scene.add(object_of("object", hook(0.2, 0.05, 0.01)));
  Random random(3000 + static_cast<unsigned>(index));
  out.start.rotation = Rotation::about_axis(Vec3::UnitZ(), random.uniform(-0.2, 0.2)) *
                       Rotation::about_axis(Vec3::UnitY(), random.uniform(-0.05, 0.05));
  out.start.translation = Vec3(-0.05, random.uniform(-0.3, 0.3), 0.6 - 0.01);
  return out;
}

Arrangement onto_ball(int index) {
  Scene scene;
  add_fixed(scene, "ball", ball(0.3, 10, 16), Vec3(0, 0, 0.3 + 1e-5));
  return above("ball", std::move(scene), some_shape(index, 0.3), small_offset(index, 0.1), index);
}

Arrangement onto_slope(int index) {
  constexpr double kSlope[3] = {0.2, 0.6, 1.0};
  const double run = 0.6, rise = run * std::tan(kSlope[index % 3]);
  Scene scene;
  add_fixed(scene, "slope", prism({{-run, 0}, {run, 0}, {run, 2 * rise}}, 0.6), Vec3(0, 0, 1e-5));
  return above("slope", std::move(scene), some_shape(index, 0.2), small_offset(index, 0.2), index);
}

// --- invariants ------------------------------------------------------------------------------

namespace {

Vec3 centre_at(const Object& object, const Pose& pose) {
  return world_from_object(pose, object.up, object.scale).apply(object.shape->mass.centre);
}

void expect_falling_energy(const Object& object, const Pose& start, double clearance,
                           const OperationResult& result) {
  Pose pose = start;
  for (const SettleStep& step : result.steps) {
    const double drop = centre_at(object, pose).z() - centre_at(object, step.pose_after).z();
    EXPECT_NEAR(drop, step.energy_drop, 1e-3 * clearance);
    if (step.kind == SettleStep::Kind::Lift)
      EXPECT_GE(drop, -kLargestSeparatingMotion * clearance);
    else
      EXPECT_GE(step.energy_drop, kLastEnergyDrop * clearance);
    pose = step.pose_after;
  }
}

// A link is of contacts within their tolerance; or of what carries by the forces that balance an
// object that leans, within the tolerance of balance.
void expect_consistent(const ObjectContact& entry, double clearance) {
  EXPECT_FALSE(entry.contact.points.empty());
  EXPECT_TRUE(!entry.across_gap || entry.carries || entry.is_carried) << "a link for nothing";
  const double tolerance = entry.across_gap ? kCarryingTolerance : kContactTolerance;
  for (const ContactPoint& p : entry.contact.points) {
    EXPECT_GT(p.gap, entry.across_gap ? kContactTolerance * clearance : 0);
    EXPECT_LE(p.gap, tolerance * clearance);
  }
}

bool ends_where_its_steps_do(const Object& object, const OperationResult& result) {
  return !result.steps.empty() && is_same_pose(result.steps.back().pose_after, object.pose);
}

void expect_consistent(const Scene& scene, ObjectId id, double clearance,
                       const OperationResult& result) {
  const Object& object = scene.at(id);
  EXPECT_TRUE(object.placed);
  EXPECT_EQ(object.state, ObjectState::Stable);
  EXPECT_FALSE(object.contacts.empty());
  // Its own steps are all motions there were, unless the whole gave way after it had settled.
  const int num_steps = static_cast<int>(result.steps.size());
  if (ends_where_its_steps_do(object, result) && result.gave_way.empty())
    EXPECT_EQ(result.num_motions, num_steps);
  else
    EXPECT_GT(result.num_motions, num_steps);
  EXPECT_GE(result.num_queries, result.num_motions);
  for (const ObjectContact& entry : object.contacts) expect_consistent(entry, clearance);
  EXPECT_TRUE(std::any_of(
      object.contacts.begin(), object.contacts.end(),
      [](const ObjectContact& entry) { return !entry.across_gap && holds_up(entry.contact); }))
      << "nothing within the tolerance of contacts bears on it from below";
}

}  // namespace

OperationResult checked_put(Scene& scene, ObjectId id, const Pose& start,
                            const SettleOptions& options) {
  const Scene before = scene;
  const double clearance = options.clearance > 0
                               ? options.clearance
                               : default_clearance(scene, expected_box(scene, scene.at(id), start));
  const OperationResult result = put(scene, id, start, options);
  if (!has_finite_friction(options)) expect_falling_energy(scene.at(id), start, clearance, result);
  if (has_finite_friction(options) && result.ok()) {
    EXPECT_LE(scene.at(id).centre_of_mass().z(), centre_at(before.at(id), start).z());
  }
  if (!result.ok()) {
    EXPECT_FALSE(result.reason().empty());
    EXPECT_EQ(difference(before, scene), "");
    return result;
  }
  EXPECT_TRUE(result.reason().empty());
  expect_consistent(scene, id, clearance, result);
  const SceneCheck check = check_scene(scene, 1, clearance, options);
  EXPECT_TRUE(check.crossings.empty());
  EXPECT_TRUE(check.float32_crossings.empty());
  EXPECT_TRUE(check.contained.empty());
  for (const std::string& name : check.not_at_rest)
    EXPECT_NE(name, scene.at(id).name) << "it is not at rest";
  return result;
}

OperationResult put_twice(Arrangement& a, const SettleOptions& options) {
  Scene again = a.scene;
  const OperationResult result = checked_put(a.scene, a.object, a.start, options);
  const OperationResult second = put(again, a.object, a.start, options);
  EXPECT_EQ(result.status, second.status);
  EXPECT_EQ(result.reason(), second.reason());
  EXPECT_EQ(result.steps.size(), second.steps.size());
  EXPECT_EQ(difference(a.scene, again), "");
  return result;
}

Rotation about(const Vec3& axis, double angle) {
  return Rotation::about_axis(axis, std::tan(0.5 * angle));
}

ObjectId add_box(Scene& scene, const std::string& name, const Vec3& half) {
  return scene.add(object_of(name, box_triangles(half)));
}

Scene heap(int num, bool boxes) {
  Scene scene;
  Random random(8);
  for (int i = 0; i < num; ++i) {
    const ObjectId id = boxes ? add_box(scene, std::to_string(i), Vec3(0.06, 0.045, 0.03))
                              : scene.add(object_of(std::to_string(i), some_shape(i, 0.15)));
    const Vec3 at = random.beside(0.1, 1.5);
    const OperationResult result = checked_put(scene, id, {random.rotation(), at});
    EXPECT_TRUE(result.ok()) << i << ": " << result.reason();
  }
  return scene;
}

Room::Room() {
  table = add_fixed(scene, "table", box_triangles(Vec3(1, 1, 0.5)), Vec3(0, 0, 0.5 + 1e-5));
  box = add_box(scene, "box", Vec3(0.25, 0.25, 0.25));
  EXPECT_TRUE(put(scene, box, {{}, Vec3(0, 0, 2)}).ok());
  object = add_box(scene, "object", Vec3(0.125, 0.125, 0.125));
}

void Room::expect_refused(ObjectId id, const Pose& start, const std::vector<std::string>& words,
                          const SettleOptions& options) {
  const Scene before = scene;
  const OperationResult result = put(scene, id, start, options);
  EXPECT_EQ(result.status, OperationResult::Status::Refused);
  for (const std::string& word : words)
    EXPECT_NE(result.reason().find(word), std::string::npos) << result.reason();
  EXPECT_EQ(difference(before, scene), "");
}

}  // namespace trivet::test
