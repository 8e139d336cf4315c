// A plank across a post with a weight let go over its free end: it tips, the weight slides down on
// it, and both come to rest on post and floor. Last they close gaps of some clearances together.

#include <algorithm>

#include "ops/operations/stage.h"
#include "ops/stability/stability.h"

namespace trivet {
namespace {

using test::box_triangles;
using test::Stage;

/// A post of 1 m, fixed, with a plank of 4 m across its top.
struct PlankOnPost : Stage {
  PlankOnPost(double gap, double density) {
    fix("post", box_triangles(Vec3(0.5, 0.5, 0.5)), {0, 0, 0.5});
    const ObjectId plank = scene.add(test::object_of("plank", box_triangles(Vec3(2, 0.25, 0.05))));
    edit("plank", [&](Object& o) { o.material.density = density; });
    const OperationResult result = stand(scene, plank, {{}, Vec3(0, 0, 1.05 + gap)});
    EXPECT_TRUE(result.ok()) << result.reason();
    scene.add(test::object_of("weight", box_triangles(Vec3(0.5, 0.5, 0.5))));
    edit("weight", [](Object& o) { o.material.density = 5000; });
  }

  OperationResult put_weight(double x) {
    PutOperation o;
    o.object = "weight", o.start = {{}, Vec3(x, 0, 3)}, o.tries = 1;
    return perform(scene, o, options);
  }

  // Carriers are not asked for: some planks balance on an edge, and merely touch the weight.
  void expect_rest() const {
    for (const char* name : {"plank", "weight"})
      EXPECT_EQ(at(name).state, ObjectState::Stable) << name;
    EXPECT_EQ(check_scene(scene, 1, 0, options).interpenetrating_pairs(), 0);
    EXPECT_TRUE(stability(scene).stable());
  }
};

TEST(Plank, GivesWayUnderAWeightOnItsFreeEnd) {
  PlankOnPost s(3e-6, 1000);
  const OperationResult result = s.put_weight(1.5);
  ASSERT_TRUE(result.ok()) << result.reason();
  ASSERT_EQ(result.gave_way.size(), 1u);
  EXPECT_EQ(result.gave_way[0].name, "plank");
  s.expect_rest();
}

// A start may use up its work. While motions went on beyond the gaps that they were to close 94 of
// 240 did.
TEST(Plank, GivesWayAtAlmostAllPlaces) {
  int num = 0, num_refused = 0;
  for (const double density : {1000., 4000.})
    for (const double gap : {1e-6, 3e-6, 5e-6})
      for (int k = 10; k < 20; ++k)
        for (const double side : {1., -1.}) {
          PlankOnPost s(gap, density);
          const std::string before = test::snapshot(s.scene);
          const OperationResult result = s.put_weight(side * k / 10);
          ++num;
          if (result.ok()) {
            ASSERT_EQ(result.gave_way.size(), 1u);
            EXPECT_EQ(result.gave_way[0].name, "plank");
            s.expect_rest();
            continue;
          }
          ++num_refused;
          EXPECT_EQ(test::snapshot(s.scene), before);
          EXPECT_EQ(result.refusal->cause, Refusal::Cause::Topples);
          for (const char* name : {"\"plank\"", "\"weight\""})
            EXPECT_NE(result.reason().find(name), std::string::npos) << result.reason();
        }
  EXPECT_EQ(num, 120);
  EXPECT_LE(num_refused, 18);
}

}  // namespace
}  // namespace trivet
