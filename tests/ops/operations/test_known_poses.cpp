// PUTs with a known answer: boxes, stacks, heaps, exact ties.

#include <gtest/gtest.h>

#include <cmath>

#include "core/scene/transaction.h"
#include "ops/check/check.h"
#include "ops/operations/arrangements.h"
#include "ops/operations/perform.h"
#include "ops/placement/clearance.h"
#include "ops/placement/verify.h"

namespace trivet {
namespace {

using test::about, test::add_box, test::add_fixed, test::heap;
using test::box_triangles;
using test::object_of;

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

}  // namespace
}  // namespace trivet
