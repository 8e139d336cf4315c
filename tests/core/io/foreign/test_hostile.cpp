// Files made to take long or much: each ends soon, with a message.
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/io/foreign/foreign_testing.h"
#include "core/io/foreign/sdf.h"

namespace trivet {
namespace {

using namespace trivet::test;

template <class F>
std::string error_thrown_by(const F& read) {
  try {
    read();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

std::string mjcf(const std::string& bodies) {
  return "<mujoco><worldbody>" + bodies + "</worldbody></mujoco>";
}

std::string sdf_error(const std::string& text) {
  const TemporaryFolder folder;
  write_text(folder.file("s.sdf"), text);
  return error_thrown_by([&] { read_sdf(folder.file("s.sdf"), {}, no_mesh); });
}

TEST(HostileScenes, CopiesOfCopiesOfGeomsEnd) {
  std::string geoms = "<geom type='box' size='1 1 1'/>";
  for (int i = 0; i < 4; ++i) geoms.insert(0, "<replicate count='1000'>").append("</replicate>");
  EXPECT_NE(error_thrown_by([&] { scene_of_mjcf(mjcf(geoms)); }).find("too many bodies"),
            std::string::npos);
}

TEST(HostileScenes, FacesAreCounted) {
  const std::string balls = mjcf("<replicate count='20000'><geom size='1'/></replicate>");
  EXPECT_NE(error_thrown_by([&] { scene_of_mjcf(balls); }).find("too many faces"),
            std::string::npos);
}

TEST(HostileScenes, ManyBodiesOfOneNameGetNumbers) {
  std::string bodies;
  for (int i = 0; i < 20'000; ++i)
    bodies += "<body name='b'><geom type='box' size='1 1 1'/></body>";
  const ForeignScene scene = scene_of_mjcf(mjcf(bodies));
  ASSERT_EQ(scene.bodies.size(), 20'000u);
  EXPECT_EQ(scene.bodies[0].name, "b");
  EXPECT_EQ(scene.bodies[19'999].name, "b_20000");
}

TEST(HostileScenes, NotesAreFew) {
  std::string bodies;
  for (int i = 0; i < 20'000; ++i)
    bodies += "<geom type='hfield' name='" + std::to_string(i) + "'/>\n";
  EXPECT_EQ(scene_of_mjcf(mjcf(bodies)).unread.size(), 101u);
}

TEST(HostileScenes, BitsAreWholeNumbers) {
  const auto error = [](const std::string& type) {
    return error_thrown_by([&] { scene_of_mjcf(mjcf("<geom size='1' contype='" + type + "'/>")); });
  };
  EXPECT_EQ(error("-1"), "");
  EXPECT_NE(error("1e12").find("32 bits"), std::string::npos);
  EXPECT_NE(error("0.5").find("32 bits"), std::string::npos);
}

// An assertion of Eigen stopped the program while it read one.
TEST(HostileScenes, InertiasAreNumbers) {
  const std::string of_urdf =
      "<robot name='r'><link name='base'/><link name='a'><inertial><mass value='1'/>"
      "<inertia ixx='1' iyy='1' izz='x' ixy='0' ixz='0' iyz='0'/></inertial></link>"
      "<joint name='j' type='floating'><parent link='base'/><child link='a'/></joint></robot>";
  const std::string by_urdf = error_thrown_by([&] { scene_of_urdf(of_urdf); });
  EXPECT_NE(by_urdf.find("izz=\"x\""), std::string::npos) << by_urdf;
  const std::string by_sdf = sdf_error(
      "<sdf version='1.8'><model name='m'><link name='l'><inertial><mass>1</mass><inertia>"
      "<ixx>1</ixx><iyy>x</iyy></inertia></inertial></link></model></sdf>");
  EXPECT_NE(by_sdf.find("iyy"), std::string::npos) << by_sdf;
}

TEST(HostileScenes, LinksInARowEnd) {
  std::string robot = "<robot name='r'><link name='0'/>";
  for (int i = 1; i <= 5000; ++i) {
    const std::string me = std::to_string(i), before = std::to_string(i - 1);
    robot.append("<link name='").append(me).append("'/><joint name='j").append(me);
    robot.append("' type='fixed'><parent link='").append(before);
    robot.append("'/><child link='").append(me).append("'/></joint>");
  }
  EXPECT_NE(error_thrown_by([&] { scene_of_urdf(robot + "</robot>"); }).find("in a row"),
            std::string::npos);
}

TEST(HostileScenes, FramesInARowEnd) {
  std::string world = "<sdf version='1.8'><world name='w'>";
  for (int i = 0; i < 5000; ++i)
    world += "<frame name='f" + std::to_string(i) + "'><pose relative_to='f" +
             std::to_string(i + 1) + "'/></frame>";
  world += "<frame name='f5000'/><model name='m'><pose relative_to='f0'/><link name='l'/></model>";
  EXPECT_NE(sdf_error(world + "</world></sdf>").find("in a row"), std::string::npos);
}

TEST(HostileScenes, FramesInACircleAreRefused) {
  EXPECT_NE(sdf_error("<sdf version='1.8'><world name='w'><frame name='a'><pose relative_to='b'/>"
                      "</frame><frame name='b'><pose relative_to='a'/></frame><model name='m'>"
                      "<pose relative_to='a'/><link name='l'/></model></world></sdf>")
                .find("without a circle"),
            std::string::npos);
}

}  // namespace
}  // namespace trivet
