// Refusals of PUT, which change nothing.
#include <gtest/gtest.h>

#include "core/scene/transaction.h"
#include "ops/operations/arrangements.h"
#include "ops/operations/perform.h"

namespace trivet {
namespace {

using test::about, test::add_box, test::add_fixed, test::box_triangles, test::Room;

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
  room.expect_refused(room.object, {{}, Vec3(1.1, 0, 3)},
                      {"\"object\" slides or tips off what is below it"});
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
  EXPECT_EQ(room.scene.at(room.object).state, ObjectState::Unsupported);
  EXPECT_EQ(room.scene.at(room.object).least_friction, kInfinity);
  EXPECT_TRUE(room.scene.at(room.object).contacts.empty());
  const Scene before = room.scene;
  EXPECT_FALSE(stand(room.scene, room.object, {{}, Vec3(0, 0, 1)}).ok());
  EXPECT_EQ(test::difference(before, room.scene), "");
}

}  // namespace
}  // namespace trivet
