// Joints in layouts and sessions: known answers, undo and redo, files, journals, and cabinets that
// stand free.
#include <gtest/gtest.h>

#include <fstream>

#include "core/base/error.h"
#include "core/scene/fingerprint.h"
#include "core/scene/joint.h"
#include "core/scene/transaction.h"
#include "ops/check/check.h"
#include "ops/files/json/text.h"
#include "ops/files/layout/boxes.h"
#include "ops/files/layout/run.h"
#include "ops/files/layout/watched_run.h"
#include "ops/files/report/scene_file.h"
#include "ops/session/kitchen.h"
#include "ops/session/restore.h"
#include "ops/stability/stability.h"
#include "support/same_scene.h"
#include "support/temporary_folder.h"

namespace trivet {
namespace {

using namespace test;

TEST(JointsOfLayouts, ADrawerIsFilledAndClosed) {
  Furnished kitchen(fixed_kitchen());
  EXPECT_EQ(kitchen.value("drawer"), 0.3);
  EXPECT_EQ(kitchen.at("drawer").pose.translation, Vec3(0, -0.3, 3e-6));
  const Vec3 before = kitchen.at("cube").pose.translation;
  EXPECT_NEAR(before.z(), 0.105 + 0.03, 1e-4);
  // The load-support list has the link.
  EXPECT_EQ(load_support(kitchen.scene()).entries.at(2).supports,
            std::vector<ObjectId>{*kitchen.scene().find("drawer")});
  const OperationResult closed = kitchen.move("drawer", 0);
  ASSERT_TRUE(closed.ok()) << closed.reason();
  EXPECT_EQ(closed.end, OperationResult::End::Reached);
  EXPECT_EQ(closed.joint_value, 0.0);
  EXPECT_EQ(closed.carried, std::vector<std::string>{"cube"});
  EXPECT_NEAR((kitchen.at("cube").pose.translation - before - Vec3(0, 0.3, 0)).norm(), 0, 1e-12);
  EXPECT_EQ(kitchen.at("cube").state, ObjectState::Stable);
}

TEST(JointsOfLayouts, WhatIsOpenedAndClosedIsWhereItWasToTheBit) {
  Furnished kitchen(fixed_kitchen(kOpen));
  const Vec3 open = kitchen.at("drawer").pose.translation;
  for (const double to : {0.1, 0.0, 0.2, 0.07, 0.0}) ASSERT_TRUE(kitchen.move("drawer", to).ok());
  EXPECT_EQ(kitchen.at("drawer").pose.translation, Vec3(0, 0, 3e-6));
  ASSERT_TRUE(kitchen.move("drawer", 0.3).ok());
  EXPECT_EQ(kitchen.at("drawer").pose.translation, open);
}

TEST(JointsOfLayouts, UndoAndRedoBringBackEveryBit) {
  Furnished kitchen(fixed_kitchen());
  const std::uint64_t open = fingerprint(kitchen.scene());
  ASSERT_TRUE(kitchen.move("drawer", {}, -0.2).ok());
  const std::uint64_t closed = fingerprint(kitchen.scene());
  EXPECT_NE(open, closed);
  ASSERT_TRUE(kitchen.session().undo());
  EXPECT_EQ(fingerprint(kitchen.scene()), open);
  EXPECT_EQ(kitchen.value("drawer"), 0.3);
  ASSERT_TRUE(kitchen.session().redo());
  EXPECT_EQ(fingerprint(kitchen.scene()), closed);
  EXPECT_TRUE(kitchen.scene().is_consistent());
}

// The box of 0.275 m on the drawer's bottom is higher than the cabinet is inside, 0.38 m: it stops
// before the top's front, at y = -0.2.
TEST(JointsOfLayouts, AClosedDrawerIsRefusedByWhatSticksOut) {
  Furnished kitchen(
      fixed_kitchen(kOpen + R"(, {"op": "put", "object": "tall", "position": [0, -0.3, 0.5]})"));
  const double y = kitchen.at("tall").pose.translation.y();
  const OperationResult result = kitchen.move("drawer", 0);
  ASSERT_TRUE(result.ok()) << result.reason();
  EXPECT_EQ(result.end, OperationResult::End::Blocked);
  EXPECT_EQ(result.blocked_by.name, "cabinet");
  EXPECT_NEAR(result.blocked_at.y(), -0.2, 1e-9);
  EXPECT_NEAR(*result.joint_value, 0.3 - (-0.2 - (y + 0.03)), 3 * kClearance);
  EXPECT_EQ(kitchen.value("drawer"), *result.joint_value);
  // It does not go on: nothing has changed, and the answer is the same.
  const OperationResult again = kitchen.move("drawer", 0);
  EXPECT_EQ(again.end, OperationResult::End::Blocked);
  EXPECT_LT(again.moved, kClearance);
}

TEST(JointsOfLayouts, AJointEndsAtItsLimits) {
  Furnished kitchen(fixed_kitchen(kOpen));
  EXPECT_EQ(kitchen.move("drawer", 1).end, OperationResult::End::Limit);
  EXPECT_EQ(kitchen.value("drawer"), 0.3);
  EXPECT_EQ(kitchen.move("drawer", {}, -5).end, OperationResult::End::Limit);
  EXPECT_EQ(kitchen.value("drawer"), 0);
}

const std::string kLid = R"(, {"name": "lid", "model": "lid.obj", "position": [0, 0.15, 0.4001],
   "joint": {"in": "cabinet", "hinge": [-1, 0, 0], "at": [0, 0, 0], "lower": 0, "upper": 90}})";

TEST(JointsOfLayouts, ALidTurnsWithWhatLiesOnItUntilThatMeetsSomething) {
  Furnished kitchen(text_of(R"(, "fixed": true)", "", kLid,
                            R"({"op": "move_joint", "object": "lid", "to": 45},
         {"op": "move_joint", "object": "lid", "by": 45})"));
  EXPECT_EQ(kitchen.value("lid"), 90);
  EXPECT_NEAR((kitchen.at("lid").pose.rotation.matrix() * Vec3(0, -1, 0) - Vec3(0, 0, 1)).norm(), 0,
              1e-12);
  const OperationResult shut = kitchen.move("lid", 0);
  ASSERT_TRUE(shut.ok()) << shut.reason();
  EXPECT_EQ(shut.turned_deg, -90);
  EXPECT_EQ(kitchen.at("lid").pose.translation, Vec3(0, 0.15, 0.4001));
  EXPECT_EQ(kitchen.at("lid").pose.rotation.w, 1);
}

// A flap hangs in the drawer's front.
const std::string kFlap = R"(, {"name": "flap", "model": "flap.obj", "position": [0, -0.2, 0.1],
   "joint": {"in": "drawer", "hinge": [-1, 0, 0], "at": [0, 0, 0], "lower": -60, "upper": 0}})";

TEST(JointsOfLayouts, LinksOfLinksGoAlong) {
  Furnished kitchen(text_of(R"(, "fixed": true)", "", kFlap,
                            kOpen + R"(, {"op": "move_joint", "object": "flap", "to": -50})"));
  EXPECT_EQ(kitchen.value("flap"), -50);
  EXPECT_EQ(kitchen.at("flap").pose.translation, Vec3(0, -0.5, 0.1));
  const Pose turned = kitchen.at("flap").pose;
  ASSERT_TRUE(kitchen.move("drawer", 0).ok());
  EXPECT_EQ(kitchen.at("flap").pose.translation, Vec3(0, -0.2, 0.1));
  EXPECT_EQ(kitchen.at("flap").pose.rotation.x, turned.rotation.x);
  ASSERT_TRUE(kitchen.move("flap", 0).ok());
  EXPECT_EQ(kitchen.at("flap").pose.rotation.w, 1);
}

TEST(JointsOfLayouts, WhatHangsTogetherStaysTogether) {
  Furnished kitchen(fixed_kitchen());
  const std::uint64_t before = fingerprint(kitchen.scene());
  for (const std::string name : {"drawer", "cabinet"}) {
    DeleteOperation gone;
    gone.object = name;
    EXPECT_EQ(kitchen.done(gone).reason(),
              "\"drawer\" hangs in \"cabinet\" by a joint; accepted: objects without joints");
    UnplaceOperation out;
    out.object = name;
    EXPECT_FALSE(kitchen.done(out).ok());
  }
  EXPECT_FALSE(kitchen.done(FixOperation{"drawer", false}).ok());
  TranslateOperation pulled;
  pulled.object = "drawer", pulled.by = {0, 0, 0.1};
  EXPECT_EQ(kitchen.done(pulled).refusal->cause, Refusal::Cause::Fixed);
  EXPECT_EQ(kitchen.done(LockOperation{"drawer", true}).ok(), true);
  EXPECT_EQ(kitchen.move("drawer", 0).refusal->cause, Refusal::Cause::Locked);
  kitchen.session().undo();
  EXPECT_EQ(fingerprint(kitchen.scene()), before);
}

TEST(JointsOfLayouts, AskForOneGoalOfAJointThatIsThere) {
  Furnished kitchen(fixed_kitchen());
  const auto why = [&](const MoveJointOperation& o) { return kitchen.done(o).reason(); };
  MoveJointOperation o;
  o.object = "cube", o.to = 0;
  EXPECT_EQ(
      why(o),
      "object: \"cube\" is not accepted; accepted: an object that hangs in a joint: \"drawer\"");
  o.object = "drawer", o.by = 1;
  EXPECT_NE(why(o).find("one of \"to\", \"by\" and \"until\""), std::string::npos) << why(o);
  o.to.reset(), o.by = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(kitchen.done(o).ok());
  EXPECT_THROW(parse_layout(fixed_kitchen(R"({"op": "move_joint", "object": "drawer"})"), "a.json"),
               Error);
}

TEST(JointsOfLayouts, ComeBackFromFilesToTheBit) {
  Furnished kitchen(fixed_kitchen(kOpen + kPutCube +
                                  R"(, {"op": "put", "object": "tall", "position": [1, 0, 0.5]})"));
  const test::TemporaryFolder folder;
  ASSERT_TRUE(kitchen.move("drawer", 0.123).ok());
  SceneFileOptions options;
  options.clearance = kClearance;
  write_scene_file(kitchen.scene(), kitchen.session().layout(), options, folder.file("a.glb"));
  SceneFile read = read_scene_file(folder.file("a.glb"), {});
  update_contacts(read.scene, kClearance);
  const auto drawer = read.scene.find("drawer");
  ASSERT_TRUE(drawer && read.scene.at(*drawer).joint);
  EXPECT_EQ(test::difference_in_file(read.scene, kitchen.scene()), "");
  EXPECT_EQ(fingerprint(read.scene), fingerprint(kitchen.scene()));
  // The layout in it gives the same scene; so does what is done next.
  const LayoutRun again = run_layout(read.layout, made, options_of_test());
  EXPECT_EQ(fingerprint(again.scene), fingerprint(kitchen.scene()));
  Session session(std::move(read.scene), read.layout, made);
  MoveJointOperation o;
  o.object = "drawer", o.to = 0;
  ASSERT_TRUE(session.perform(o, options_of_test().settle).ok());
  ASSERT_TRUE(kitchen.move("drawer", 0).ok());
  EXPECT_EQ(fingerprint(session.scene()), fingerprint(kitchen.scene()));
}

TEST(JointsOfLayouts, FilesWhoseJointsWereChangedAreRefused) {
  Furnished kitchen(fixed_kitchen());
  Layout layout = kitchen.session().layout();
  const std::string text = write_layout(layout);
  EXPECT_EQ(write_layout(parse_layout(text, "a.json")), text);
  // Circles, objects that are not there, and those without a place are none to hang in.
  for (const std::string in : {"drawer", "nobody", "cube"}) {
    layout.objects.at(1).joint->in = in;
    EXPECT_THROW(parse_layout(write_layout(layout), "a.json"), Error) << in;
  }
}

// The cabinet of tests/core/io/foreign, placed and turned by a quarter: its drawer opens along x.
TEST(JointsOfLayouts, ACabinetOfAnotherProgramIsPlaced) {
  const std::string folder = std::string(TRIVET_SOURCE_DIR) + "/tests/core/io/foreign/cases";
  const Layout layout = parse_layout(
      R"({"trivet": 1, "objects": [{"name": "k", "articulation": "drawer.xml",
          "position": [2, 1, 0], "rotation": [1, 0, 0, 1]}],
          "operations": [{"op": "settle"}, {"op": "move_joint", "object": "k/drawer", "to": 0},
                         {"op": "move_joint", "object": "k/lid", "until": "upper"}]})",
      folder + "/kitchen.json");
  ASSERT_EQ(layout.objects.size(), 6u);
  RunOptions options = options_of_test();
  Vec3 before;
  RunWatch watch;
  watch.done = [&](const Scene& scene, const Operation& operation, const OperationResult& result) {
    EXPECT_TRUE(result.ok()) << result.reason();
    const Object& cube = scene.at(*scene.find("k/in the drawer"));
    if (std::holds_alternative<RepairOperation>(operation)) before = cube.pose.translation;
  };
  LayoutRun run = run_layout(layout, models_in_folder(folder), options, watch);
  EXPECT_TRUE(run.ok());
  const auto at = [&](const std::string& name) { return run.scene.at(*run.scene.find(name)); };
  EXPECT_NEAR((at("k/in the drawer").pose.translation - before + Vec3(0.2, 0, 0)).norm(), 0, 1e-12);
  EXPECT_NEAR((at("k/drawer").pose.translation - Vec3(2.01, 1, 0.2)).norm(), 0, 1e-12);
  EXPECT_NEAR(at("k/lid").joint->value, 90, 1e-12);
  EXPECT_TRUE(at("k/cabinet").fixed);
  EXPECT_TRUE(at("k/sunk").state == ObjectState::Stable);
  // The layout that is written has the bodies one by one; both give the same scene.
  const Layout written = parse_layout(write_layout(layout), folder + "/again.json");
  EXPECT_EQ(fingerprint(run_layout(written, models_in_folder(folder), options).scene),
            fingerprint(run.scene));
  // Its meshes are in the file: the cabinet is not needed to read it.
  const test::TemporaryFolder empty;
  SceneFileOptions file_options;
  file_options.clearance = kClearance;
  write_scene_file(run.scene, layout, file_options, empty.file("k.glb"));
  SceneFile read = read_scene_file(empty.file("k.glb"), {});
  update_contacts(read.scene, kClearance);
  EXPECT_EQ(read.notes.size(), 0u);
  EXPECT_EQ(fingerprint(read.scene), fingerprint(run.scene));
}

// To the bit; and where the cabinet's file has changed, from the poses that were recorded.
TEST(JointsOfLayouts, ComeBackFromAJournal) {
  const test::TemporaryFolder folder;
  const auto write = [&](const std::string& name, const std::string& text) {
    std::ofstream(folder.file(name), std::ios::binary) << text;
  };
  std::string cabinet = read_text_file(
      std::string(TRIVET_SOURCE_DIR) + "/tests/core/io/foreign/cases/drawer.xml", 1 << 20);
  write("drawer.xml", cabinet);
  write("kitchen.json", R"({"trivet": 1, "objects": [{"name": "k", "articulation": "drawer.xml",
      "position": [0, 0, 0]}], "operations": [{"op": "settle"}]})");
  const RunOptions options = options_of_test();
  std::uint64_t state = 0;
  {
    OpenedSession opened =
        open_session(folder.file("kitchen.json"), options, {}, {folder.file("j"), false});
    MoveJointOperation o;
    o.object = "k/drawer", o.by = -0.05;
    ASSERT_TRUE(opened.session.perform(o, options.settle).ok());
    state = fingerprint(opened.session.scene());
  }
  const RestoredSession restored = restore_session(folder.file("j"), options, {}, false);
  EXPECT_TRUE(restored.exact);
  EXPECT_EQ(fingerprint(restored.opened.session.scene()), state);
  cabinet.replace(cabinet.find("0.195 0.18 0.005"), 5, "0.194");
  write("drawer.xml", cabinet);
  const RestoredSession changed = restore_session(folder.file("j"), options, {}, false);
  EXPECT_FALSE(changed.exact);
  const Scene& scene = changed.opened.session.scene();
  EXPECT_NEAR(scene.at(*scene.find("k/drawer")).joint->value, 0.15, 1e-12);
}

// A board of 1 kg whose centre is 0.1 m from its hinge, 0.981 N m; the cube of 0.216 kg on its
// middle adds 0.212.
TEST(JointsOfLayouts, ATrapdoorFallsByWhatLiesOnIt) {
  const auto kitchen = [](double friction) {
    return text_of(
        R"(, "fixed": true)", "",
        R"(, {"name": "board", "model": "lid.obj", "position": [0, -0.21, 0.3], "mass": 1,
                         "joint": {"in": "cabinet", "hinge": [-1, 0, 0], "friction": )" +
            std::to_string(friction) + "}}",
        "");
  };
  PutOperation put;
  put.object = "cube", put.start.translation = {0, -0.31, 0.5};
  Furnished held(kitchen(1.3));
  EXPECT_TRUE(held.done(put).ok());
  Furnished weak(kitchen(1.1));
  const OperationResult refused = weak.done(put);
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.refusal->cause, Refusal::Cause::Topples);
  EXPECT_EQ(refused.refusal->objects.back().name, "board");
  EXPECT_FALSE(weak.at("cube").placed);
  // By its own weight it does not stand at all; at rest on a stop it does.
  const auto run = [&](const std::string& text) {
    return run_layout(parse_layout(text, "a.json"), made, options_of_test());
  };
  EXPECT_FALSE(run(kitchen(0.9)).ok());
  std::string on_stop = kitchen(0);
  on_stop.replace(on_stop.find("\"friction\""), 0, "\"lower\": 0, \"upper\": 90, ");
  EXPECT_TRUE(run(on_stop).ok());
}

// A light cabinet with heavy contents: what stands free goes with its drawer and all in it.
TEST(JointsOfLayouts, ACabinetThatStandsFreeMovesAsOne) {
  Furnished kitchen(text_of(R"(, "mass": 50)", R"(, "mass": 1)", "", kOpen + kPutCube));
  EXPECT_EQ(kitchen.at("cabinet").state, ObjectState::Stable);
  const auto place = [&](const std::string& name) { return kitchen.at(name).pose.translation; };
  const Vec3 cube = place("cube"), drawer = place("drawer"), cabinet = place("cabinet");
  TranslateOperation away;
  away.object = "cabinet", away.by = {0.25, 0.5, 0};
  const OperationResult moved = kitchen.done(away);
  ASSERT_TRUE(moved.ok()) << moved.reason();
  EXPECT_EQ(moved.carried, (std::vector<std::string>{"drawer", "cube"}));
  // Gaps are opened a little before it slides.
  const Vec3 by = place("cabinet") - cabinet;
  EXPECT_NEAR((by - away.by).norm(), 0, 2 * kClearance);
  EXPECT_NEAR((place("cube") - cube - by).norm(), 0, 1e-12);
  EXPECT_NEAR((place("drawer") - drawer - by).norm(), 0, 1e-12);
  // Its joint goes on from there, turned, too.
  RotateOperation turn;
  turn.object = "cabinet", turn.angle_deg = 90;
  ASSERT_TRUE(kitchen.done(turn).ok());
  ASSERT_TRUE(kitchen.move("drawer", 0).ok());
  const Vec3 closed = kitchen.at("drawer").pose.translation;
  EXPECT_NEAR((closed - kitchen.at("cabinet").pose.translation).norm(), 0, 1e-12);
  ASSERT_TRUE(kitchen.move("drawer", 0.2).ok());
  EXPECT_NEAR((kitchen.at("drawer").pose.translation - closed - Vec3(0.2, 0, 0)).norm(), 0, 1e-12);
}

// Half a width of 0.2 m: a drawer of 4 times the cabinet's mass tips it when its centre, 0.3 m out,
// is farther than 0.2 m by more than a quarter of what the cabinet's own is inside.
TEST(JointsOfLayouts, ACabinetIsOneBodyWithItsDrawer) {
  const auto verdict = [](double drawer, double value) {
    const Layout layout = parse_layout(
        text_of(R"(, "mass": 10)", R"(, "mass": )" + std::to_string(drawer), "", ""), "a.json");
    LayoutRun run = run_layout(layout, made, options_of_test());
    Scene& scene = run.scene;
    const ObjectId id = *scene.find("drawer");
    const LinkJoint& joint = *scene.at(id).joint;
    edit_object(scene, id,
                [&](Object& o) { o.pose = link_pose(joint, scene.at(joint.parent).pose, value); });
    update_contacts(scene, kClearance);
    StabilityOptions options;
    options.clearance = kClearance;
    return stability(scene, options).status;
  };
  EXPECT_EQ(verdict(40, 0), Stability::Status::Stable);
  EXPECT_EQ(verdict(40, 0.3), Stability::Status::Unstable);
  EXPECT_EQ(verdict(1, 0.3), Stability::Status::Stable);
}

TEST(JointsOfLayouts, ADrawerThatWouldTipItsCabinetIsNoEnd) {
  Furnished kitchen(text_of(R"(, "mass": 10)", R"(, "mass": 40)", "", ""));
  const std::uint64_t before = fingerprint(kitchen.scene());
  ASSERT_TRUE(kitchen.move("drawer", 0.05).ok());
  const OperationResult result = kitchen.move("drawer", 0.3);
  if (result.ok())
    EXPECT_FALSE(result.gave_way.empty());
  else
    EXPECT_EQ(result.refusal->cause, Refusal::Cause::Topples) << result.reason();
  StabilityOptions options;
  options.clearance = kClearance;
  EXPECT_NE(stability(kitchen.scene(), options).status, Stability::Status::Unstable);
  while (kitchen.session().undo()) continue;
  EXPECT_EQ(fingerprint(kitchen.scene()), before);
}

}  // namespace
}  // namespace trivet
