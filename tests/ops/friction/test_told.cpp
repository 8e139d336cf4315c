// Reports of rest in pairs, bins and heaps of real models by the default rules: who carries,
// how much friction holds, and that no pose is refused as wedged where it rests.
//
// TRIVET_TEST_EFFORT=50 judges 1,000 PUTs of pairs and 50 bins.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "apps/demo/demo.h"
#include "core/base/tunables.h"
#include "core/io/read_model.h"
#include "core/scene/transaction.h"
#include "ops/check/check.h"
#include "ops/files/layout/run.h"
#include "ops/operations/perform.h"
#include "ops/placement/clearance.h"
#include "ops/stability/stability.h"
#include "support/effort.h"
#include "support/random_shapes.h"
#include "support/real_models.h"
#include "support/shared_data.h"
#include "support/solids.h"

namespace trivet::test {
namespace {

const Object& real(int number) {
  static std::map<int, Object> objects;
  const auto it = objects.find(number);
  if (it != objects.end()) return it->second;
  const RealModel& m = kRealModels[number];
  Object object;
  Model loaded = read_model(shared_data("models/") + m.file);
  object.shape = make_shape(loaded.mesh);
  object.model = std::make_shared<const Model>(std::move(loaded));
  object.scale = m.scale;
  object.up = m.up;
  return objects.emplace(number, std::move(object)).first->second;
}

ObjectId add_real(Scene& scene, Random& random, const std::string& name) {
  Object object = real(random.integer(0, static_cast<int>(std::size(kRealModels)) - 1));
  object.name = name;
  return scene.add(std::move(object));
}

double top_of(const Scene& scene) { return scene.box().empty() ? 0 : scene.box().upper.z(); }

// Lets an object go in any orientation, above all that is there.
OperationResult drop(Scene& scene, Random& random, ObjectId id, double reach, int tries,
                     const SettleOptions& options = {}) {
  const Object& object = scene.at(id);
  PutOperation put;
  put.object = object.name;
  put.start.rotation = random.rotation();
  const Aabb box = body_of(object, put.start).world_box;
  const double x = random.uniform(-reach, reach), y = random.uniform(-reach, reach);
  put.start.translation = Vec3(x, y, top_of(scene) + 0.02 + box.half_extent().z()) - box.centre();
  put.tries = tries;
  return perform(scene, put, options);
}

// --- who carries -------------------------------------------------------------------------------

/// Counts, so that the test cannot pass by finding nothing.
struct Told {
  int objects = 0, supports = 0, lifted = 0;
  int across_gaps = 0;  // objects that something carries which they do not touch
};

using Carriers = std::map<std::string, std::vector<Support>>;

// By links, and by the forces that balance the whole: both are in reports.
Carriers carriers_of(const Scene& scene) {
  Carriers out;
  const auto add = [&](ObjectId id, const Support& by) {
    auto& all = out[scene.at(id).name];
    if (std::find(all.begin(), all.end(), by) == all.end()) all.push_back(by);
  };
  for (const LoadSupport::Entry& e : load_support(scene).entries) {
    if (e.on_floor) add(e.object, Support::floor());
    for (const ObjectId id : e.supports) add(e.object, Support(id));
  }
  for (const CarriedBy& c : carried_by_forces(scene, stability(scene))) add(c.object, c.by);
  return out;
}

void expect_lift_takes_along(const Scene& scene, ObjectId support, const std::string& load,
                             Told& told) {
  const Object& object = scene.at(support);
  if (object.fixed) return;
  Scene copy = scene;
  const OperationResult lifted =
      perform(copy, TranslateOperation{{{object.name}}, Vec3(0, 0, 0.004)});
  if (!lifted.ok()) return;
  ++told.lifted;
  EXPECT_TRUE(std::find(lifted.carried.begin(), lifted.carried.end(), load) != lifted.carried.end())
      << object.name << " leaves " << load << " behind";
}

// PICK-UP and PUSH know what it lies on, too; and once it was lifted, it is held.
void expect_lies_on_something(const Scene& scene, const Object& object) {
  Scene copy = scene;
  PickUpOperation up;
  up.object = object.name;
  up.distance = 0.004;
  const OperationResult lifted = perform(copy, up);
  if (lifted.ok() && lifted.moved > kBalanceTolerance * default_clearance(copy)) {
    EXPECT_NE(copy.at(*copy.find(object.name)).state, ObjectState::Stable) << object.name;
  } else if (!lifted.ok()) {
    EXPECT_NE(lifted.refusal->cause, Refusal::Cause::LiesOnNothing) << lifted.reason();
  }
  copy = scene;
  PushOperation push;
  push.object = object.name;
  push.distance = 0.01;
  const OperationResult pushed = perform(copy, push);
  const bool is_lost = !pushed.ok() && pushed.refusal->cause == Refusal::Cause::NothingToSlideOn;
  EXPECT_FALSE(is_lost) << pushed.reason();
}

void expect_told(const Scene& scene, Told& told) {
  const Carriers carriers = carriers_of(scene);
  for (const ObjectId id : scene.ids()) {
    const Object& object = scene.at(id);
    if (!object.placed || object.fixed || object.state != ObjectState::Stable) continue;
    ++told.objects;
    told.across_gaps +=
        std::any_of(object.contacts.begin(), object.contacts.end(),
                    [](const ObjectContact& entry) { return entry.across_gap && entry.carries; });
    EXPECT_LE(object.least_friction, object.material.friction) << object.name;
    const auto found = carriers.find(object.name);
    ASSERT_TRUE(found != carriers.end()) << object.name << " is held by nothing";
    told.supports += static_cast<int>(found->second.size());
    expect_lies_on_something(scene, object);
    for (const Support& by : found->second)
      if (by.is_object()) expect_lift_takes_along(scene, by.object(), object.name, told);
  }
}

void tell(const char* what, const Told& told) {
  std::printf("%s: %d objects, %d carried across gaps, %d supports, %d of them lifted\n", what,
              told.objects, told.across_gaps, told.supports, told.lifted);
}

/// An open box of 0.5 m, of five plates, fixed.
void add_bin(Scene& scene) {
  const auto wall = [](const Vec3& half, const Vec3& at) { return moved(box_triangles(half), at); };
  Triangles all = wall({0.25, 0.25, 0.005}, {0, 0, 0.005});
  for (const double side : {-1.0, 1.0}) {
    all = joined(all, wall({0.005, 0.25, 0.15}, {0.255 * side, 0, 0.15}));
    all = joined(all, wall({0.26, 0.005, 0.15}, {0, 0.255 * side, 0.15}));
  }
  const ObjectId id = scene.add(object_of("bin", all, true));
  ASSERT_TRUE(stand(scene, id, {{}, {0, 0, 1e-4}}).ok());
}

/// Eight real models in a bin, or in a heap where the number is odd. @return those placed.
int fill(Scene& scene, int number) {
  Random random(100 + number);
  if (number % 2 == 0) add_bin(scene);
  int placed = 0;
  for (int i = 0; i < 8; ++i) {
    const ObjectId id = add_real(scene, random, "o" + std::to_string(i));
    placed += drop(scene, random, id, 0.1, kTriesOfPut).ok();
  }
  return placed;
}

TEST(Told, InBinsAndHeapsOfRealModels) {
  TRIVET_NEEDS_DATA("models/contactdb_bowl.stl");
  Told told;
  int num_placed = 0;
  const int num = std::max(1, with_effort(2));
  for (int k = 0; k < num; ++k) {
    SCOPED_TRACE(k);
    Scene scene;
    num_placed += fill(scene, k);
    expect_told(scene, told);
  }
  tell("bins and heaps", told);
  EXPECT_GE(num_placed, 0.98 * 8 * num);
  EXPECT_GE(told.lifted, told.objects / 10);
}

// An object that others hold alone, but that leans on a third one as the whole stands.
TEST(Told, ByForcesOfTheWholeAlone) {
  TRIVET_NEEDS_DATA("models/contactdb_bowl.stl");
  Told told;
  Scene scene;
  EXPECT_EQ(fill(scene, 41), 8);
  expect_told(scene, told);
  int num_unlinked = 0;
  for (const CarriedBy& c : carried_by_forces(scene, stability(scene)))
    for (const ObjectContact& entry : scene.at(c.object).contacts)
      num_unlinked += entry.with == c.by && !holds_up(entry);
  tell("a bin", told);
  std::printf("%d carriers are known by the forces of the whole alone\n", num_unlinked);
  EXPECT_GE(num_unlinked, 1);  // otherwise the scene shows nothing
}

TEST(Told, InDemos) {
  Told told;
  for (const std::string& name : demo_names()) {
    SCOPED_TRACE(name);
    const DemoLayout demo = make_demo(name);
    const ModelSource source = [&](const std::string& file, const Tessellation&) {
      return demo.model(file);
    };
    expect_told(run_layout(demo.layout, source, {}).scene, told);
  }
  tell("demos", told);
  EXPECT_GT(told.lifted, 5);
}

// --- wedged ------------------------------------------------------------------------------------

// A pose that was refused as wedged is not at rest by a check either.
TEST(Told, WedgedOnlyWhereCheckFindsNoRest) {
  TRIVET_NEEDS_DATA("models/contactdb_bowl.stl");
  Told told;
  int num_wedged = 0, num_done = 0;
  const int num = with_effort(20);
  for (int k = 0; k < num; ++k) {
    SCOPED_TRACE(k);
    Random random(1000 + k);
    Scene scene;
    const ObjectId below = add_real(scene, random, "below");
    if (!drop(scene, random, below, 0, kTriesOfPut).ok()) continue;
    edit_object(scene, below, [](Object& o) { o.fixed = true, o.state = ObjectState::Fixed; });
    const ObjectId load = add_real(scene, random, "load");
    Random same = random;
    const OperationResult result = drop(scene, random, load, 0.05, 1);
    if (result.ok()) {
      ++num_done;
      expect_told(scene, told);
    } else if (result.refusal->cause == Refusal::Cause::Wedged) {
      ++num_wedged;
      SettleOptions accept;
      accept.accept_wedged = true;
      const OperationResult again = drop(scene, same, load, 0.05, 1, accept);
      const bool rests = again.ok() && check_scene(scene, 1).not_at_rest.empty();
      EXPECT_FALSE(rests) << result.reason();
    }
  }
  tell("pairs", told);
  std::printf("%d of %d PUTs done, %d refused as wedged\n", num_done, num, num_wedged);
  EXPECT_GT(num_done, num / 2);
}

}  // namespace
}  // namespace trivet::test
