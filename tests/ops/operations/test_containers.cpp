// The container in which a PUT stays.
#include <gtest/gtest.h>

#include "bins.h"
#include "ops/operations/container.h"

namespace trivet::test {
namespace {

bool is_same_place(const Scene& scene, const Vec3& a, const Vec3& b, double size = 0.1) {
  return Container(scene, {}, a, size).holds(b);
}

TEST(Container, EndsAtWalls) {
  for (const bool fixed : {false, true}) {
    Scene scene;
    add_at(scene, "bin", bin(0.4, 0.2, 0.002), {1, 2, 1e-4}, fixed);
    const Vec3 centre(1, 2, 0.5);
    EXPECT_TRUE(is_same_place(scene, centre, {1.15, 2.15, 0.05}));
    EXPECT_TRUE(is_same_place(scene, centre, {0.81, 2, 0.3}));
    EXPECT_FALSE(is_same_place(scene, centre, {1.25, 2, 0.05}));
    EXPECT_FALSE(is_same_place(scene, centre, {1.3, 2.3, 0.3}));
    EXPECT_FALSE(is_same_place(scene, {1, 2, 0.1}, {1.25, 2, 0.1})) << "from below the rim";
    EXPECT_FALSE(is_same_place(scene, {1.25, 2, 0.5}, {1.15, 2, 0.05}) && fixed)
        << "into a fixed one";
  }
}

TEST(Container, IsNotWhatLiesInHeap) {
  Scene scene;
  add_at(scene, "piece", box_triangles({0.05, 0.05, 0.05}), {0, 0, 0.0501}, false);
  EXPECT_TRUE(is_same_place(scene, {0, 0, 0.5}, {0.1, 0, 0.05}));
}

// A bowl that leans on a block holds things by chance. A fixed one is meant to.
TEST(Container, IsNoBowlThatLeans) {
  Scene scene;
  add_at(scene, "block", box_triangles({0.1, 0.3, 0.1}), {0, 0, 0.1001}, false);
  const ObjectId id = scene.add(object_of("bowl", dish(0.3, 0.15, 0.01, 2, 48)));
  PutOperation put{{"bowl"}, {{}, Vec3(0.35, 0, 0.5)}};
  ASSERT_TRUE(perform(scene, put).ok());
  ASSERT_EQ(scene.at(id).contacts.size(), 2u) << "the floor and the block";
  const Vec3 inside = scene.at(id).centre_of_mass() + Vec3(0, 0, 0.5);
  const Vec3 beside(inside.x(), 0.5, 0.05);
  EXPECT_TRUE(is_same_place(scene, inside, beside));
  Transaction transaction(scene);
  transaction.edit(id, [](Object& object) { object.fixed = true; });
  transaction.commit();
  EXPECT_FALSE(is_same_place(scene, inside, beside));
}

TEST(Container, IsTableTopOnFourLegs) {
  Scene scene;
  for (int k = 0; k < 4; ++k)
    add_at(scene, "leg " + std::to_string(k), box_triangles({0.03, 0.03, 0.35}),
           {k % 2 ? 0.4 : -0.4, k < 2 ? 0.4 : -0.4, 0.3501}, false);
  add_at(scene, "top", box_triangles({0.5, 0.5, 0.02}), {0, 0, 0.7202}, false);
  EXPECT_TRUE(is_same_place(scene, {0.4, 0, 1}, {0.45, 0.1, 0.75}));
  EXPECT_FALSE(is_same_place(scene, {0.45, 0, 1}, {0.55, 0, 0.05}));
}

TEST(Container, IsTableWhoeverHoldsIt) {
  for (const bool fixed : {false, true}) {
    Scene scene;
    add_at(scene, "table", box_triangles({0.5, 0.5, 0.35}), {0, 0, 0.3501}, fixed);
    EXPECT_TRUE(is_same_place(scene, {0.4, 0, 1}, {0.45, 0.1, 0.75}));
    EXPECT_FALSE(is_same_place(scene, {0.45, 0, 1}, {0.55, 0, 0.05}));
    EXPECT_TRUE(is_same_place(scene, {0.55, 0, 0.1}, {0.6, 0, 0.05})) << "on the floor beside";
  }
}

TEST(Container, IsBowlUpToItsRim) {
  Scene scene;
  add_at(scene, "bowl", dish(0.3, 0.15, 0.01, 2, 48), {0, 0, 1e-4}, false);
  EXPECT_TRUE(is_same_place(scene, {0, 0, 0.5}, {0.2, 0.1, 0.1}));
  EXPECT_FALSE(is_same_place(scene, {0, 0, 0.5}, {0.35, 0, 0.05}));
}

TEST(Container, IsRoomBetweenSeparateWalls) {
  Scene scene;
  add_at(scene, "wall", box_triangles({0.01, 1, 1}), {0.5, 0, 1.001}, true);
  EXPECT_FALSE(is_same_place(scene, {0.4, 0, 0.5}, {0.6, 0, 0.5}));
  EXPECT_TRUE(is_same_place(scene, {0.4, 0, 0.5}, {0.4, 0.5, 0.5}));
  EXPECT_FALSE(is_same_place(scene, {0.4, 0, 3}, {0.6, 0, 0.5})) << "over the wall";
}

}  // namespace
}  // namespace trivet::test
