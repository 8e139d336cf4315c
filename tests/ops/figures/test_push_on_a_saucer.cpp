// The paper's Fig. 17: a spoon is pushed along a saucer.
#include "replay.h"

namespace trivet {
namespace {

using test::kFigureClearance;
using test::Stage;

PushOperation push_to(const Vec2& to, bool settle) {
  PushOperation o;
  o.object = "spoon";
  o.to = to;
  o.settle = settle;
  return o;
}

// The direction has two dimensions, the path three: at every stop, the spoon is as high as if it
// had been lowered there from above, by all pairs of faces.
TEST(Figure17, PushesSpoonAlongSaucer) {
  Stage s;
  s.fix("saucer", test::dish(0.08, 0.02, 0.004, 2, 48), {0, 0, 1e-5});
  const ObjectId id = s.scene.add(test::object_of("spoon", test::stick(0.1)));
  ASSERT_TRUE(put(s.scene, id, {{}, Vec3(0.01, 0, 0.1)}, test::figure_options()).ok());
  double lowest = kInfinity, highest = 0;
  for (const Vec2& to : {Vec2(0.02, 0.015), Vec2(0.03, 0), Vec2(-0.02, 0.02), Vec2(0, -0.04)}) {
    Stage held = s;
    OperationResult result = perform(held.scene, push_to(to, false), test::figure_options());
    ASSERT_TRUE(result.ok()) << result.reason();
    EXPECT_EQ(result.end, OperationResult::End::Reached);
    const Pose& end = held.at("spoon").pose;
    EXPECT_NEAR((end.translation.head<2>() - to).norm(), 0, 2 * kFigureClearance);
    Pose above = end;
    above.translation.z() += 0.1;
    const double expected = test::dropped(held.scene, "spoon", above).translation.z();
    EXPECT_NEAR(end.translation.z(), expected, 3 * kFigureClearance);
    lowest = std::min(lowest, expected), highest = std::max(highest, expected);

    Stage let_go = s;
    result = perform(let_go.scene, push_to(to, true), test::figure_options());
    ASSERT_TRUE(result.ok()) << result.reason();
    EXPECT_EQ(let_go.at("spoon").state, ObjectState::Stable);
    EXPECT_TRUE(check_scene(let_go.scene, 1, kFigureClearance, test::figure_options()).ok());
  }
  EXPECT_GT(highest - lowest, 0.002);  // it has gone up and down
}

}  // namespace
}  // namespace trivet
