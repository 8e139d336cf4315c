// PUTs with a known answer: boxes, stacks, heaps, exact ties; and all refusals.

#include <gtest/gtest.h>

#include <cmath>

#include "arrangements.h"
#include "core/scene/transaction.h"
#include "ops/check/check.h"
#include "ops/operations/perform.h"
#include "ops/placement/clearance.h"
#include "ops/placement/verify.h"

namespace trivet {
namespace {

using test::add_fixed;
using test::box_triangles;
using test::object_of;

Rotation about(const Vec3& axis, double angle) {
  return Rotation::about_axis(axis, std::tan(0.5 * angle));
}

ObjectId add_box(Scene& scene, const std::string& name, const Vec3& half) {
  return scene.add(object_of(name, box_triangles(half)));
}

TEST(PutBox, FallsFlatByExactHeight) {
  Scene scene;
  const ObjectId id = add_box(scene, "box", Vec3(0.5, 0.25, 0.125));
  const OperationResult result = test::checked_put(scene, id, {{}, Vec3(1, 2, 3)});
  ASSERT_TRUE(result.ok()) << result.reason();
  ASSERT_EQ(result.num_motions, 1);
  EXPECT_EQ(result.steps[0].kind, SettleStep::Kind::Fall);
  const Object& box = scene.at(id);
  const double clearance = default_clearance(scene);
  EXPECT_EQ(box.pose.translation.head<2>(), Vec2(1, 2));
  EXPECT_NEAR(box.pose.translation.z(), 0.125 + clearance, 0.1 * clearance);
  EXPECT_NEAR(result.steps[0].energy_drop, 3 - box.pose.translation.z(), 1e-12);
  ASSERT_EQ(box.contacts.size(), 1u);
  EXPECT_TRUE(box.contacts[0].with.is_floor());
  EXPECT_EQ(box.contacts[0].contact.type, ContactType::Area);
  EXPECT_EQ(box.contacts[0].contact.hull.size(), 4u);
  EXPECT_NEAR(box.stability_margin, 0.25, 1e-6);
  EXPECT_EQ(box.least_friction, 0);
}

TEST(PutBox, TipsOntoSide) {
  Scene scene;
  const ObjectId id = add_box(scene, "box", Vec3(0.1, 0.1, 0.4));
  // Tilted past its corner: tan(tilt) > 1 / 4.
  const OperationResult result =
      test::checked_put(scene, id, {about(Vec3::UnitY(), 0.3), Vec3(0, 0, 1)});
  ASSERT_TRUE(result.ok()) << result.reason();
  EXPECT_NEAR(scene.at(id).pose.translation.z(), 0.1, 1e-5);
  EXPECT_NEAR(scene.at(id).stability_margin, 0.1, 1e-5);
}

TEST(PutBox, RightsItselfAfterSmallTilt) {
  Scene scene;
  const ObjectId id = add_box(scene, "box", Vec3(0.1, 0.1, 0.4));
  ASSERT_TRUE(test::checked_put(scene, id, {about(Vec3::UnitY(), 0.2), Vec3(0, 0, 1)}).ok());
  EXPECT_NEAR(scene.at(id).pose.translation.z(), 0.4, 1e-5);
}

TEST(PutBox, StaysOverTableEdgeOrFallsOff) {
  for (const double overhang : {0.9, 0.99, 1.01, 1.1}) {  // of half its length
    Scene scene;
    const ObjectId table =
        add_fixed(scene, "table", box_triangles(Vec3(1, 1, 0.5)), Vec3(0, 0, 0.5 + 1e-5));
    const ObjectId id = add_box(scene, "box", Vec3(0.2, 0.1, 0.05));
    const Pose start{{}, Vec3(0.8 + 0.2 * overhang, 0, 2)};
    ASSERT_TRUE(test::checked_put(scene, id, start).ok());
    const Object& box = scene.at(id);
    if (overhang < 1) {
      EXPECT_NEAR(box.pose.translation.z(), 1.05, 1e-4);
      EXPECT_EQ(box.contacts[0].with, Support(table));
      EXPECT_NEAR(box.stability_margin, 0.2 * (1 - overhang), 1e-5);
    } else {
      EXPECT_LT(box.pose.translation.z(), 0.9);
    }
  }
}

TEST(PutModel, StandsUprightWithYUpAndScale) {
  Scene scene;
  Object object = object_of("bottle", test::moved(box_triangles(Vec3(5, 20, 5)), Vec3(0, 20, 0)));
  object.up = UpAxis::Y;
  object.scale = 0.01;
  const ObjectId id = scene.add(object);
  ASSERT_TRUE(test::checked_put(scene, id, {{}, Vec3(0, 0, 1)}).ok());
  EXPECT_NEAR(scene.at(id).pose.translation.z(), 0, 1e-5);
  EXPECT_NEAR(scene.at(id).centre_of_mass().z(), 0.2, 1e-5);
  EXPECT_NEAR(scene.at(id).stability_margin, 0.05, 1e-5);
}

TEST(PutOptions, ClearanceIsGap) {
  for (const double clearance : {1e-3, 1e-4, 1e-5, 3e-7}) {
    Scene scene;
    const ObjectId id = add_box(scene, "box", Vec3(0.5, 0.5, 0.5));
    SettleOptions options;
    options.clearance = clearance;
    ASSERT_TRUE(test::checked_put(scene, id, {{}, Vec3(0, 0, 2)}, options).ok());
    EXPECT_NEAR(scene.at(id).contacts[0].contact.gap, clearance, 1e-12);
  }
}

TEST(PutOnFloor, RaisesTouchingStartToClearance) {
  Scene scene;
  const ObjectId id = add_box(scene, "box", Vec3(0.25, 0.25, 0.25));
  const OperationResult result = put(scene, id, {{}, Vec3(1, 2, 0.25)});
  ASSERT_TRUE(result.ok()) << result.reason();
  EXPECT_GT(scene.at(id).contacts[0].contact.gap, 0);
  EXPECT_TRUE(check_scene(scene).ok());
}

TEST(PutAgain, MovesObjectAndItsLinks) {
  Scene scene;
  const ObjectId table =
      add_fixed(scene, "table", box_triangles(Vec3(1, 1, 0.5)), Vec3(0, 0, 0.5 + 1e-5));
  const ObjectId id = add_box(scene, "box", Vec3(0.2, 0.2, 0.2));
  ASSERT_TRUE(test::checked_put(scene, id, {{}, Vec3(0, 0, 2)}).ok());
  EXPECT_EQ(scene.at(table).contacts.size(), 1u);
  ASSERT_TRUE(test::checked_put(scene, id, {{}, Vec3(3, 0, 2)}).ok());
  EXPECT_TRUE(scene.at(table).contacts.empty());
  EXPECT_NEAR(scene.at(id).pose.translation.z(), 0.2, 1e-4);
}

TEST(PutWithoutFloor, LandsOnTable) {
  Scene scene;
  scene.floor = false;
  add_fixed(scene, "table", box_triangles(Vec3(1, 1, 0.5)), Vec3(0, 0, -7));
  const ObjectId id = add_box(scene, "box", Vec3(0.2, 0.2, 0.2));
  ASSERT_TRUE(test::checked_put(scene, id, {{}, Vec3(0, 0, 2)}).ok());
  EXPECT_NEAR(scene.at(id).pose.translation.z(), -6.3, 1e-4);
}

TEST(PutBeneath, FitsUnderTable) {
  // The fall begins at the start pose, not at the top of the scene.
  Scene scene;
  add_fixed(scene, "top", box_triangles(Vec3(1, 1, 0.05)), Vec3(0, 0, 1));
  const ObjectId id = add_box(scene, "box", Vec3(0.2, 0.2, 0.2));
  ASSERT_TRUE(test::checked_put(scene, id, {{}, Vec3(0, 0, 0.6)}).ok());
  EXPECT_NEAR(scene.at(id).pose.translation.z(), 0.2, 1e-4);
}

// --- several objects -------------------------------------------------------------------------

TEST(PutStack, StacksTwelveBoxes) {
  Scene scene;
  test::Random random(7);
  std::vector<ObjectId> boxes;
  for (int i = 0; i < 12; ++i) {
    boxes.push_back(add_box(scene, "box " + std::to_string(i), Vec3(0.2, 0.15, 0.05)));
    const Vec3 at = random.beside(0.02, 0.1 * i + 0.3);
    const OperationResult result =
        test::checked_put(scene, boxes[i], {about(Vec3::UnitZ(), random.uniform(-1, 1)), at});
    ASSERT_TRUE(result.ok()) << result.reason();
    EXPECT_LE(result.num_motions, 3);
    EXPECT_NEAR(scene.at(boxes[i]).pose.translation.z(), 0.1 * i + 0.05, 1e-4);
    EXPECT_EQ(scene.at(boxes[i]).contacts[0].contact.type, ContactType::Area);
  }
  EXPECT_TRUE(check_scene(scene, 0, 0, test::perfect_friction()).ok());
  const LoadSupport list = load_support(scene);
  ASSERT_EQ(list.entries.size(), boxes.size());
  for (size_t i = 0; i < boxes.size(); ++i) {
    EXPECT_EQ(list.entries[i].on_floor, i == 0);
    EXPECT_EQ(list.entries[i].supports.size(), i > 0 ? 1u : 0u);
    if (i > 0) {
      EXPECT_EQ(list.entries[i].supports[0], boxes[i - 1]);
    }
    EXPECT_EQ(list.entries[i].loads.size(), i + 1 < boxes.size() ? 1u : 0u);
  }
}

Scene heap(int num, bool boxes) {
  Scene scene;
  test::Random random(8);
  for (int i = 0; i < num; ++i) {
    const ObjectId id = boxes ? add_box(scene, std::to_string(i), Vec3(0.06, 0.045, 0.03))
                              : scene.add(object_of(std::to_string(i), test::some_shape(i, 0.15)));
    const Vec3 at = random.beside(0.1, 1.5);
    const OperationResult result = test::checked_put(scene, id, {random.rotation(), at});
    EXPECT_TRUE(result.ok()) << i << ": " << result.reason();
  }
  return scene;
}

void expect_no_interpenetration(const Scene& scene) {
  const SceneCheck check = check_scene(scene);
  EXPECT_TRUE(check.crossings.empty());
  EXPECT_TRUE(check.float32_crossings.empty());
  EXPECT_TRUE(check.contained.empty());
}

TEST(PutHeap, IsDeterministicForTwentyBoxes) {
  const Scene first = heap(20, true), second = heap(20, true);
  expect_no_interpenetration(first);
  EXPECT_EQ(first.ids().size(), 20u);
  const auto ids = first.ids();
  for (size_t i = 0; i < ids.size(); ++i)
    EXPECT_EQ(first.at(ids[i]).pose.translation, second.at(ids[i]).pose.translation);
  EXPECT_GT(first.box().upper.z(), 0.15);  // a heap, not a layer
}

TEST(PutHeap, HandlesMixedShapes) {
  const Scene scene = heap(24, false);
  expect_no_interpenetration(scene);
  EXPECT_GT(scene.box().upper.z(), 0.15);
}

TEST(PutHeap, KeepsEveryBoxAtRestUnderLoads) {
  const Scene scene = heap(20, true);
  for (const std::string& name : check_scene(scene, 0, 0, test::perfect_friction()).not_at_rest)
    ADD_FAILURE() << name << " is not at rest";
}

// --- exact ties ------------------------------------------------------------------------------

struct Tie {
  const char* name;
  test::Triangles triangles;
  Rotation rotation;
  double height;  // of the centre at rest
};

TEST(PutTie, IsBrokenOnFloor) {
  const double to_diagonal = std::acos(1 / std::sqrt(3.0));
  const Vec3 across = Vec3(1, -1, 0).normalized();
  const test::Triangles cube = box_triangles(Vec3(0.5, 0.5, 0.5));
  const double facet = 0.25 * std::cos(M_PI / 24);
  const test::Triangles cylinder = test::cylinder(0.25, 1, 24);
  const std::vector<Tie> ties{
      {"cube on a vertex", cube, about(across, to_diagonal), 0.5},
      {"cube on another vertex", cube, about(across, to_diagonal - M_PI), 0.5},
      {"cube on an edge", cube, about(Vec3::UnitX(), M_PI / 4), 0.5},
      {"cube on an edge, turned", cube, about(Vec3::UnitZ(), 0.3) * about(Vec3::UnitY(), M_PI / 4),
       0.5},
      {"cylinder on a facet's edge", cylinder, about(Vec3::UnitY(), M_PI / 2), facet},
      {"cylinder on its rim", cylinder, about(Vec3::UnitY(), std::atan(0.5)), 0.5},
  };
  for (const Tie& tie : ties) {
    SCOPED_TRACE(tie.name);
    Scene scene;
    const ObjectId id = scene.add(object_of("object", tie.triangles));
    const OperationResult result = test::checked_put(scene, id, {tie.rotation, Vec3(0, 0, 2)});
    ASSERT_TRUE(result.ok()) << result.reason();
    EXPECT_GT(scene.at(id).stability_margin, 0.01);
    const double height = scene.at(id).centre_of_mass().z();
    EXPECT_TRUE(std::abs(height - tie.height) < 1e-4 || std::abs(height - facet) < 1e-4) << height;
  }
}

TEST(PutTie, IsBrokenExactlyOverTableEdge) {
  Scene scene;
  add_fixed(scene, "table", box_triangles(Vec3(1, 1, 0.5)), Vec3(0, 0, 0.5 + 1e-5));
  const ObjectId id = add_box(scene, "box", Vec3(0.25, 0.125, 0.0625));
  const OperationResult result = test::checked_put(scene, id, {{}, Vec3(1, 0, 2)});
  ASSERT_TRUE(result.ok()) << result.reason();
}

TEST(PutTie, TiltsStickBalancedOnRidge) {
  Scene scene;
  add_fixed(scene, "ridge", test::prism({{-0.25, 0}, {0.25, 0}, {0, 0.5}}, 1), Vec3(0, 0, 1e-5));
  const ObjectId id = add_box(scene, "stick", Vec3(0.5, 0.0625, 0.0625));
  const OperationResult result = test::checked_put(scene, id, {{}, Vec3(0, 0, 2)});
  ASSERT_TRUE(result.ok()) << result.reason();
  // It tilts until it lies flat on one of the slopes, held by friction.
  EXPECT_NEAR(scene.at(id).centre_of_mass().z(), 0.5 + 0.0625 / std::sqrt(5.0), 1e-3);
  EXPECT_NEAR(scene.at(id).least_friction, 2, 0.2);
}

TEST(PutTie, TiltsBoxOnTipOfAnother) {
  Scene scene;
  const double tip = std::sqrt(3.0) / 2;
  add_fixed(scene, "tip", box_triangles(Vec3(0.5, 0.5, 0.5)), Vec3(0, 0, tip + 1e-5),
            about(Vec3(1, -1, 0).normalized(), std::acos(1 / std::sqrt(3.0))));
  const ObjectId id = add_box(scene, "box", Vec3(0.5, 0.5, 0.125));
  const OperationResult result = test::checked_put(scene, id, {{}, Vec3(0, 0, 3)});
  ASSERT_TRUE(result.ok()) << result.reason();
  // It tilts until it lies flat on one of the faces below the tip, held by friction.
  EXPECT_NEAR(scene.at(id).centre_of_mass().z(), 2 * tip + 0.125 / std::sqrt(3.0), 1e-3);
  EXPECT_NEAR(scene.at(id).least_friction, std::sqrt(2.0), 0.15);
}

// --- refusals --------------------------------------------------------------------------------

/// A table with a box on it, and an object that is not placed.
struct Room {
  Scene scene;
  ObjectId table, box, object;

  Room() {
    table = add_fixed(scene, "table", box_triangles(Vec3(1, 1, 0.5)), Vec3(0, 0, 0.5 + 1e-5));
    box = add_box(scene, "box", Vec3(0.25, 0.25, 0.25));
    EXPECT_TRUE(put(scene, box, {{}, Vec3(0, 0, 2)}).ok());
    object = add_box(scene, "object", Vec3(0.125, 0.125, 0.125));
  }

  /// Expects a refusal with `words`, and no change.
  void expect_refused(ObjectId id, const Pose& start, const std::vector<std::string>& words,
                      const SettleOptions& options = {}) {
    const Scene before = scene;
    const OperationResult result = put(scene, id, start, options);
    EXPECT_EQ(result.status, OperationResult::Status::Refused);
    for (const std::string& word : words)
      EXPECT_NE(result.reason().find(word), std::string::npos) << result.reason();
    EXPECT_EQ(test::difference(before, scene), "");
  }
};

TEST(PutRefuses, CrossingStart) {
  Room room;
  room.expect_refused(room.object, {{}, Vec3(0.3, 0, 1.3)}, {"\"object\"", "\"box\"", "start"});
  room.expect_refused(room.object, {{}, Vec3(0, 0, 1)}, {"\"object\"", "\"table\""});
}

TEST(PutRefuses, ExactlyTouchingStart) {
  Scene scene;
  scene.floor = false;
  add_fixed(scene, "table", box_triangles(Vec3(1, 1, 0.5)), Vec3(0, 0, -0.5));
  const ObjectId id = add_box(scene, "object", Vec3(0.25, 0.25, 0.25));
  EXPECT_FALSE(test::checked_put(scene, id, {{}, Vec3(0, 0, 0.25)}).ok());
}

TEST(PutRefuses, StartInsideClosedBox) {
  Room room;
  room.expect_refused(room.object, {{}, room.scene.at(room.box).pose.translation},
                      {"\"object\" is inside \"box\""});
}

TEST(PutRefuses, StartAroundAnotherObject) {
  Room room;
  room.scene.floor = false;
  const ObjectId large = add_box(room.scene, "large", Vec3(3, 3, 3));
  room.expect_refused(large, {{}, Vec3(0, 0, 0.5)}, {"\"table\" is inside \"large\""});
}

TEST(PutRefuses, StartBelowFloor) {
  Room room;
  room.expect_refused(room.object, {{}, Vec3(5, 0, 0.1)}, {"\"object\"", "floor"});
  room.expect_refused(room.object, {{}, Vec3(5, 0, -3)}, {"\"object\"", "floor"});
}

TEST(PutRefuses, EndlessFall) {
  Room room;
  room.scene.floor = false;
  room.expect_refused(room.object, {{}, Vec3(5, 0, 3)}, {"nothing is below \"object\""});
  // Falls onto the table's edge first, then off it.
  room.expect_refused(room.object, {{}, Vec3(1.1, 0, 3)}, {"nothing is below \"object\""});
}

TEST(Put, StandsFixedObjectOnce) {
  Room room;
  const ObjectId id =
      room.scene.add(test::object_of("shelf", test::box_triangles(Vec3(0.1, 0.1, 0.1)), true));
  const OperationResult result = put(room.scene, id, {{}, Vec3(5, 0, 3)});
  ASSERT_TRUE(result.ok()) << result.reason();
  EXPECT_TRUE(room.scene.at(id).placed);
  EXPECT_EQ(room.scene.at(id).state, ObjectState::Fixed);
  EXPECT_NEAR(room.scene.at(id).pose.translation.z(), 0.1, 1e-4);
  room.expect_refused(id, {{}, Vec3(0, 0, 5)}, {"\"shelf\" is fixed"});
}

TEST(PutRefuses, FixedObject) {
  Room room;
  room.expect_refused(room.table, {{}, Vec3(0, 0, 5)}, {"\"table\" is fixed"});
}

TEST(PutRefuses, ObjectWithImmovableLoad) {
  Room room;
  ASSERT_TRUE(put(room.scene, room.object, {{}, Vec3(0, 0, 3)}).ok());  // onto the box
  edit_object(room.scene, room.object, [](Object& o) { o.locked = true; });
  room.expect_refused(room.box, {{}, Vec3(5, 0, 3)},
                      {"\"object\" is locked and would have to move along"});
}

TEST(PutRefuses, InvalidClearance) {
  Room room;
  for (const double clearance : {1e-13, 0.1}) {
    SettleOptions options;
    options.clearance = clearance;
    room.expect_refused(room.object, {{}, Vec3(0, 0, 3)}, {"clearance"}, options);
  }
}

TEST(PutRefuses, MoreMotionsThanAllowed) {
  Room room;
  SettleOptions few;
  few.max_motions = 1;
  room.expect_refused(room.object, {about(Vec3(1, 2, 3).normalized(), 1), Vec3(5, 0, 3)},
                      {"\"object\"", "1 motions"}, few);
}

TEST(PutRefuses, KeepsPoseOfPlacedObject) {
  Room room;
  room.expect_refused(room.box, {{}, Vec3(0, 0, 0.5)}, {"\"box\"", "\"table\""});
  EXPECT_TRUE(room.scene.at(room.box).placed);
}

TEST(Stand, ChecksWithoutSettling) {
  Room room;
  OperationResult result = stand(room.scene, room.object, {{}, Vec3(3, 0, 0.125 + 1e-6)});
  ASSERT_TRUE(result.ok()) << result.reason();
  EXPECT_EQ(room.scene.at(room.object).state, ObjectState::Stable);
  EXPECT_EQ(result.num_motions, 0);
  result = stand(room.scene, room.object, {{}, Vec3(3, 0, 7)});  // in the air
  ASSERT_TRUE(result.ok());
  EXPECT_EQ(room.scene.at(room.object).state, ObjectState::Wedged);
  EXPECT_EQ(room.scene.at(room.object).least_friction, kInfinity);
  EXPECT_TRUE(room.scene.at(room.object).contacts.empty());
  const Scene before = room.scene;
  EXPECT_FALSE(stand(room.scene, room.object, {{}, Vec3(0, 0, 1)}).ok());
  EXPECT_EQ(test::difference(before, room.scene), "");
}

TEST(CheckScene, FindsViolations) {
  Room room;
  EXPECT_TRUE(check_scene(room.scene).ok());
  ASSERT_TRUE(put(room.scene, room.object, {{}, Vec3(0, 0, 3)}).ok());
  EXPECT_TRUE(check_scene(room.scene).ok());
  const Vec3 good = room.scene.at(room.object).pose.translation;
  const auto move_to = [&](const Vec3& at) {
    edit_object(room.scene, room.object, [&](Object& o) { o.pose.translation = at; });
  };
  move_to(good + Vec3(0, 0, 0.5));  // hovers
  EXPECT_EQ(check_scene(room.scene).not_at_rest, std::vector<std::string>{"object"});
  move_to(room.scene.at(room.box).pose.translation);
  ASSERT_EQ(check_scene(room.scene).contained.size(), 1u);
  EXPECT_EQ(check_scene(room.scene).contained[0].a, "object");
  EXPECT_EQ(check_scene(room.scene).contained[0].b, "box");
  move_to(Vec3(5, 0, 0.1));  // in the floor
  ASSERT_EQ(check_scene(room.scene).crossings.size(), 1u);
  EXPECT_EQ(check_scene(room.scene).crossings[0].b, "floor");
  EXPECT_EQ(check_scene(room.scene).crossings[0].count, 4);
  move_to(good - Vec3(0, 0, 3e-3));
  EXPECT_GT(check_scene(room.scene).interpenetrating_pairs(), 0);
  EXPECT_FALSE(check_scene(room.scene).ok());
}

TEST(CheckScene, IsTheSameWithAnyNumberOfThreads) {
  Scene scene = heap(16, false);
  const auto lift = [&](size_t i, double by) {
    edit_object(scene, scene.ids()[i], [&](Object& o) { o.pose.translation.z() += by; });
  };
  lift(3, 0.02);  // into something, perhaps
  lift(9, -0.02);
  const SceneCheck one = check_scene(scene, 1, 0, test::perfect_friction());
  EXPECT_FALSE(one.ok());
  for (const int threads : {0, 2, 8}) {
    const SceneCheck many = check_scene(scene, threads, 0, test::perfect_friction());
    EXPECT_EQ(many.not_at_rest, one.not_at_rest);
    EXPECT_EQ(many.smallest_gap, one.smallest_gap);
    ASSERT_EQ(many.crossings.size(), one.crossings.size());
    for (size_t i = 0; i < one.crossings.size(); ++i) {
      EXPECT_EQ(many.crossings[i].a, one.crossings[i].a);
      EXPECT_EQ(many.crossings[i].b, one.crossings[i].b);
      EXPECT_EQ(many.crossings[i].count, one.crossings[i].count);
    }
  }
}

TEST(CheckScene, UpdateContactsAgreesWithPut) {
  Scene scene = heap(8, false);
  const Scene before = scene;
  update_contacts(scene, 0, test::perfect_friction());
  for (const ObjectId id : scene.ids()) {
    EXPECT_EQ(scene.at(id).state, before.at(id).state);
    EXPECT_EQ(scene.at(id).contacts.size(), before.at(id).contacts.size());
  }
}

}  // namespace
}  // namespace trivet
