// Exported scenes read by the libraries of their formats: the same objects, poses, masses.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "core/scene/transaction.h"
#include "ops/simulation/simulated_scene.h"
#include "ops/simulation/simulation.h"
#include "support/temporary_folder.h"

#ifdef TRIVET_TEST_URDFDOM
#include <urdf_parser/urdf_parser.h>
#endif
#ifdef TRIVET_TEST_SDFORMAT
// Third-party headers are exempt from our warnings.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpedantic"
#include <sdf/sdf.hh>
#pragma GCC diagnostic pop
#endif

namespace trivet {
namespace {

using namespace trivet::test;

/// Compares rotations as matrices, so that signs of quaternions do not matter.
void expect_same_pose(const Pose& pose, const Vec3& translation, const Rotation& rotation,
                      double tolerance) {
  EXPECT_LE((pose.translation - translation).norm(), tolerance);
  EXPECT_LE((pose.rotation.matrix() - rotation.matrix()).norm(), tolerance);
}

/// A scene with names that are invalid in every format, and with letters of several scripts.
SimulationExport exported(const TemporaryFolder& folder, const std::string& file,
                          const SimulationOptions& options = {}) {
  Scene scene = convex_objects().scene;
  const std::vector<ObjectId> ids = scene.ids();
  const std::vector<std::string> names = {"gr\u00fcne Tasse", "\u8336\u7897",
                                          "\u043a\u0443\u0431\u043e\u043a \u2615"};
  for (size_t i = 0; i < names.size(); ++i)
    edit_object(scene, ids.at(ids.size() - 1 - i), [&](Object& o) { o.name = names[i]; });
  return export_simulation(scene, folder.file(file), options);
}

const std::vector<std::string> kKeptNames = {"gr\u00fcne_Tasse", "\u8336\u7897",
                                             "\u043a\u0443\u0431\u043e\u043a_\u2615"};

#ifdef TRIVET_TEST_URDFDOM
urdf::ModelInterfaceSharedPtr robot_of(const std::string& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return urdf::parseURDF(text.str());
}
#endif

TEST(Urdf, OfEachObjectIsReadByUrdfdom) {
#ifdef TRIVET_TEST_URDFDOM
  const TemporaryFolder folder;
  SimulationOptions options;
  options.files.per_object = true;
  const SimulationExport done = exported(folder, "scene.urdf", options);
  for (const SimulationBody& body : done.scene.bodies) {
    const std::string path = folder.file(body.own_file);
    const urdf::ModelInterfaceSharedPtr robot = robot_of(path);
    ASSERT_TRUE(robot) << path;
    EXPECT_EQ(robot->getName(), body.file_name);
    EXPECT_EQ(robot->links_.size(), 1u);
    const urdf::LinkConstSharedPtr link = robot->getRoot();
    EXPECT_EQ(link->name, body.file_name);
    EXPECT_EQ(link->inertial->mass, body.mass);
    EXPECT_EQ(link->collision_array.size(), done.scene.models[body.model].parts.size());
    const auto mesh = std::dynamic_pointer_cast<urdf::Mesh>(link->collision_array[0]->geometry);
    EXPECT_TRUE(std::filesystem::exists(std::filesystem::path(path).parent_path() / mesh->filename))
        << mesh->filename;
  }
#else
  GTEST_SKIP() << "this build has no urdfdom (Debian: liburdfdom-dev)";
#endif
}

TEST(Urdf, IsReadByUrdfdom) {
#ifdef TRIVET_TEST_URDFDOM
  const TemporaryFolder folder;
  const SimulationExport done = exported(folder, "scene.urdf");
  const urdf::ModelInterfaceSharedPtr robot = robot_of(folder.file("scene.urdf"));
  ASSERT_TRUE(robot);
  EXPECT_EQ(robot->getRoot()->name, "world");
  EXPECT_EQ(robot->links_.size(), done.scene.bodies.size() + 2);  // world and floor
  for (const std::string& name : kKeptNames) EXPECT_TRUE(robot->getLink(name)) << name;
  for (const SimulationBody& body : done.scene.bodies) {
    const auto link = robot->getLink(body.file_name);
    ASSERT_TRUE(link) << body.file_name;
    const auto joint = link->parent_joint;
    EXPECT_EQ(joint->type, body.fixed ? urdf::Joint::FIXED : urdf::Joint::FLOATING);
    const urdf::Pose& pose = joint->parent_to_joint_origin_transform;
    expect_same_pose(body.world_from_link, Vec3(pose.position.x, pose.position.y, pose.position.z),
                     {pose.rotation.w, pose.rotation.x, pose.rotation.y, pose.rotation.z}, 1e-12);
    EXPECT_EQ(link->inertial->mass, body.mass);
    EXPECT_EQ(link->inertial->ixx, body.inertia(0, 0));
    EXPECT_EQ(link->inertial->iyz, body.inertia(1, 2));
    EXPECT_EQ(link->collision_array.size(), done.scene.models[body.model].parts.size());
    const auto mesh = std::dynamic_pointer_cast<urdf::Mesh>(link->visual->geometry);
    ASSERT_TRUE(mesh);
    EXPECT_TRUE(std::filesystem::exists(folder.file(mesh->filename))) << mesh->filename;
  }
#else
  GTEST_SKIP() << "this build has no urdfdom (Debian: liburdfdom-dev)";
#endif
}

TEST(Sdf, IsReadBySdformat) {
#ifdef TRIVET_TEST_SDFORMAT
  const TemporaryFolder folder;
  const SimulationExport done = exported(folder, "scene.sdf");
  sdf::Root root;
  for (const sdf::Error& error : root.Load(folder.file("scene.sdf")))
    ADD_FAILURE() << error.Message();
  ASSERT_EQ(root.WorldCount(), 1u);
  const sdf::World* const world = root.WorldByIndex(0);
  EXPECT_EQ(world->ModelCount(), done.scene.bodies.size() + 1);  // plus the floor
  for (const std::string& name : kKeptNames) EXPECT_TRUE(world->ModelByName(name)) << name;
  for (const SimulationBody& body : done.scene.bodies) {
    const sdf::Model* const model = world->ModelByName(body.file_name);
    ASSERT_TRUE(model) << body.file_name;
    EXPECT_EQ(model->Static(), body.fixed);
    const ignition::math::Pose3d& pose = model->RawPose();
    expect_same_pose(body.world_from_link, Vec3(pose.Pos().X(), pose.Pos().Y(), pose.Pos().Z()),
                     {pose.Rot().W(), pose.Rot().X(), pose.Rot().Y(), pose.Rot().Z()}, 1e-12);
    const sdf::Link* const link = model->LinkByIndex(0);
    EXPECT_TRUE(link->Inertial().MassMatrix().IsValid());
    EXPECT_EQ(link->Inertial().MassMatrix().Mass(), body.mass);
    EXPECT_EQ(link->Inertial().MassMatrix().Ixx(), body.inertia(0, 0));
    EXPECT_EQ(link->CollisionCount(), done.scene.models[body.model].parts.size());
    const sdf::Collision* const collision = link->CollisionByIndex(0);
    const sdf::ElementPtr friction =
        collision->Element()->GetElement("surface")->GetElement("friction");
    EXPECT_EQ(friction->GetElement("ode")->Get<double>("mu"), body.friction);
    const sdf::Mesh* const mesh = link->VisualByIndex(0)->Geom()->MeshShape();
    ASSERT_TRUE(mesh);
    EXPECT_TRUE(std::filesystem::exists(folder.file(mesh->Uri()))) << mesh->Uri();
  }
#else
  GTEST_SKIP() << "this build has no SDFormat (Debian: libsdformat-dev)";
#endif
}

}  // namespace
}  // namespace trivet
