// Objects thinner than what contacts are known to.

#include <gtest/gtest.h>

#include "ops/operations/perform.h"
#include "support/settle_options.h"
#include "support/solids.h"

namespace trivet::test {
namespace {

// Both long edges of a needle's underside count as one line, about which it can turn to one side or
// the other: it rocked, lifted again after every other turn, until no lift was left.
TEST(Needle, ComesToRestSoonHoweverThin) {
  for (const double width : {1e-6, 3e-6, 1e-5})
    for (const double turn : {0.0, 0.15, 0.3}) {
      Scene scene;
      const ObjectId box = scene.add(object_of("box", box_triangles(Vec3(0.6, 0.3, 0.1)), true));
      ASSERT_TRUE(stand(scene, box, {Rotation{}, Vec3(0, 0, 0.1 + 1e-5)}).ok());
      const ObjectId needle =
          scene.add(object_of("needle", box_triangles(Vec3(0.5, width / 2, width / 2))));
      const Pose start{Rotation::about_axis(Vec3::UnitZ(), turn), Vec3(0, 0.05, 0.5)};
      const OperationResult result = put(scene, needle, start, test::perfect_friction());
      EXPECT_TRUE(result.ok()) << width << " " << turn << " " << result.reason();
      EXPECT_LT(result.num_motions, 60) << width << " " << turn;
      EXPECT_EQ(scene.at(needle).state, ObjectState::Stable);
      EXPECT_NEAR(scene.at(needle).pose.translation.z(), 0.2, 1e-4);
    }
}

}  // namespace
}  // namespace trivet::test
