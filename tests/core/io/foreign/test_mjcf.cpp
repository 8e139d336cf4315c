// MJCF: poses, masses, what collides, keyframes, includes; hostile files.
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/io/foreign/foreign_testing.h"
#include "core/io/foreign/write_back.h"

namespace trivet {
namespace {

using namespace trivet::test;

std::string world(const std::string& bodies, const std::string& more = "") {
  return "<mujoco><worldbody>" + bodies + "</worldbody>" + more + "</mujoco>";
}

std::string error_of(const std::string& text) {
  try {
    scene_of_mjcf(text);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(Mjcf, BodiesInTheWorldAreOneEachAndWeldedOnesAreOne) {
  const ForeignScene scene = scene_of_mjcf(kFrames);
  ASSERT_EQ(scene.bodies.size(), 6u);
  EXPECT_EQ(scene.bodies[0].name, "ground");
  EXPECT_TRUE(scene.bodies[0].fixed);
  EXPECT_FALSE(scene.bodies[0].colliders[0].mesh);
  EXPECT_TRUE(find_body(scene, "turned")->is_link);
  const ForeignBody* const loose = find_body(scene, "loose");
  EXPECT_FALSE(loose->fixed);
  EXPECT_EQ(loose->colliders.size(), 2u);
  EXPECT_FALSE(find_body(scene, "welded"));
  EXPECT_EQ(scene.key, "home");
  EXPECT_EQ(scene.num_joints, 3u);
  EXPECT_TRUE(scene.unread.empty());
}

TEST(Mjcf, VisualGeomsWeighButDoNotCollide) {
  const ForeignBody turned = *find_body(scene_of_mjcf(kFrames), "turned");
  EXPECT_EQ(turned.colliders.size(), 2u);
  const double box = 8 * 0.1 * 0.2 * 0.3, r = 0.05;
  const double capsule = 3.14159265358979 * r * r * (0.5 + 4.0 / 3 * r);
  EXPECT_NEAR(turned.mass->kilograms, 500 * (box + capsule) + 0.25, 1e-9);
}

TEST(Mjcf, InertialsComeBeforeGeoms) {
  const ForeignBody given = *find_body(scene_of_mjcf(kFrames), "given");
  ASSERT_TRUE(given.mass && given.mass->inertia);
  EXPECT_EQ(given.mass->kilograms, 2);
  EXPECT_NEAR((*given.mass->centre - Vec3(0.01, 0.02, 0.03)).norm(), 0, 1e-15);
  EXPECT_NEAR(given.mass->inertia->trace(), 0.09, 1e-15);
  EXPECT_EQ((*given.mass->inertia)(0, 0), 0.02);
}

TEST(Mjcf, AKeyIsChosenByNameOrNone) {
  ForeignOptions options;
  options.key = "none";
  const ForeignScene reference = scene_of_mjcf(kFrames, options);
  EXPECT_EQ(reference.key, "");
  EXPECT_EQ(find_body(reference, "given")->pose.translation, Vec3(-1, 0, 0.5));
  EXPECT_EQ(find_body(reference, "given")->place.kind, PosePlace::Kind::Tag);
  const ForeignScene home = scene_of_mjcf(kFrames);
  EXPECT_EQ(find_body(home, "given")->pose.translation, Vec3(-1, 0, 1));
  EXPECT_EQ(find_body(home, "given")->place.kind, PosePlace::Kind::Key);
  options.key = "away";
  try {
    scene_of_mjcf(kFrames, options);
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("has no keyframe \"away\"; accepted: home"),
              std::string::npos);
  }
}

TEST(Mjcf, CopiesStandInALine) {
  const ForeignScene scene = scene_of_mjcf(world(
      R"(<replicate count="3" offset="1 0 0"><body name="b" pos="0 0 1"><freejoint/>
         <geom size="0.1"/></body></replicate>)"));
  ASSERT_EQ(scene.bodies.size(), 3u);
  EXPECT_EQ(scene.bodies[2].name, "b2");
  EXPECT_EQ(scene.bodies[2].pose.translation, Vec3(2, 0, 1));
  EXPECT_EQ(scene.bodies[2].place.kind, PosePlace::Kind::Nowhere);
}

TEST(Mjcf, FramesShiftWhatIsInThem) {
  const ForeignScene scene = scene_of_mjcf(world(
      R"(<frame pos="0 0 1" euler="90 0 0"><body name="b" pos="1 0 2"><freejoint/>
         <geom type="box" size="1 1 1"/></body></frame>)"));
  ASSERT_EQ(scene.bodies.size(), 1u);
  EXPECT_LT((scene.bodies[0].pose.translation - Vec3(1, -2, 1)).norm(), 1e-14);
}

TEST(Mjcf, WhatIsNotReadIsNamed) {
  const ForeignScene scene = scene_of_mjcf(world(
      R"(<body name="b"><freejoint/><geom type="hfield" hfield="h"/><composite type="rope"/>
         <geom type="mesh" mesh="m"/><geom size="1"/></body>)"));
  ASSERT_EQ(scene.unread.size(), 3u);
  EXPECT_NE(in_english(scene.unread[0]).find("\"hfield\" is not read"), std::string::npos);
  EXPECT_NE(in_english(scene.unread[2]).find("no mesh is named \"m\""), std::string::npos);
}

TEST(Mjcf, FramesThatAreAlignedWithTheInertiaAreSaid) {
  const auto said = [](const std::string& compiler, const std::string& joint) {
    return scene_of_mjcf("<mujoco>" + compiler + "<worldbody><body name='b'>" + joint +
                         "<geom size='1'/></body></worldbody></mujoco>")
        .unread.size();
  };
  EXPECT_EQ(said("", "<freejoint/>"), 0u);
  EXPECT_EQ(said("", "<freejoint align='true'/>"), 1u);
  EXPECT_EQ(said("<compiler alignfree='true'/>", "<freejoint/>"), 1u);
  EXPECT_EQ(said("<compiler alignfree='true'/>", "<freejoint align='false'/>"), 0u);
}

TEST(Mjcf, GravityAcrossIsToldAndNotGuessed) {
  EXPECT_EQ(scene_of_mjcf(world("<geom size='1'/>", "<option gravity='0 0 -1.6'/>")).unread.size(),
            0u);
  EXPECT_EQ(scene_of_mjcf(world("<geom size='1'/>", "<option gravity='0 -9.8 0'/>")).unread.size(),
            1u);
}

TEST(Mjcf, IncludedFilesStandInPlace) {
  const TemporaryFolder folder;
  write_text(
      folder.file("scene.xml"),
      "<mujoco><include file='sub/part.xml'/><worldbody><geom size='1'/></worldbody></mujoco>");
  std::filesystem::create_directories(folder.file("sub"));
  write_text(folder.file("sub/part.xml"),
             "<mujocoinclude><worldbody><body name='b' pos='1 2 3'><freejoint/><geom size='1'/>"
             "</body></worldbody></mujocoinclude>");
  const ForeignScene scene = read_mjcf(folder.file("scene.xml"), {}, no_mesh);
  ASSERT_EQ(scene.files.size(), 2u);
  ASSERT_EQ(scene.bodies.size(), 2u);
  EXPECT_EQ(find_body(scene, "b")->place.file, 1u);
  const auto files = files_with_poses(scene, {{1, {{}, {1, 2, 4}}}});
  EXPECT_EQ(files[0], scene.files[0].bytes);
  EXPECT_NE(files[1].find("pos='1 2 4'"), std::string::npos);
}

TEST(Mjcf, CirclesOfIncludesEnd) {
  const TemporaryFolder folder;
  write_text(folder.file("a.xml"), "<mujoco><include file='a.xml'/></mujoco>");
  EXPECT_THROW(read_mjcf(folder.file("a.xml"), {}, no_mesh), Error);
}

TEST(Mjcf, HostileFilesGetAMessage) {
  EXPECT_NE(error_of("<mujoco><worldbody>").find("line 1"), std::string::npos);
  EXPECT_NE(error_of("<robot/>").find("accepted: <mujoco>"), std::string::npos);
  EXPECT_NE(error_of("<!DOCTYPE m [<!ENTITY a 'b'>]><mujoco/>").find("entities"),
            std::string::npos);
  EXPECT_NE(error_of(world("<geom size='nan'/>")).find("accepted: numbers"), std::string::npos);
  EXPECT_NE(error_of(world("<geom size='-1'/>")).find("positive"), std::string::npos);
  EXPECT_NE(error_of(world("<geom class='none' size='1'/>")).find("<default>"), std::string::npos);
  EXPECT_NE(error_of(world("<replicate count='1e9'><geom size='1'/></replicate>")).find("count"),
            std::string::npos);
  std::string deep;
  for (int i = 0; i < 1000; ++i) deep += "<body>";
  EXPECT_NE(error_of(world(deep)).find("nested too deeply"), std::string::npos);
}

TEST(Mjcf, NestedCopiesStayWithinLimits) {
  std::string bodies = "<body><geom size='1'/></body>";
  for (int i = 0; i < 4; ++i)
    bodies.insert(0, "<replicate count='1000' offset='1 0 0'>").append("</replicate>");
  EXPECT_NE(error_of(world(bodies)).find("too many bodies"), std::string::npos);
}

}  // namespace
}  // namespace trivet
