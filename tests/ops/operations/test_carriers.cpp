// The load-support list names what carries, by forces and across gaps; lifting a support takes its
// load along.
#include <gtest/gtest.h>

#include "ops/operations/stage.h"
#include "ops/settle/friction_settling.h"

namespace trivet::test {
namespace {

std::vector<std::string> supports_of(const Scene& scene, const std::string& name) {
  std::vector<std::string> out;
  for (const LoadSupport::Entry& e : load_support(scene).entries) {
    if (scene.at(e.object).name != name) continue;
    if (e.on_floor) out.push_back("floor");
    for (const ObjectId id : e.supports) out.push_back(scene.at(id).name);
  }
  return out;
}

using Names = std::vector<std::string>;

/// A plank over two blocks, touching the left one and some clearances above the right one.
struct Bridge : Stage {
  double unit = 0;

  explicit Bridge(double num_clearances) {
    options.clearance = unit = 1e-6;
    for (const double x : {-0.5, 0.5}) {
      const std::string name = x < 0 ? "left" : "right";
      const double gap = x < 0 ? 1.5 * unit : num_clearances * unit;
      const ObjectId id = scene.add(object_of(name, box_triangles({0.1, 0.1, 0.25})));
      EXPECT_TRUE(stand(scene, id, {{}, {x, 0, 0.25 + 1.2 * unit}}, options).ok());
      tops.push_back(scene.world_box(id).upper.z() + gap);
    }
    plank = scene.add(object_of("plank", box_triangles({0.6, 0.05, 0.02})));
    // Turned so that it is so far above the left block's outer and the right one's inner edge.
    const double slope = tops[1] - tops[0];  // of a metre
    const Pose pose{Rotation::about_axis(-Vec3::UnitY(), slope / 2),
                    {0, 0, 0.02 + tops[0] + 0.6 * slope}};
    const OperationResult result = stand(scene, plank, pose, options);
    EXPECT_TRUE(result.ok()) << result.reason();
  }
  std::vector<double> tops;
  ObjectId plank;
};

TEST(Carriers, ReachAcrossGaps) {
  for (const double gap : {1.5, 4.0, 6.5}) {
    SCOPED_TRACE(gap);
    Bridge bridge(gap);
    ASSERT_EQ(bridge.at("plank").state, ObjectState::Stable);
    EXPECT_EQ(supports_of(bridge.scene, "plank"), (Names{"left", "right"}));
    EXPECT_LE(bridge.at("plank").least_friction, 0.5);
    for (const char* const support : {"left", "right"}) {
      Scene copy = bridge.scene;
      const OperationResult lifted =
          perform(copy, TranslateOperation{{{support}}, Vec3(0, 0, 0.004)}, bridge.options);
      ASSERT_TRUE(lifted.ok()) << lifted.reason();
      EXPECT_EQ(lifted.end, OperationResult::End::Reached);
      EXPECT_EQ(lifted.carried, Names{"plank"});
    }
  }
}

// A block that is farther away holds nothing: the plank comes down on it.
TEST(Carriers, ReachNoFarther) {
  for (const double gap : {7.5, 8.0, 15.0}) {
    SCOPED_TRACE(gap);
    Bridge bridge(gap);
    EXPECT_NE(bridge.at("plank").state, ObjectState::Stable);
    PutOperation put{{"plank"}, bridge.at("plank").pose};
    put.tries = 1;
    const OperationResult result = perform(bridge.scene, put, bridge.options);
    ASSERT_TRUE(result.ok()) << result.reason();
    EXPECT_EQ(bridge.at("plank").state, ObjectState::Stable);
    EXPECT_EQ(supports_of(bridge.scene, "plank"), (Names{"left", "right"}));
    for (const ObjectContact& entry : bridge.at("plank").contacts)
      for (const ContactPoint& p : entry.contact.points)
        EXPECT_LE(p.gap, kCarryingTolerance * bridge.unit);
  }
}

TEST(Carriers, AreMissedWhenTheyGo) {
  Bridge bridge(6);
  UnplaceOperation away;
  away.object = "right";
  SettleOptions alone = bridge.options;
  alone.whole_at_rest = false;
  const OperationResult result = perform(bridge.scene, away, alone);
  ASSERT_TRUE(result.ok()) << result.reason();
  EXPECT_EQ(result.unsupported, Names{"plank"});
  EXPECT_EQ(supports_of(bridge.scene, "plank"), Names{"left"});
}

// Clearances follow the size of the scene: what touched before it became smaller still does.
TEST(Carriers, StayWhereTheClearanceBecomesSmaller) {
  Bridge bridge(1.5);
  bridge.options.clearance = 0.6 * bridge.unit;
  bridge.scene.add(object_of("cup", box_triangles({0.03, 0.03, 0.05})));
  const OperationResult put = bridge.run(PutOperation{{"cup"}, {{}, Vec3(0, 0, 1)}});
  ASSERT_TRUE(put.ok()) << put.reason();
  EXPECT_EQ(bridge.at("plank").state, ObjectState::Stable);
  UnplaceOperation away;
  away.object = "cup";
  const OperationResult result = bridge.run(away);
  ASSERT_TRUE(result.ok()) << result.reason();
  EXPECT_TRUE(result.unsupported.empty());
  EXPECT_EQ(bridge.at("plank").state, ObjectState::Stable);
  EXPECT_EQ(supports_of(bridge.scene, "plank"), (Names{"left", "right"}));
}

TEST(Carriers, StayTheSameAfterUpdate) {
  Bridge bridge(6);
  Scene anew = bridge.scene;
  update_contacts(anew, bridge.options.clearance, bridge.options);
  EXPECT_EQ(loads_text(anew), loads_text(bridge.scene));
}

// Held by friction alone.
TEST(Carriers, PinchByFriction) {
  Stage stage;
  stage.options.clearance = 1e-6;
  stage.fix("left", box_triangles({0.1, 0.5, 0.5}), {-0.2, 0, 0.5001});
  stage.fix("right", box_triangles({0.1, 0.5, 0.5}), {0.2, 0, 0.5001});
  const ObjectId id = stage.scene.add(object_of("box", box_triangles({0.0999985, 0.1, 0.1})));
  const OperationResult result = stand(stage.scene, id, {{}, {0, 0, 0.5}}, stage.options);
  ASSERT_TRUE(result.ok()) << result.reason();
  if (stage.at("box").state != ObjectState::Stable) GTEST_SKIP() << "it is not held";
  EXPECT_EQ(supports_of(stage.scene, "box"), (Names{"left", "right"}));
  PickUpOperation up;
  up.object = "box";
  up.distance = 0.1;
  EXPECT_TRUE(perform(stage.scene, up, stage.options).ok());
}

TEST(Supports, ThatDoNotCountAreTold) {
  Stage stage;
  stage.put("drawer", box_triangles({0.2, 0.2, 0.1}), {0, 0, 0.2});
  TranslateOperation lift{{{"drawer"}}, Vec3(0, 0, 0.3)};
  ASSERT_TRUE(stage.run(lift).ok());
  ASSERT_EQ(stage.at("drawer").state, ObjectState::Held);
  stage.scene.add(object_of("cup", box_triangles({0.03, 0.03, 0.05})));
  const OperationResult result = stage.run(PutOperation{{"cup"}, {{}, Vec3(0, 0, 1)}});
  ASSERT_TRUE(result.ok()) << result.reason();
  EXPECT_EQ(result.unsound, Names{"drawer"});
  EXPECT_TRUE(unsound_supports(stage.scene, *stage.scene.find("drawer")).empty());
}

}  // namespace
}  // namespace trivet::test
