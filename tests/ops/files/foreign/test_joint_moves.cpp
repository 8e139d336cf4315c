// Joints moved with what lies in their links: known answers, limits, blocks, written back.
#include <gtest/gtest.h>

#include <random>

#include "core/base/error.h"
#include "core/io/foreign/foreign_testing.h"
#include "core/io/text/file_bytes.h"
#include "ops/files/foreign/findings.h"
#include "ops/files/foreign/joint_moves.h"
#include "ops/mend/settle_free.h"

namespace trivet {
namespace {

using namespace trivet::test;

std::string drawer_text() {
  return file_bytes(std::string(TRIVET_SOURCE_DIR) + "/tests/core/io/foreign/cases/drawer.xml",
                    1 << 20)
      .value_or("");
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

/// A scene in a file of its own, settled.
struct Kitchen {
  TemporaryFolder folder;
  OpenedScene opened;
  NewPoses poses;

  explicit Kitchen(const std::string& text) : opened(open(text)) {
    for (const SettledObject& o : settle_scene(opened.judged.scene, {}).moved) poses[o.id] = o.to;
  }
  OpenedScene open(const std::string& text) {
    write_text(folder.file("in.xml"), text);
    return open_scene(folder.file("in.xml"), {});
  }
  JointMove move(const std::string& joint, double to) {
    return move_joint_of(opened, joint_named(opened, joint), to, OperationRun({}, {}), poses);
  }
  Vec3 at(const std::string& name) const {
    return opened.judged.scene.at(*opened.judged.scene.find(name)).pose.translation;
  }
  /// Written with all joints and read back.
  OpenedScene written() {
    opened.write_with_joints(poses, opened.joints, folder.file("out.xml"));
    return open_scene(folder.file("out.xml"), {});
  }
};

double clearance_of(const Kitchen& kitchen) {
  const Vec3 cube = kitchen.at("in the drawer");
  return cube.z() - 0.135;  // above the drawer's bottom
}

TEST(Joints, AreReadWithTheirLimits) {
  Kitchen kitchen(drawer_text());
  ASSERT_EQ(kitchen.opened.joints.size(), 2u);
  const SceneJoint& slide = joint_named(kitchen.opened, "slide");
  EXPECT_FALSE(slide.turns);
  EXPECT_EQ(slide.value, 0.2);
  EXPECT_EQ(slide.upper, 0.3);
  EXPECT_EQ(slide.axis, Vec3(0, -1, 0));
  const SceneJoint& lid = joint_named(kitchen.opened, "lid");
  EXPECT_TRUE(lid.turns);
  EXPECT_NEAR(lid.upper, 90, 1e-12);
  EXPECT_NEAR((lid.anchor - Vec3(0, 0.2, 0.43)).norm(), 0, 1e-15);
  EXPECT_THROW(joint_named(kitchen.opened, "door"), Error);
}

TEST(Joints, ADrawerClosesWithItsContents) {
  Kitchen kitchen(drawer_text());
  const Vec3 before = kitchen.at("in the drawer"), table = kitchen.at("sunk");
  const JointMove move = kitchen.move("slide", 0);
  EXPECT_EQ(move.end, JointMove::End::Reached);
  EXPECT_EQ(move.value, 0);
  ASSERT_EQ(move.carried.size(), 1u);
  EXPECT_LT((kitchen.at("in the drawer") - before - Vec3(0, 0.2, 0)).norm(), 1e-12);
  EXPECT_EQ(kitchen.at("sunk"), table);
  OpenedScene again = kitchen.written();
  EXPECT_TRUE(judge(again, {}).ok()) << verdict_text(judge(again, {}));
  EXPECT_EQ(joint_named(again, "slide").value, 0);
  const ObjectId drawer = *again.judged.scene.find("drawer");
  EXPECT_LT((again.judged.scene.at(drawer).pose.translation - Vec3(0, -0.01, 0.2)).norm(), 1e-12);
}

TEST(Joints, ATallThingStopsTheDrawerAtTheTop) {
  std::string text = replaced(drawer_text(), R"(<geom name="cube" size="0.03 0.03 0.03"/>)",
                              R"(<geom name="cube" size="0.03 0.03 0.16"/>)");
  text = replaced(text, "0.2 0 0 -0.25 0.145 1", "0.2 0 0 -0.25 0.275 1");
  Kitchen kitchen(text);
  const JointMove move = kitchen.move("slide", 0);
  EXPECT_EQ(move.end, JointMove::End::Blocked);
  EXPECT_EQ(named(kitchen.opened.judged.scene, move.blocker).name, "cabinet");
  EXPECT_LT(move.value, 0.2 - 0.02 + 1e-4);
  EXPECT_GT(move.value, 0.2 - 0.02);
  OpenedScene again = kitchen.written();
  EXPECT_TRUE(judge(again, {}).ok()) << verdict_text(judge(again, {}));
}

TEST(Joints, LimitsStopThem) {
  Kitchen kitchen(drawer_text());
  EXPECT_EQ(kitchen.move("slide", 5).end, JointMove::End::Limit);
  EXPECT_EQ(joint_named(kitchen.opened, "slide").value, 0.3);
  EXPECT_NEAR(kitchen.move("lid", 90).value, 90, 1e-9);
  // Upright behind the cabinet.
  EXPECT_NEAR((kitchen.at("lid") - Vec3(0, 0.2, 0.43)).norm(), 0, 1e-12);
  const ObjectId lid = *kitchen.opened.judged.scene.find("lid");
  EXPECT_NEAR(kitchen.opened.judged.scene.world_box(lid).upper.z(), 0.83, 1e-7);
  EXPECT_EQ(kitchen.move("lid", -10).end, JointMove::End::Limit);
}

TEST(Joints, ADoorInTheWayBlocksADrawer) {
  const char* const text = R"(<mujoco><compiler angle="degree"/><worldbody>
    <geom type="plane" size="1 1 1"/>
    <body name="frame" pos="0 0 0.5"><geom type="box" size="0.5 0.02 0.5" pos="0 0.5 0"/>
      <body name="drawer"><joint name="drawer" type="slide" axis="0 -1 0" range="0 0.4"/>
        <geom type="box" size="0.2 0.2 0.05"/></body>
      <body name="door" pos="-0.4 -0.3 0"><joint name="door" type="hinge" axis="0 0 1" range="-90 0"/>
        <geom type="box" size="0.4 0.01 0.4" pos="0.4 0 0"/></body></body>
    </worldbody></mujoco>)";
  Kitchen kitchen(text);
  const JointMove blocked = kitchen.move("drawer", 0.4);
  EXPECT_EQ(blocked.end, JointMove::End::Blocked);
  EXPECT_EQ(named(kitchen.opened.judged.scene, blocked.blocker).name, "door");
  EXPECT_NEAR(blocked.value, 0.09, 1e-4);
  EXPECT_LT(blocked.value, 0.09);
  EXPECT_EQ(kitchen.move("door", -90).end, JointMove::End::Reached);
  EXPECT_EQ(kitchen.move("drawer", 0.4).end, JointMove::End::Reached);
  // It had no keyframe: it gets one.
  OpenedScene again = kitchen.written();
  EXPECT_EQ(again.key, "moved");
  EXPECT_EQ(joint_named(again, "drawer").value, 0.4);
  EXPECT_NEAR(joint_named(again, "door").value, -90, 1e-12);
}

TEST(Joints, FreeBodiesGoIntoANewKeyframe) {
  const std::string with_key = drawer_text();
  const size_t begin = with_key.find("  <keyframe>"), end = with_key.find("</keyframe>") + 12;
  Kitchen kitchen(with_key.substr(0, begin) + with_key.substr(end));
  kitchen.move("slide", 0.25);
  OpenedScene again = kitchen.written();
  EXPECT_EQ(again.key, "moved");
  for (const char* name : {"in the drawer", "sunk", "drawer", "lid"}) {
    const Scene& scene = again.judged.scene;
    EXPECT_LT((scene.at(*scene.find(name)).pose.translation - kitchen.at(name)).norm(), 1e-12)
        << name;
  }
}

TEST(Joints, LinksThatGravityMovesAreNamed) {
  const auto notes = [](const std::string& joint) {
    std::string out;
    const ForeignScene scene = scene_of_mjcf(
        "<mujoco><worldbody><geom type='plane' size='9 9 9'/><body pos='0 0 1'>" + joint +
        "<geom type='box' size='0.5 0.3 0.01' pos='0.5 0 0' "
        "mass='1'/></body></worldbody></mujoco>");
    for (const Sentence& note : scene.notes) out += in_english(note);
    return out;
  };
  // A trapdoor of 1 kg and 1 m.
  EXPECT_NE(notes("<joint name='j' type='hinge' axis='0 1 0'/>").find("4.90332 N m"),
            std::string::npos);
  EXPECT_EQ(notes("<joint name='j' type='hinge' axis='0 1 0' range='-90 0'/>"), "");
  EXPECT_EQ(notes("<joint name='j' type='hinge' axis='0 0 1'/>"), "");
  EXPECT_EQ(notes("<joint name='j' type='hinge' axis='0 1 0' frictionloss='5'/>"), "");
  EXPECT_EQ(notes("<joint name='j' type='slide' axis='1 0 0'/>"), "");
  EXPECT_NE(notes("<joint name='j' type='slide' axis='0 0 1'/>").find("-9.80665 N"),
            std::string::npos);
}

TEST(Joints, ManyMovesKeepTheSceneTrue) {
  Kitchen kitchen(drawer_text());
  std::mt19937 random(7);
  for (int step = 0; step < 40; ++step) {
    const bool slide = random() % 2 == 0;
    const double share = static_cast<double>(random() % 1000) / 999;
    const JointMove move =
        slide ? kitchen.move("slide", 0.3 * share) : kitchen.move("lid", 90 * share);
    EXPECT_NE(move.end, JointMove::End::Blocked) << step;
    const SceneVerdict verdict = judge(kitchen.opened, {});
    ASSERT_TRUE(verdict.ok()) << step << "\n" << verdict_text(verdict);
  }
  EXPECT_NEAR(clearance_of(kitchen), 0, 1e-4);
  OpenedScene again = kitchen.written();
  for (const char* name : {"in the drawer", "sunk", "drawer", "lid"}) {
    const Scene& scene = again.judged.scene;
    EXPECT_LT((scene.at(*scene.find(name)).pose.translation - kitchen.at(name)).norm(), 1e-12)
        << name;
  }
}

}  // namespace
}  // namespace trivet
