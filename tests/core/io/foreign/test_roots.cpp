// Scenes may name files below their folder, and nothing elsewhere that the caller does not allow.
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/io/foreign/foreign_testing.h"
#include "core/io/foreign/sdf.h"

namespace trivet {
namespace {

using namespace trivet::test;

constexpr const char* kPart =
    "<mujocoinclude><worldbody><geom name='p' size='1'/></worldbody></mujocoinclude>";

/// A folder with scenes/scene.xml, and part.xml beside that folder.
struct Folders {
  TemporaryFolder folder;
  std::string scene = folder.file("scenes/scene.xml");

  Folders() {
    std::filesystem::create_directories(folder.file("scenes"));
    write_text(folder.file("part.xml"), kPart);
    write_text(scene, "<mujoco><include file='../part.xml'/></mujoco>");
  }
};

std::string refusal_of(const std::string& path, const ForeignOptions& options = {}) {
  try {
    read_mjcf(path, options, no_mesh);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(SceneRoots, AnIncludeFromElsewhereIsRefused) {
  const Folders f;
  EXPECT_NE(refusal_of(f.scene).find("outside its folder"), std::string::npos)
      << refusal_of(f.scene);
  write_text(f.scene, "<mujoco><include file='/etc/passwd'/></mujoco>");
  EXPECT_NE(refusal_of(f.scene).find("outside its folder"), std::string::npos);
}

TEST(SceneRoots, TheCallerMayAllowAFolder) {
  const Folders f;
  ForeignOptions options;
  options.roots = {f.folder.file("")};
  EXPECT_EQ(refusal_of(f.scene, options), "");
  options.roots = {f.folder.file("none")};
  EXPECT_NE(refusal_of(f.scene, options).find("is no folder"), std::string::npos);
}

TEST(SceneRoots, LinksAreFollowed) {
  const Folders f;
  std::filesystem::create_symlink("../part.xml", f.folder.file("scenes/link.xml"));
  write_text(f.scene, "<mujoco><include file='link.xml'/></mujoco>");
  EXPECT_NE(refusal_of(f.scene).find("outside its folder"), std::string::npos);
}

TEST(SceneRoots, MeshesFromElsewhereAreNotReadAndNamed) {
  const Folders f;
  write_text(f.scene,
             "<mujoco><asset><mesh name='m' file='../m.obj'/><mesh name='n' file='/etc/n.msh'/>"
             "</asset><worldbody><geom type='mesh' mesh='m'/><geom type='mesh' mesh='n'/>"
             "</worldbody></mujoco>");
  const ForeignScene scene = read_mjcf(f.scene, {}, no_mesh);
  ASSERT_EQ(scene.unread.size(), 2u);
  for (const Sentence& what : scene.unread)
    EXPECT_NE(in_english(what).find("outside its folder"), std::string::npos) << in_english(what);
}

TEST(SceneRoots, APackageIsTheFolderOfItsManifest) {
  const TemporaryFolder folder;
  const char* const kRobot =
      "<robot name='r'><link name='l'><collision><geometry>"
      "<mesh filename='package://%/meshes/m.obj'/></geometry></collision></link></robot>";
  std::filesystem::create_directories(folder.file("arm/urdf"));
  std::filesystem::create_directories(folder.file("arm/meshes"));
  write_text(folder.file("arm/meshes/m.obj"),
             "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  std::string robot = kRobot;
  robot.replace(robot.find('%'), 1, "arm");
  write_text(folder.file("arm/urdf/r.urdf"), robot);
  EXPECT_EQ(read_urdf(folder.file("arm/urdf/r.urdf"), {}, no_mesh).unread.size(), 1u);
  write_text(folder.file("arm/package.xml"), "<package/>");
  const ForeignScene scene = read_urdf(folder.file("arm/urdf/r.urdf"), {}, no_mesh);
  EXPECT_TRUE(scene.unread.empty());
  EXPECT_EQ(scene.bodies.size(), 1u);
}

TEST(SceneRoots, ModelsOfSdfFromElsewhereAreNamed) {
  const TemporaryFolder folder;
  write_text(folder.file("w.sdf"),
             "<sdf version='1.8'><world name='w'><include><uri>file:///etc</uri></include>"
             "<include><uri>model://../x</uri></include></world></sdf>");
  const ForeignScene scene = read_sdf(folder.file("w.sdf"), {}, no_mesh);
  EXPECT_EQ(scene.unread.size() + scene.notes.size(), 2u);
}

TEST(XmlLimits, CountForAllFilesTogether) {
  const TemporaryFolder folder;
  write_text(folder.file("part.xml"), kPart);
  write_text(folder.file("s.xml"),
             "<mujoco><include file='part.xml'/><include file='part.xml'/></mujoco>");
  ForeignOptions options;
  EXPECT_EQ(refusal_of(folder.file("s.xml"), options), "");
  options.limits.max_elements = 7;
  EXPECT_NE(refusal_of(folder.file("s.xml"), options).find("too many elements"), std::string::npos);
  options.limits = {};
  options.limits.max_bytes = 200;
  EXPECT_NE(refusal_of(folder.file("s.xml"), options).find("bytes left"), std::string::npos);
}

}  // namespace
}  // namespace trivet
