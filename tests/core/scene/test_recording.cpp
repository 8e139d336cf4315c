// Recording of changes, with undo and redo.
#include <gtest/gtest.h>

#include "core/scene/scene.h"
#include "support/same_scene.h"
#include "support/solids.h"

namespace trivet {
namespace {

Object cube(const std::string& name) {
  return test::object_of(name, test::box_triangles(Vec3(0.5, 0.5, 0.5)));
}

Contact contact_at(double x) {
  Contact c;
  c.points = {{Vec3(x, 0, 0), Vec3::UnitZ(), 1e-6, ContactFeatures::VertexFace, 1, 2}};
  return c;
}

TEST(SceneRecording, IsEmptyWithoutChanges) {
  Scene scene;
  const ObjectId a = scene.add(cube("a"));
  scene.start_recording();
  std::as_const(scene).at(a);
  EXPECT_TRUE(scene.stop_recording().empty());
}

TEST(SceneRecording, HoldsOnlyTouchedObjects) {
  Scene scene;
  const ObjectId a = scene.add(cube("a")), b = scene.add(cube("b")), c = scene.add(cube("c"));
  scene.add(cube("d"));
  scene.link(a, {{b, contact_at(1)}});
  scene.start_recording();
  scene.link(a, {{c, contact_at(2)}});  // b loses a contact, c gets one
  EXPECT_EQ(scene.stop_recording().ids(), (std::vector{a, b, c}));
}

TEST(SceneRecording, UndoesAndRedoesPosesAndLinksBitwise) {
  Scene scene;
  const ObjectId a = scene.add(cube("a")), b = scene.add(cube("b"));
  scene.link(a, {{b, contact_at(1)}});
  const Scene before = scene;
  scene.start_recording();
  scene.at(a).pose.translation = Vec3(1, 2, 3);
  scene.at(a).placed = true;
  scene.link(b, {{std::nullopt, contact_at(3)}, {a, contact_at(4)}});
  SceneChange change = scene.stop_recording();
  const Scene after = scene;
  for (int round = 0; round < 3; ++round) {
    scene.exchange(change);
    EXPECT_EQ(test::difference(scene, before), "");
    scene.exchange(change);
    EXPECT_EQ(test::difference(scene, after), "");
  }
}

TEST(SceneRecording, RestoresRemovedObjectsWithIdsLinksAndOrder) {
  Scene scene;
  const ObjectId a = scene.add(cube("a")), b = scene.add(cube("b")), c = scene.add(cube("c"));
  scene.link(a, {{b, contact_at(1)}, {c, contact_at(2)}});
  const Scene before = scene;
  scene.start_recording();
  scene.remove(a);
  const ObjectId d = scene.add(cube("d"));  // in a's slot
  EXPECT_EQ(d.index, a.index);
  SceneChange change = scene.stop_recording();
  scene.exchange(change);
  EXPECT_EQ(test::difference(scene, before), "");
  EXPECT_TRUE(scene.contains(a));
  EXPECT_FALSE(scene.contains(d));
  EXPECT_EQ(scene.ids(), (std::vector{a, b, c}));
  EXPECT_EQ(scene.at(b).links.size(), 1u);
  scene.exchange(change);
  EXPECT_TRUE(scene.contains(d));
  EXPECT_EQ(scene.at(d).name, "d");
  EXPECT_TRUE(scene.at(b).links.empty());
}

TEST(SceneRecording, NeverReusesIdOfUndoneObject) {
  Scene scene;
  scene.start_recording();
  const ObjectId a = scene.add(cube("a"));
  SceneChange change = scene.stop_recording();
  scene.exchange(change);
  EXPECT_FALSE(scene.contains(a));
  const ObjectId b = scene.add(cube("b"));
  EXPECT_EQ(b.index, a.index);
  EXPECT_NE(b, a);
  EXPECT_FALSE(scene.contains(a));
}

}  // namespace
}  // namespace trivet
