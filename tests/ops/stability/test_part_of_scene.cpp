// Verdicts on the part of one object beside that on the whole scene.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "core/base/tunables.h"
#include "ops/check/check.h"
#include "ops/settle/friction_settling.h"
#include "ops/stability/stability.h"
#include "support/effort.h"
#include "support/solids.h"

namespace trivet::test {
namespace {

constexpr double kTowerGap = 1e-6;

double uniform(std::mt19937& random, double from, double to) {
  return from + (to - from) * static_cast<double>(random()) / std::mt19937::max();
}

void place(Scene& scene, const Vec3& half, const Vec3& at, bool fixed = false) {
  Object object =
      object_of("box" + std::to_string(scene.num_objects()), box_triangles(half), fixed);
  object.pose.translation = at;
  object.placed = true;
  scene.add(std::move(object));
}

// Towers of boxes side by side, of which some topple; some next to each other touch, and some are
// so near that only the linear program sees a contact.
Scene random_towers(std::mt19937& random) {
  Scene scene;
  double x = 0;
  for (int tower = 0; tower < 6; ++tower) {
    double z = 0.1 + kTowerGap, at = x;
    const int height = 1 + static_cast<int>(random() % 4);
    for (int k = 0; k < height; ++k) {
      place(scene, Vec3(0.5, 0.5, 0.1), Vec3(at, 0, z), k == 0 && random() % 4 == 0);
      at += uniform(random, -0.55, 0.55);
      z += 0.2 + kTowerGap;
    }
    x += random() % 2 == 0 ? 3 : 1 + kTowerGap * uniform(random, 0.5, 1.2 * kCarryingTolerance);
  }
  update_contacts(scene, kTowerGap);
  return scene;
}

std::vector<ContactForce> forces_on(const Stability& found, ObjectId object) {
  std::vector<ContactForce> out;
  for (const ContactForce& f : found.forces)
    if (f.on == object) out.push_back(f);
  return out;
}

void expect_same(const Stability& part, const Stability& whole, const ObjectStability& of_whole) {
  const auto found =
      std::find_if(part.objects.begin(), part.objects.end(),
                   [&](const ObjectStability& o) { return o.object == of_whole.object; });
  ASSERT_NE(found, part.objects.end());
  EXPECT_EQ(found->weight, of_whole.weight);
  EXPECT_EQ(found->topples, of_whole.topples);
  EXPECT_EQ(found->marginal, of_whole.marginal);
  EXPECT_EQ(found->margin, of_whole.margin);
  EXPECT_EQ(found->motion.velocity, of_whole.motion.velocity);
  EXPECT_EQ(found->motion.spin, of_whole.motion.spin);
  const std::vector<ContactForce> a = forces_on(part, of_whole.object),
                                  b = forces_on(whole, of_whole.object);
  ASSERT_EQ(a.size(), b.size());
  for (size_t i = 0; i < a.size(); ++i) {
    EXPECT_TRUE(a[i].from == b[i].from);
    EXPECT_EQ(a[i].point, b[i].point);
    EXPECT_EQ(a[i].force, b[i].force);
  }
}

TEST(StabilityOfPart, IsThatOfTheWholeSceneToTheBit) {
  int num_objects = 0, num_topple = 0, num_smaller = 0;
  for (int round = 0; round < with_effort(40); ++round) {
    SCOPED_TRACE(round);
    std::mt19937 random(round);
    const Scene scene = random_towers(random);
    StabilityOptions options;
    options.clearance = kTowerGap;
    const Stability whole = stability(scene, options);
    for (const ObjectStability& object : whole.objects) {
      const Stability part = stability_of_part(scene, object.object, options);
      expect_same(part, whole, object);
      ++num_objects;
      num_topple += object.topples;
      num_smaller += part.objects.size() < whole.objects.size();
    }
  }
  EXPECT_GT(num_topple, num_objects / 40);
  EXPECT_GT(num_smaller, num_objects / 2);
}

TEST(StabilityOfPart, IsEmptyForWhatIsFixedOrNotPlaced) {
  Scene scene;
  place(scene, Vec3(0.5, 0.5, 0.1), Vec3(0, 0, 0.1 + kTowerGap), true);
  const ObjectId out = scene.add(object_of("out", box_triangles(Vec3(1, 1, 1))));
  EXPECT_TRUE(stability_of_part(scene, scene.ids().front()).objects.empty());
  EXPECT_TRUE(stability_of_part(scene, out).objects.empty());
}

}  // namespace
}  // namespace trivet::test
