// Poses, masses and centres of cases/ against what MuJoCo 3.14, libsdformat 12 and hand computed.
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

#include "core/io/foreign/foreign_testing.h"
#include "core/io/foreign/sdf.h"

namespace trivet {
namespace {

using namespace trivet::test;
using nlohmann::json;

constexpr double kClose = 1e-12;
constexpr double kRounded = 1e-11;  // of figures that were printed with 12 digits

std::string case_file(const std::string& name) {
  return std::string(TRIVET_SOURCE_DIR) + "/tests/core/io/foreign/cases/" + name;
}

json expected() {
  std::ifstream in(case_file("expected.json"));
  return json::parse(in);
}

Vec3 vec3(const json& j) {
  return Vec3(j[0].get<double>(), j[1].get<double>(), j[2].get<double>());
}
Mat3 turn_of(const json& j) {
  if (j.size() == 4)
    return Rotation{j[0].get<double>(), j[1].get<double>(), j[2].get<double>(), j[3].get<double>()}
        .normalized()
        .matrix();
  Mat3 out;
  for (int i = 0; i < 9; ++i) out(i / 3, i % 3) = j[static_cast<size_t>(i)];
  return out;
}

void expect_pose(const Pose& pose, const json& j, double close, const std::string& what) {
  EXPECT_LT((pose.translation - vec3(j[0])).norm(), close) << what;
  EXPECT_LT((pose.rotation.matrix() - turn_of(j[1])).cwiseAbs().maxCoeff(), close) << what;
}

// MuJoCo has these as several bodies without joints between, we as one.
const std::map<std::string, std::vector<std::string>> kWelded = {{"turned", {"turned", "axes"}}};

void expect_mass(const ForeignBody& body, const json& want) {
  const auto welded = kWelded.find(body.name);
  const std::vector<std::string> names =
      welded == kWelded.end() ? std::vector<std::string>{body.name} : welded->second;
  double mass = 0;
  Vec3 moment = Vec3::Zero();
  for (const std::string& name : names) {
    mass += want["mass"][name].get<double>();
    moment += want["mass"][name].get<double>() * vec3(want["centre of mass"][name]);
  }
  EXPECT_NEAR(body.mass->kilograms, mass, 1e-9 * mass) << body.name;
  const Vec3 centre =
      composed(body.pose, {{}, body.mass->centre.value_or(Vec3::Zero())}).translation;
  EXPECT_LT((centre - moment / mass).norm(), 1e-9) << body.name;
}

void expect_as(const ForeignScene& scene, const json& want, size_t num_bodies) {
  size_t found = 0;
  for (const ForeignBody& body : scene.bodies) {
    for (const ForeignCollider& c : body.colliders)
      if (want["geoms"].contains(c.name) && c.name != "hull")  // MuJoCo moves the frame of meshes
        expect_pose(composed(body.pose, c.pose), want["geoms"][c.name], kClose, c.name);
    if (!want["bodies"].contains(body.name)) continue;
    ++found;
    expect_pose(body.pose, want["bodies"][body.name], kClose, body.name);
    if (body.mass) expect_mass(body, want);
  }
  EXPECT_EQ(found, num_bodies);
}

TEST(KnownPoses, MjcfIsAsMuJoCoHasIt) {
  const json want = expected();
  ForeignOptions reference;
  reference.key = "none";
  expect_as(read_mjcf(case_file("frames.xml"), reference, no_mesh), want["frames.xml"]["reference"],
            2);
  expect_as(read_mjcf(case_file("frames.xml"), {}, no_mesh), want["frames.xml"]["key home"], 2);
  expect_as(read_mjcf(case_file("drawer.xml"), reference, no_mesh), want["drawer.xml"]["reference"],
            6);
  expect_as(read_mjcf(case_file("drawer.xml"), {}, no_mesh), want["drawer.xml"]["key open"], 6);
}

TEST(KnownPoses, UrdfIsClosed) {
  const json want = expected()["cabinet.urdf"]["closed"];
  const ForeignScene scene = read_urdf(case_file("cabinet.urdf"), {}, no_mesh);
  // "base" has no collision, "body" is fixed to it.
  for (const char* name : {"door", "second", "drawer"}) {
    const ForeignBody* const body = find_body(scene, name);
    ASSERT_TRUE(body) << name;
    EXPECT_TRUE(body->is_link);
    if (std::string(name) != "second") expect_pose(body->pose, want[name], kRounded, name);
  }
  EXPECT_EQ(scene.num_joints, 3u);
}

// MuJoCo has these poses for the door at 1 and the drawer at 0.2; "second" mimics the door.
TEST(KnownPoses, UrdfIsOpenByAFileOfValues) {
  const TemporaryFolder folder;
  std::filesystem::copy(case_file("cabinet.urdf"), folder.file("cabinet.urdf"));
  write_text(folder.file("cabinet.urdf.joints.json"), "{\"door\": 1, \"drawer\": 0.2}");
  const ForeignScene scene = read_urdf(folder.file("cabinet.urdf"), {}, no_mesh);
  const json want = expected()["cabinet.urdf"]["door at 1, drawer at 0.2 (second follows: -0.4)"];
  for (const char* name : {"door", "second", "drawer"})
    expect_pose(find_body(scene, name)->pose, want[name], kRounded, name);
  for (const ForeignJoint& joint : scene.joints)
    EXPECT_EQ(joint.held.empty(), joint.name == "drawer") << joint.name;
}

TEST(KnownPoses, SdfFramesAreResolved) {
  const json want = expected()["world.sdf"];
  const ForeignScene scene = read_sdf(case_file("world.sdf"), {}, no_mesh);
  for (const char* name : {"plate", "cup", "cup::lid"}) {
    const ForeignBody* const body = find_body(scene, name);
    ASSERT_TRUE(body) << name;
    expect_pose(body->pose, want[name], kRounded, name);
    const std::string link = std::string(name) == "cup::lid" ? "k" : "l";
    expect_pose(composed(body->pose, body->colliders[0].pose),
                want[std::string(name) + "::" + link + "::c"], kRounded, name);
  }
}

}  // namespace
}  // namespace trivet
