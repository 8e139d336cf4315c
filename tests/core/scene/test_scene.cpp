#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/scene/transaction.h"
#include "cube.h"
#include "ops/operations/perform.h"
#include "support/solids.h"

namespace trivet {
namespace {

using test::cube;

TEST(SceneIds, StayUniqueWhenSlotsAreReused) {
  Scene scene;
  const ObjectId a = scene.add(cube("a")), b = scene.add(cube("b"));
  EXPECT_NE(a, b);
  scene.remove(a);
  EXPECT_FALSE(scene.contains(a));
  EXPECT_TRUE(scene.contains(b));
  const ObjectId c = scene.add(cube("c"));
  EXPECT_EQ(c.index, a.index);  // the slot is reused
  EXPECT_NE(c.generation, a.generation);
  EXPECT_FALSE(scene.contains(a));
  EXPECT_TRUE(scene.contains(c));
  EXPECT_EQ(scene.at(c).name, "c");
}

TEST(SceneIds, FollowOrderOfAddition) {
  Scene scene;
  const ObjectId a = scene.add(cube("a")), b = scene.add(cube("b")), c = scene.add(cube("c"));
  EXPECT_EQ(scene.ids(), (std::vector{a, b, c}));
  scene.remove(a);
  const ObjectId d = scene.add(cube("d"));  // in a's slot, but last
  EXPECT_EQ(scene.ids(), (std::vector{b, c, d}));
  scene.remove(b);
  scene.remove(c);
  scene.remove(d);
  EXPECT_TRUE(scene.ids().empty());
}

TEST(SceneIds, RejectInvalidIds) {
  const Scene scene;
  EXPECT_FALSE(scene.contains({}));
  EXPECT_FALSE(scene.contains({7, 1}));
}

TEST(SceneNames, AreFoundAndUnique) {
  Scene scene;
  const ObjectId a = scene.add(cube("a"));
  EXPECT_EQ(scene.find("a"), a);
  EXPECT_EQ(scene.find("b"), std::nullopt);
  EXPECT_EQ(scene.find(""), std::nullopt);
  try {
    scene.add(cube("a"));
    FAIL() << "two objects have one name";
  } catch (const Error& e) {
    EXPECT_EQ(e.kind(), Error::Kind::BadInput);
    EXPECT_NE(std::string(e.what()).find("\"a\""), std::string::npos);
  }
  EXPECT_THROW(scene.add(cube("")), Error);
  EXPECT_EQ(scene.ids().size(), 1u);
  scene.remove(a);
  EXPECT_EQ(scene.find("a"), std::nullopt);
  EXPECT_NO_THROW(scene.add(cube("a")));  // the name is free again
}

TEST(SceneBox, ContainsOnlyPlacedObjects) {
  Scene scene;
  EXPECT_TRUE(scene.box().empty());
  const ObjectId a = scene.add(cube("a"));
  EXPECT_TRUE(scene.box().empty());
  edit_object(scene, a, [](Object& o) {
    o.placed = true;
    o.pose.translation = Vec3(1, 2, 3);
    o.scale = 2;
  });
  EXPECT_LT((scene.box().lower - Vec3(0, 1, 2)).norm(), 1e-6);
  EXPECT_LT((scene.box().upper - Vec3(2, 3, 4)).norm(), 1e-6);
  EXPECT_LT((scene.at(a).centre_of_mass() - Vec3(1, 2, 3)).norm(), 1e-12);
}

// --- contacts --------------------------------------------------------------------------------

void link(Scene& scene, ObjectId id, std::vector<ObjectContact> object_contacts) {
  Transaction transaction(scene);
  transaction.set_contacts(id, std::move(object_contacts));
  transaction.commit();
}

Contact some_contact() {
  Contact c;
  c.points = {{Vec3(1, 2, 3), Vec3::UnitZ(), 1e-6, ContactFeatures::VertexFace, 4, 5},
              {Vec3(1, 3, 3), Vec3::UnitX(), 2e-6, ContactFeatures::FaceVertex, 6, 7},
              {Vec3(1, 4, 3), Vec3::UnitY(), 3e-6, ContactFeatures::EdgeEdge, 8, 9}};
  c.normal = Vec3::UnitZ();
  c.gap = 1e-6;
  c.faces_object = {1, 2};
  c.faces_support = {3};
  return c;
}

TEST(SceneLinks, AppearOnBothSides) {
  Scene scene;
  const ObjectId a = scene.add(cube("a")), b = scene.add(cube("b"));
  link(scene, a, {{b, some_contact()}, {Support::floor(), some_contact()}});
  ASSERT_EQ(scene.at(a).contacts.size(), 2u);
  ASSERT_EQ(scene.at(b).contacts.size(), 1u);  // the floor stores none
  const ObjectContact& mirrored = scene.at(b).contacts[0];
  EXPECT_EQ(mirrored.with, Support(a));
  const Contact& c = mirrored.contact;
  EXPECT_EQ(c.normal, -Vec3::UnitZ());
  EXPECT_EQ(c.gap, 1e-6);
  EXPECT_EQ(c.faces_object, (std::vector<Index>{3}));
  EXPECT_EQ(c.faces_support, (std::vector<Index>{1, 2}));
  EXPECT_EQ(c.points[0].features, ContactFeatures::FaceVertex);
  EXPECT_EQ(c.points[0].feature_object, 5);
  EXPECT_EQ(c.points[0].feature_support, 4);
  EXPECT_EQ(c.points[0].normal, -Vec3::UnitZ());
  EXPECT_EQ(c.points[0].point, Vec3(1, 2, 3));
  EXPECT_EQ(c.points[1].features, ContactFeatures::VertexFace);
  EXPECT_EQ(c.points[2].features, ContactFeatures::EdgeEdge);
  EXPECT_EQ(c.points[2].feature_object, 9);
}

TEST(SceneLinks, AreRestoredByDoubleReversal) {
  const Contact c = some_contact(), twice = reversed(reversed(c));
  EXPECT_EQ(twice.normal, c.normal);
  EXPECT_EQ(twice.faces_object, c.faces_object);
  for (size_t i = 0; i < c.points.size(); ++i) {
    EXPECT_EQ(twice.points[i].features, c.points[i].features);
    EXPECT_EQ(twice.points[i].feature_object, c.points[i].feature_object);
    EXPECT_EQ(twice.points[i].normal, c.points[i].normal);
  }
}

TEST(SceneLinks, AreReplacedAndRemovedOnBothSides) {
  Scene scene;
  const ObjectId a = scene.add(cube("a")), b = scene.add(cube("b")), c = scene.add(cube("c"));
  link(scene, a, {{b, some_contact()}});
  link(scene, c, {{b, some_contact()}});
  EXPECT_EQ(scene.at(b).contacts.size(), 2u);
  link(scene, a, {{c, some_contact()}});  // no longer with b
  ASSERT_EQ(scene.at(b).contacts.size(), 1u);
  EXPECT_EQ(scene.at(b).contacts[0].with, Support(c));
  EXPECT_EQ(scene.at(c).contacts.size(), 2u);
  link(scene, c, {});
  for (const ObjectId id : {a, b, c}) EXPECT_TRUE(scene.at(id).contacts.empty());
  link(scene, a, {{b, some_contact()}});
  scene.remove(b);
  EXPECT_TRUE(scene.at(a).contacts.empty());
}

// --- load-support list -----------------------------------------------------------------------

const LoadSupport::Entry& entry_of(const LoadSupport& list, ObjectId id) {
  for (const LoadSupport::Entry& e : list.entries)
    if (e.object == id) return e;
  throw std::runtime_error("no entry");
}

TEST(LoadSupport, ListsBridgeOfThree) {
  Scene scene;
  const ObjectId left = scene.add(cube("left")), right = scene.add(cube("right"));
  const ObjectId beam =
      scene.add(test::object_of("beam", test::box_triangles(Vec3(1.5, 0.4, 0.1))));
  const ObjectId spare = scene.add(cube("spare"));
  ASSERT_TRUE(put(scene, left, {{}, Vec3(-1, 0, 2)}).ok());
  ASSERT_TRUE(put(scene, right, {{}, Vec3(1, 0, 2)}).ok());
  ASSERT_TRUE(put(scene, beam, {{}, Vec3(0, 0, 4)}).ok());

  const LoadSupport list = load_support(scene);
  ASSERT_EQ(list.entries.size(), 3u);  // the spare one is unplaced
  EXPECT_EQ(list.entries[0].object, left);
  for (const ObjectId id : {left, right}) {
    EXPECT_TRUE(entry_of(list, id).on_floor);
    EXPECT_TRUE(entry_of(list, id).supports.empty());
    EXPECT_EQ(entry_of(list, id).loads, (std::vector{beam}));
  }
  EXPECT_FALSE(entry_of(list, beam).on_floor);
  EXPECT_EQ(entry_of(list, beam).supports, (std::vector{left, right}));
  EXPECT_TRUE(entry_of(list, beam).loads.empty());
  EXPECT_TRUE(scene.contains(spare));
}

TEST(LoadSupport, IgnoresSideContact) {
  Scene scene;
  const ObjectId a = scene.add(cube("a")), b = scene.add(cube("b"));
  for (const ObjectId id : {a, b}) edit_object(scene, id, [](Object& o) { o.placed = true; });
  Contact side;
  side.normal = Vec3::UnitX();
  side.points = {{Vec3::Zero(), Vec3::UnitX(), 1e-6, ContactFeatures::EdgeEdge, 0, 0}};
  link(scene, a, {{b, side}});
  const LoadSupport list = load_support(scene);
  for (const LoadSupport::Entry& e : list.entries) {
    EXPECT_TRUE(e.supports.empty());
    EXPECT_TRUE(e.loads.empty());
    EXPECT_FALSE(e.on_floor);
  }
}

TEST(LoadSupport, AllowsMutualSupportOfTiltedPair) {
  // A hook through an eye: one point carries up, another down.
  Scene scene;
  const ObjectId a = scene.add(cube("a")), b = scene.add(cube("b"));
  for (const ObjectId id : {a, b}) edit_object(scene, id, [](Object& o) { o.placed = true; });
  Contact both;
  both.normal = Vec3::UnitX();
  both.points = {{Vec3::Zero(), Vec3::UnitZ(), 1e-6, ContactFeatures::EdgeEdge, 0, 0},
                 {Vec3::UnitX(), -Vec3::UnitZ(), 1e-6, ContactFeatures::EdgeEdge, 0, 1}};
  link(scene, a, {{b, both}});
  const LoadSupport list = load_support(scene);
  EXPECT_EQ(entry_of(list, a).supports, (std::vector{b}));
  EXPECT_EQ(entry_of(list, a).loads, (std::vector{b}));
  EXPECT_EQ(entry_of(list, b).supports, (std::vector{a}));
}

TEST(SceneTexts, NameStates) {
  EXPECT_STREQ(to_string(ObjectState::Unplaced), "unplaced");
  EXPECT_STREQ(to_string(ObjectState::Fixed), "fixed");
  EXPECT_STREQ(to_string(ObjectState::Stable), "stable");
  EXPECT_STREQ(to_string(ObjectState::Wedged), "wedged");
  EXPECT_STREQ(to_string(ContactType::Area), "area");
}

}  // namespace
}  // namespace trivet
