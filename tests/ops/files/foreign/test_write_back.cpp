// Scenes written back: equal bytes without change, one place changed with one.
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/io/foreign/foreign_testing.h"
#include "core/io/foreign/tag_text.h"
#include "core/io/foreign/write_back.h"
#include "core/io/text/file_bytes.h"
#include "ops/files/foreign/findings.h"
#include "ops/mend/settle_free.h"

namespace trivet {
namespace {

using namespace trivet::test;

// Quotes, comments with tags in them, attributes over lines, numbers of several spellings.
const char* const kOdd = R"(<?xml version="1.0"?>
<!-- <body pos="9 9 9"> is no tag > -->
<mujoco model='odd'>
  <worldbody>
    <geom name="p" type="plane" size="1 1 1"/>
    <body name="a > b"
          euler='0 0 90'   pos = "  -.5  +0.25   6e-2 "
    ><freejoint/><geom type="box" size=".05 .05 .05"/></body >
    <frame pos="1 0 0" euler="0 0 90"><body name='framed' pos='0 -.5 0.047'><freejoint/><geom type="box" size=".05 .05 .05"/></body></frame>
    <body name="bare"><freejoint/><geom type="box" size=".05 .05 .05"/></body>
  </worldbody>
</mujoco>
)";

std::string bytes_at(const std::string& path) { return file_bytes(path, 1 << 20).value_or("?"); }

/// A file, settled into another.
struct Settled {
  TemporaryFolder folder;
  std::string before, after;
  SettledScene result;
  SceneVerdict verdict;

  explicit Settled(const std::string& text, const std::string& name = "in.xml") {
    before = text;
    write_text(folder.file(name), text);
    OpenedScene opened = open_scene(folder.file(name), {});
    result = settle_scene(opened.judged.scene, {});
    NewPoses poses;
    for (const SettledObject& o : result.moved) poses[o.id] = o.to;
    const std::string out = folder.file("out" + name);
    opened.write(poses, out);
    after = bytes_at(out);
    OpenedScene again = open_scene(out, {});
    verdict = judge(again, {});
  }
};

size_t num_lines_that_differ(const std::string& a, const std::string& b) {
  std::istringstream x(a), y(b);
  std::string line_a, line_b;
  size_t count = 0;
  while (std::getline(x, line_a) && std::getline(y, line_b)) count += line_a != line_b;
  return count;
}

TEST(WriteBack, WithoutChangeBytesAreEqual) {
  const TemporaryFolder folder;
  for (const char* text : {kOdd, kFrames}) {
    write_text(folder.file("s.xml"), text);
    const ForeignScene scene = read_mjcf(folder.file("s.xml"), {}, no_mesh);
    EXPECT_EQ(files_with_poses(scene, {})[0], text);
    std::map<size_t, Pose> same;
    for (size_t i = 0; i < scene.bodies.size(); ++i)
      if (!scene.bodies[i].fixed) same[i] = scene.bodies[i].pose;
    EXPECT_EQ(files_with_poses(scene, same)[0], text);
  }
}

TEST(WriteBack, OnlyNumbersOfThePoseChange) {
  const Settled s(kOdd);
  EXPECT_TRUE(s.verdict.ok()) << verdict_text(s.verdict);
  EXPECT_NE(s.after.find("euler='0 0 90'   pos = \"  -.5  +0.25   0.05"), std::string::npos)
      << s.after;
  EXPECT_NE(s.after.find("<body name='framed' pos='0 -.5 0.05"), std::string::npos) << s.after;
  EXPECT_NE(s.after.find("<body name=\"bare\" pos=\"0 0 0.05"), std::string::npos) << s.after;
  EXPECT_EQ(num_lines_that_differ(s.before, s.after), 3u);
}

TEST(WriteBack, AKeyframeChangesInSevenNumbers) {
  const std::string text =
      "<mujoco><worldbody><geom type='plane' size='1 1 1'/><body name='a' pos='0 0 5'><freejoint/>"
      "<geom type='box' size='.05 .05 .05'/></body></worldbody>\n"
      "<keyframe>\n<key name='k' qpos='1 -2  0.06 1 0 0 0'/>\n</keyframe></mujoco>\n";
  const Settled s(text);
  EXPECT_TRUE(s.verdict.ok());
  EXPECT_NE(s.after.find("qpos='1 -2  0.05"), std::string::npos) << s.after;
  EXPECT_NE(s.after.find(" 1 0 0 0'/>"), std::string::npos) << s.after;
  EXPECT_EQ(num_lines_that_differ(s.before, s.after), 1u);
}

TEST(WriteBack, SdfPosesAreElements) {
  const std::string text = R"(<?xml version="1.0"?>
<sdf version="1.8"><world name="w">
  <model name="ground"><static>true</static><link name="l"><collision name="c"><geometry><plane><normal>0 0 1</normal></plane></geometry></collision></link></model>
  <model name="cup"><pose>1 2 0.06
    0 0 0.5</pose><link name="l"><inertial><mass>0.2</mass></inertial><collision name="c"><geometry><box><size>0.1 0.1 0.1</size></box></geometry></collision></link></model>
  <model name="sunk"><link name="l"><collision name="c"><geometry><box><size>0.1 0.1 0.1</size></box></geometry></collision></link></model>
</world></sdf>
)";
  const Settled s(text, "world.sdf");
  EXPECT_TRUE(s.verdict.ok()) << verdict_text(s.verdict);
  EXPECT_NE(s.after.find("<pose>1 2 0.05"), std::string::npos) << s.after;
  EXPECT_NE(s.after.find("\n    0 0 0.5</pose>"), std::string::npos) << s.after;
  EXPECT_NE(s.after.find("<model name=\"sunk\"><pose>0 0 0.05"), std::string::npos) << s.after;
}

TEST(WriteBack, InputsAreNeverOverwritten) {
  const TemporaryFolder folder;
  const std::string path = folder.file("s.xml");
  write_text(path, kOdd);
  const OpenedScene opened = open_scene(path, {});
  EXPECT_THROW(opened.write({}, path), Error);
  EXPECT_EQ(bytes_at(path), kOdd);
}

TEST(WriteBack, CopiesHaveNoPlace) {
  const ForeignScene scene = scene_of_mjcf(
      "<mujoco><worldbody><replicate count='2' offset='1 0 0'><body name='b'><freejoint/>"
      "<geom size='1'/></body></replicate></worldbody></mujoco>");
  EXPECT_THROW(files_with_poses(scene, {{0, Pose{}}}), Error);
}

TEST(WriteBack, NumbersThatAreEqualKeepTheirText) {
  EXPECT_EQ(with_numbers(" -.5\t+0.25  6e-2", {-0.5, 0.25, 0.07}), " -.5\t+0.25  0.07");
  EXPECT_EQ(with_numbers("1 2", {1, 2, 3}), "1 2 3");
  EXPECT_EQ(with_attributes("<a b='x>c' pos='1'/>", {{"pos", "2"}, {"quat", "1 0 0 0"}}),
            "<a b='x>c' pos='2' quat=\"1 0 0 0\"/>");
  EXPECT_EQ(with_attributes("<a pos=\"quat='1'\" euler='1'>", {{"quat", "q"}, {"euler", ""}}),
            "<a pos=\"quat='1'\" quat=\"q\">");
}

}  // namespace
}  // namespace trivet
