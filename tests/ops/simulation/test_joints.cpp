// Joints in files for simulators: kept with axis, limits and value, and at rest in MuJoCo.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/io/foreign/foreign_testing.h"
#include "core/io/foreign/joint_values.h"
#include "core/io/text/file_bytes.h"
#include "ops/check/check.h"
#include "ops/files/foreign/findings.h"
#include "ops/files/foreign/joint_moves.h"
#include "ops/mend/settle_free.h"
#include "ops/simulation/simulation.h"

#ifdef TRIVET_TEST_MUJOCO
#include <mujoco/mujoco.h>
#endif

namespace trivet {
namespace {

using namespace trivet::test;

std::string case_path(const std::string& name) {
  return std::string(TRIVET_SOURCE_DIR) + "/tests/core/io/foreign/cases/" + name;
}

/// The cabinet with its drawer open by 0.2 m, its lid ajar and the cube in the drawer.
struct ExportedCabinet {
  TemporaryFolder folder;
  OpenedScene opened = open_scene(case_path("drawer.urdf"), {});
  SimulationExport done;

  explicit ExportedCabinet(const std::string& file, double lid = 30, bool per_object = false) {
    NewPoses poses;
    for (const SettledObject& o : settle_scene(opened.judged.scene, {}).moved) poses[o.id] = o.to;
    move_joint_of(opened, joint_named(opened, "lid"), lid, OperationRun({}, {}), poses);
    update_contacts(opened.judged.scene, 0, {});
    SimulationOptions options;
    options.joints = std::make_shared<const std::vector<SceneJoint>>(opened.joints);
    options.files.per_object = per_object;
#ifdef TRIVET_TEST_MUJOCO
    options.files.mujoco = mj_versionString()[0] == '2' ? kOldestMujoco : kNewestMujoco;
#endif
    done = export_simulation(opened.judged.scene, folder.file(file), options);
  }
  std::string text(const std::string& file) const {
    return file_bytes(folder.file(file), 1 << 24).value_or("");
  }
  Pose pose(const Scene& scene, const std::string& name) const {
    return scene.at(*scene.find(name)).pose;
  }
};

size_t count(const std::string& text, const std::string& part) {
  size_t out = 0;
  for (size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++out;
  return out;
}

/// Read by Trivet again: limits count from `zero`, which is of the drawer.
void expect_kept(const ExportedCabinet& cabinet, const std::string& file, const std::string& prefix,
                 bool has_values, const std::string& lid_name = "lid") {
  OpenedScene again = open_scene(cabinet.folder.file(file), {});
  ASSERT_EQ(again.joints.size(), 2u);
  const SceneJoint& slide = joint_named(again, prefix + "slide");
  const double drawer = has_values ? 0.2 : 0, lid = has_values ? 30 : 0;
  EXPECT_NEAR(slide.value, drawer, 1e-12);
  EXPECT_NEAR(slide.lower - slide.value, -0.2, 1e-12);
  EXPECT_NEAR(slide.upper - slide.value, 0.1, 1e-12);
  EXPECT_LT((slide.axis - Vec3(0, -1, 0)).norm(), 1e-12);
  const SceneJoint& hinge = joint_named(again, prefix + lid_name);
  EXPECT_NEAR(hinge.value, lid, 1e-9);
  EXPECT_NEAR(hinge.upper - hinge.value, 60, 1e-9);
  EXPECT_NEAR(hinge.lower - hinge.value, -30, 1e-9);
  EXPECT_LT((hinge.axis - Vec3(-1, 0, 0)).norm(), 1e-9);
  EXPECT_LT((hinge.anchor - Vec3(hinge.anchor.x(), 0.2, 0.43)).norm(), 1e-9);
  EXPECT_EQ(slide.frames.size(), 1u);
  EXPECT_TRUE(judge(again, {}).ok()) << verdict_text(judge(again, {}));
  // The drawer closes, with what is in it.
  NewPoses poses;
  const JointMove move = move_joint_of(again, joint_named(again, prefix + "slide"), drawer - 0.2,
                                       OperationRun({}, {}), poses);
  EXPECT_EQ(move.end, JointMove::End::Reached)
      << named(again.judged.scene, move.blocker).name << " at " << move.value;
  EXPECT_EQ(move.carried.size(), 1u);
}

TEST(ExportedJoints, AreKeptInMjcf) {
  const ExportedCabinet cabinet("kitchen.xml");
  expect_kept(cabinet, "kitchen.xml", "", true);
}

TEST(ExportedJoints, AreKeptInUrdf) {
  const ExportedCabinet cabinet("kitchen.urdf");
  expect_kept(cabinet, "kitchen.urdf", "", false);
}

TEST(ExportedJoints, AreInTheFileOfTheBodyThatHasThem) {
  const ExportedCabinet cabinet("kitchen.urdf", 30, true);
  size_t with_files = 0;
  for (const SimulationBody& body : cabinet.done.scene.bodies) with_files += !body.own_file.empty();
  EXPECT_EQ(with_files, cabinet.done.scene.bodies.size() - 2);  // drawer and lid hang in it
  const auto& bodies = cabinet.done.scene.bodies;
  const size_t root = *cabinet.done.scene.joints.at(0).parent;
  const std::string text = cabinet.text(bodies[root].own_file);
  for (const SimulationJoint& joint : cabinet.done.scene.joints)
    EXPECT_EQ(count(text, "<child link=\"" + bodies[joint.child].file_name + "\"/>"), 1u);
  EXPECT_EQ(count(text, "<link name=\"world\"/>"), 0u);
}

TEST(ExportedJoints, AreKeptInSdf) {
  const ExportedCabinet cabinet("kitchen.sdf");
  expect_kept(cabinet, "kitchen.sdf", "world_2::", false, "lid_2");
}

TEST(ExportedJoints, AreKeptInUsd) {
  const ExportedCabinet cabinet("kitchen.usda");
  const std::string text = cabinet.text("kitchen.usda");
  EXPECT_EQ(count(text, "def PhysicsPrismaticJoint \"slide\""), 1u);
  EXPECT_EQ(count(text, "def PhysicsRevoluteJoint \"lid_2\""), 1u);
  EXPECT_EQ(count(text, "float physics:lowerLimit = 0\n"), 2u);
  EXPECT_EQ(count(text, "float physics:upperLimit = 0.3\n"), 1u);
  EXPECT_EQ(count(text, "float physics:upperLimit = 90\n"), 1u);
  EXPECT_EQ(count(text, "rel physics:body1 = </World/drawer>"), 1u);
  EXPECT_EQ(count(text, "rel physics:filteredPairs = ["), 2u);
  EXPECT_EQ(count(text, "PhysicsRigidBodyAPI"), 3u);  // drawer, lid and cube
}

TEST(ExportedJoints, WhatWouldSwingIsHeldByFrictionAndNamed) {
  const ExportedCabinet ajar("kitchen.xml"), closed("kitchen.xml", 0);
  const auto notes = [](const ExportedCabinet& cabinet) {
    return std::count_if(cabinet.done.notes.begin(), cabinet.done.notes.end(),
                         [](const Sentence& note) {
                           return in_english(note).find("would swing") != std::string::npos;
                         });
  };
  EXPECT_EQ(notes(ajar), 1);
  EXPECT_EQ(notes(closed), 0);
  // 2 kg at 0.2 m cos 30.
  const double load = 2 * 9.80665 * 0.2 * std::sqrt(0.75);
  EXPECT_NEAR(ajar.done.scene.joints[1].friction, 1.5 * load, 1e-6);
  EXPECT_EQ(closed.done.scene.joints[1].friction, 0);
}

TEST(ExportedJoints, ThatAreHeldAreFixedOnWhatCarriesThem) {
  const TemporaryFolder folder;
  const auto link = [](const std::string& name) {
    return "<link name='" + name +
           "'><collision><geometry><box size='0.1 0.1 0.1'/></geometry></collision></link>";
  };
  const auto joint = [](const std::string& name, const std::string& parent, const char* more) {
    return "<joint name='to " + name + "' type='prismatic'><parent link='" + parent +
           "'/><child link='" + name + "'/><origin xyz='0.2 0 0'/><limit lower='0' upper='1'/>" +
           more + "</joint>";
  };
  write_text(folder.file("in.urdf"), "<robot name='r'>" + link("a") + link("b") + link("c") +
                                         link("d") + joint("b", "a", "") +
                                         joint("c", "b", "<mimic joint='to d'/>") +
                                         joint("d", "b", "") + "</robot>");
  const OpenedScene opened = open_scene(folder.file("in.urdf"), {});
  SimulationOptions options;
  options.joints = std::make_shared<const std::vector<SceneJoint>>(opened.joints);
  const SimulationExport done =
      export_simulation(opened.judged.scene, folder.file("out.urdf"), options);
  ASSERT_EQ(done.scene.joints.size(), 3u);
  EXPECT_EQ(done.scene.joints[0].name, "to b");
  for (const size_t i : {size_t{1}, size_t{2}}) {
    EXPECT_EQ(done.scene.joints[i].kind, SimulationJoint::Kind::Fixed);
    EXPECT_EQ(done.scene.bodies[*done.scene.joints[i].parent].name, "b");
  }
  // Fixed links are one body with what carries them.
  OpenedScene again = open_scene(folder.file("out.urdf"), {});
  ASSERT_EQ(again.joints.size(), 1u);
  EXPECT_EQ(again.joints[0].links.size(), 1u);
}

TEST(ExportedJoints, CollidersThatTouchStayPartsOfTheirOwn) {
  const ExportedCabinet cabinet("kitchen.xml");
  for (const SimulationBody& body : cabinet.done.scene.bodies) {
    const size_t parts = cabinet.done.scene.models[body.model].parts.size();
    EXPECT_EQ(parts, body.name == "lid" || body.name == "cube" ? 1u : 4u) << body.name;
  }
}

TEST(ExportedJoints, OfManyNamesStayApart) {
  const TemporaryFolder folder;
  write_text(folder.file("in.xml"), R"(<mujoco><worldbody><geom type="plane" size="1 1 1"/>
    <body name="x" pos="0 0 1"><geom type="box" size=".1 .1 .1"/>
      <body name="y" pos="0.5 0 0"><joint name="x" axis="0 0 1" pos="-0.2 0 0"/>
        <geom type="box" size=".1 .1 .1"/></body></body></worldbody></mujoco>)");
  for (const char* name : {"out.xml", "out.urdf", "out.sdf", "out.usda"}) {
    const OpenedScene opened = open_scene(folder.file("in.xml"), {});
    SimulationOptions options;
    options.joints = std::make_shared<const std::vector<SceneJoint>>(opened.joints);
    const SimulationExport done =
        export_simulation(opened.judged.scene, folder.file(name), options);
    ASSERT_EQ(done.scene.joints.size(), 1u);
    const bool apart = std::string(name) == "out.sdf" || std::string(name) == "out.usda";
    EXPECT_EQ(done.scene.joints[0].file_name, apart ? "x_2" : "x") << name;
    EXPECT_EQ(done.scene.joints[0].lower, -kInfinity);
    if (std::string(name) == "out.usda") continue;
    const OpenedScene again = open_scene(folder.file(name), {});
    ASSERT_EQ(again.joints.size(), 1u) << name;
    // The axis is not through the link's origin: URDF gets a link between.
    EXPECT_LT((again.joints[0].anchor - Vec3(0.3, 0, again.joints[0].anchor.z())).norm(), 1e-9)
        << name;
    EXPECT_EQ(again.joints[0].lower, -kInfinity) << name;
  }
}

#ifdef TRIVET_TEST_MUJOCO

constexpr double kSecondsAtRest = 5;

TEST(ExportedJoints, AndContentsRestInMujoco) {
  for (const double lid : {0.0, 30.0}) {
    const ExportedCabinet cabinet("kitchen.xml", lid);
    char error[1000] = "";
    mjModel* const model =
        mj_loadXML(cabinet.folder.file("kitchen.xml").c_str(), nullptr, error, sizeof error);
    ASSERT_TRUE(model) << error;
    mjData* const data = mj_makeData(model);
    mj_forward(model, data);
    const std::vector<double> before(data->xpos, data->xpos + 3 * model->nbody);
    for (const SimulationBody& body : cabinet.done.scene.bodies) {
      const int id = mj_name2id(model, mjOBJ_BODY, body.file_name.c_str());
      ASSERT_GE(id, 0) << body.file_name;
      EXPECT_LT(
          (Eigen::Map<const Vec3>(data->xpos + 3 * id) - body.world_from_link.translation).norm(),
          1e-9)
          << body.name;
    }
    const int slide = mj_name2id(model, mjOBJ_JOINT, "slide");
    const int hinge = mj_name2id(model, mjOBJ_JOINT, "lid");
    ASSERT_GE(std::min(slide, hinge), 0);
    const double* const q = data->qpos;
    EXPECT_NEAR(q[model->jnt_qposadr[slide]], 0.2, 1e-12);
    while (data->time < kSecondsAtRest) mj_step(model, data);
    EXPECT_NEAR(q[model->jnt_qposadr[slide]], 0.2, 1e-4);
    EXPECT_NEAR(q[model->jnt_qposadr[hinge]], lid * 0.017453292519943295, 2e-3);
    const int cube = mj_name2id(model, mjOBJ_BODY, "cube");
    EXPECT_LT((Eigen::Map<const Vec3>(data->xpos + 3 * cube) -
               Eigen::Map<const Vec3>(before.data() + 3 * cube))
                  .norm(),
              1e-4);
    mj_deleteData(data);
    mj_deleteModel(model);
  }
}

#endif

}  // namespace
}  // namespace trivet
