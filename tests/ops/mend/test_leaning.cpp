// A leaning thing keeps leaning on the same one, and noise makes no level thing lean.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/motion/compose.h"
#include "ops/mend/boxes.h"
#include "ops/mend/mend.h"
#include "ops/placement/clearance.h"

namespace trivet::test {
namespace {

bool is_carried_by(const Scene& scene, ObjectId id, ObjectId by) {
  const auto& contacts = scene.at(id).contacts;
  return std::any_of(contacts.begin(), contacts.end(),
                     [&](const ObjectContact& c) { return c.with == Support(by) && holds_up(c); });
}

/// A book that leans by 20 degrees on a standing one, whose left side is at x = 0.
struct LeaningBook : Boxes {
  ObjectId standing, leaning;

  explicit LeaningBook(double yaw_deg = 0) {
    const Vec3 half(0.012, 0.07, 0.1);
    const Rotation lean =
        (turn_about(Vec3::UnitZ(), yaw_deg) * turn_about(Vec3::UnitY(), 20)).normalized();
    const Vec3 reach = lean.matrix().cwiseAbs() * half;
    standing = add("standing", {0.02, 0.1, 0.12}, {0.02, 0, 0.12});
    leaning = add("leaning", half, {-reach.x(), 0, reach.z()}, false, lean);
    // Both stand a clearance above the floor, and as far from each other.
    const double clearance = clearance_of(scene, {});
    for (const ObjectId id : ids)
      edit_object(scene, id, [&](Object& o) {
        o.pose.translation += clearance * Vec3(id == leaning ? -1 : 0, 0, 1);
      });
    update_contacts(scene);
  }
};

// Friction leaves open how much a steep face bears of the weight: one without which the book would
// fall carries it all the same, whether an edge or a corner touches.
TEST(Leaning, TheBookThatIsLeanedOnCarries) {
  for (const double yaw : {0.0, 0.5, -0.5, 3.0, -3.0}) {
    const LeaningBook s(yaw);
    ASSERT_EQ(s.scene.at(s.leaning).state, ObjectState::Stable) << yaw;
    EXPECT_TRUE(is_carried_by(s.scene, s.leaning, s.standing)) << yaw;
    EXPECT_FALSE(is_carried_by(s.scene, s.standing, s.leaning)) << yaw;
  }
}

TEST(Leaning, ATrueBookStaysToTheBit) {
  LeaningBook s;
  const Scene before = s.scene;
  EXPECT_TRUE(mend_scene(s.scene, {}).moved.empty());
  EXPECT_TRUE(same_bits(before, s.scene));
}

void perturb(Scene& scene, const std::vector<ObjectId>& ids, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  for (const ObjectId id : ids)
    edit_object(scene, id, [&](Object& o) {
      const Vec3 axis = Vec3(normal(random), normal(random), normal(random)).normalized();
      o.pose.rotation = (turn_about(axis, normal(random)) * o.pose.rotation).normalized();
      o.pose.translation += 0.001 * Vec3(normal(random), normal(random), normal(random));
    });
  update_contacts(scene);
}

void expect_mended_near(Scene& scene, int run) {
  const MendedScene out = mend_scene(scene, {});
  EXPECT_TRUE(out.unable.empty()) << run;
  EXPECT_TRUE(is_true(scene)) << run;
  // Six times the median length of the noise.
  for (const SettledObject& o : out.moved) EXPECT_LT(o.moved, 0.0092) << run << ": " << o.name;
}

TEST(Leaning, KeepsLeaningOnTheSameBook) {
  std::mt19937_64 random(5);
  for (int run = 0; run < 20; ++run) {
    LeaningBook s;
    perturb(s.scene, s.ids, random);
    expect_mended_near(s.scene, run);
    EXPECT_TRUE(is_carried_by(s.scene, s.leaning, s.standing)) << run;
  }
}

// One end on the floor, and one on the edge of a block: no column tells of both.
TEST(Leaning, PlankKeepsFloorAndBlock) {
  std::mt19937_64 random(6);
  for (int run = 0; run < 20; ++run) {
    Boxes s;
    const Vec3 half(0.12, 0.04, 0.008);
    const Rotation slope = turn_about(Vec3::UnitY(), -15).normalized();
    // The plank's lower edge is at the origin; its underside meets the block's edge above 0.15.
    const double edge = 0.15, height = edge * slope.matrix()(2, 0) / slope.matrix()(0, 0);
    const ObjectId block =
        s.add("block", {0.03, 0.05, 0.5 * height}, {edge + 0.03, 0, 0.5 * height});
    const ObjectId plank =
        s.add("plank", half, slope.matrix() * Vec3(half.x(), 0, half.z()), false, slope);
    perturb(s.scene, s.ids, random);
    expect_mended_near(s.scene, run);
    EXPECT_TRUE(is_carried_by(s.scene, plank, block)) << run;
    const auto& contacts = s.scene.at(plank).contacts;
    EXPECT_TRUE(std::any_of(contacts.begin(), contacts.end(), [](const ObjectContact& c) {
      return c.with.is_floor() && holds_up(c);
    })) << run;
  }
}

// Many small tilts by chance: those that follow them closely are of noise, too, but not one far
// from them.
TEST(Leaning, TiltsThatFollowEachOtherAreOfNoise) {
  Boxes s;
  const double tilts[] = {0.1, 0.1, 0.1, 0.2, 0.2, 0.3, 0.9, 1.4, 2.1, 3.1, 3.7, 9};
  for (size_t i = 0; i < std::size(tilts); ++i)
    s.add("box " + std::to_string(i), {0.05, 0.05, 0.05}, {0.3 * static_cast<double>(i), 0, 0.051},
          false, turn_about(Vec3::UnitY(), tilts[i]));
  update_contacts(s.scene);
  const Intent intent = infer_intent(s.scene, 0.01);
  EXPECT_NEAR(intent.most_tilt_deg, 3.7, 1e-6);
  for (size_t i = 0; i < std::size(tilts); ++i)
    EXPECT_EQ(intent.find(s.ids[i])->is_level, tilts[i] < 5) << tilts[i];
}

}  // namespace
}  // namespace trivet::test
