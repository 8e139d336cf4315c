// Rest with a reserve of friction (SettleOptions::robust).

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cstdio>

#include "ops/check/check.h"
#include "ops/friction/analytic.h"
#include "ops/operations/perform.h"
#include "ops/stability/stability.h"
#include "support/effort.h"
#include "support/random_shapes.h"
#include "support/same_scene.h"

namespace trivet::test {
namespace {

SettleOptions robust() {
  SettleOptions options;
  options.clearance = kEps;
  options.robust = true;
  return options;
}

SettleOptions just_at_rest() {
  SettleOptions options = robust();
  options.robust = false;
  return options;
}

bool stands_at(const Scene& scene, double friction) {
  StabilityOptions options;
  options.clearance = kEps;
  options.friction = friction;
  return stability(scene, options).stable();
}

// tan(slope) between 0.7 and 1 of the friction: it stays by the friction alone.
TEST(Robust, SlidesWhereOnlyAllFrictionHolds) {
  const double mu = 0.5, just = std::atan(0.4) * 180 / M_PI, well = std::atan(0.3) * 180 / M_PI;
  for (const double slope : {just, well})
    for (const bool is_robust : {false, true}) {
      Stage stage(mu);
      const ObjectId block = stage.add_on_slope(slope, box(0.2, 0.2, 0.2), 0.1);
      const Pose start = {stage.scene.at(block).pose.rotation,
                          stage.scene.at(block).pose.translation + Vec3(0, 0, 0.01)};
      edit_object(stage.scene, block, [](Object& o) { o.placed = false; });
      const OperationResult result =
          put(stage.scene, block, start, is_robust ? robust() : just_at_rest());
      ASSERT_TRUE(result.ok()) << result.reason();
      const double fell = start.translation.z() - stage.scene.at(block).pose.translation.z();
      EXPECT_EQ(fell > 0.02, is_robust && slope == just) << slope << " fell " << fell;
      EXPECT_TRUE(stands_at(stage.scene, is_robust ? kRobustFriction * mu : mu));
    }
}

constexpr int kThings = 8;

// Boxes and plates let go over each other. @return how many were placed.
int pour(Stage& stage, unsigned seed, const SettleOptions& options) {
  Random random(seed);
  int num_placed = 0;
  for (int i = 0; i < kThings; ++i) {
    const double x = random.uniform(0.02, 0.1), y = random.uniform(0.02, 0.1);
    const ObjectId id = stage.add(box_triangles({x, y, random.uniform(0.01, 0.1)}), Vec3::Zero());
    edit_object(stage.scene, id, [](Object& o) { o.placed = false; });
    PutOperation o;
    o.object = stage.scene.at(id).name;
    o.start.rotation = random.rotation();
    o.start.translation = random.beside(0.08, 1);
    o.tries = 12;
    num_placed += perform(stage.scene, Operation(o), options).ok();
  }
  return num_placed;
}

// Every rest of a heap holds by the part of its friction that may be needed; without the rule many
// do not.
TEST(Robust, HeapsStandWithReserve) {
  const int num = with_effort(60);
  int num_placed = 0, num_just = 0;
  for (int k = 0; k < num; ++k) {
    SCOPED_TRACE(k);
    Stage stage(0.5), other(0.5);
    num_placed += pour(stage, 100 + k, robust());
    EXPECT_TRUE(stands_at(stage.scene, kRobustFriction * 0.5));
    EXPECT_EQ(check_scene(stage.scene, 1, kEps).interpenetrating_pairs(), 0);
    pour(other, 100 + k, just_at_rest());
    num_just += !stands_at(other.scene, kRobustFriction * 0.5);
  }
  std::printf("%d of %d placed with reserve; %d of %d heaps have none without the rule\n",
              num_placed, num * kThings, num_just, num);
  EXPECT_GE(num_placed, 0.98 * num * kThings);
  EXPECT_GE(num_just, num / 10);
}

TEST(Robust, GivesTheSameBitsWithAnyNumberOfThreads) {
  std::vector<Scene> scenes;
  for (const int threads : {1, 2, 4}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    Stage stage(0.5);
    pour(stage, 7, robust());
    scenes.push_back(stage.scene);
  }
  EXPECT_EQ(difference(scenes[0], scenes[1]), "");
  EXPECT_EQ(difference(scenes[0], scenes[2]), "");
}

// There is no floor below the slope, so that what slides is refused.
TEST(Robust, RefusesWhatNothingWouldHoldWithReserve) {
  const double slope = std::atan(0.4) * 180 / M_PI;
  Stage stage(0.5, false);
  const ObjectId block = stage.add_on_slope(slope, box(0.2, 0.2, 0.2), 0.1);
  const Pose start = {stage.scene.at(block).pose.rotation,
                      stage.scene.at(block).pose.translation + Vec3(0, 0, 0.01)};
  edit_object(stage.scene, block, [](Object& o) { o.placed = false; });
  const Scene before = stage.scene;
  EXPECT_FALSE(put(stage.scene, block, start, robust()).ok());
  EXPECT_EQ(difference(stage.scene, before), "");
  EXPECT_TRUE(put(stage.scene, block, start, just_at_rest()).ok());
}

}  // namespace
}  // namespace trivet::test
