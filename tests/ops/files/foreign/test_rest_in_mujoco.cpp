// Start states before and after settling, as MuJoCo moves them.
#include <gtest/gtest.h>

#include "core/io/foreign/foreign_testing.h"
#include "core/io/text/file_bytes.h"
#include "ops/files/foreign/findings.h"
#include "ops/files/foreign/joint_moves.h"
#include "ops/mend/mend.h"

#ifdef TRIVET_TEST_MUJOCO
#include <mujoco/mujoco.h>

namespace trivet {
namespace {

using namespace trivet::test;

constexpr double kSeconds = 2;

// The way that a body's centre of mass goes from the start state, metres; with free joints alone.
double moved_in_mujoco(const std::string& path, const std::string& body) {
  char error[1000] = "";
  mjModel* const model = mj_loadXML(path.c_str(), nullptr, error, sizeof error);
  EXPECT_TRUE(model) << error;
  if (!model) return -1;
  mjData* const data = mj_makeData(model);
  if (model->nkey > 0) mj_resetDataKeyframe(model, data, 0);
  mj_forward(model, data);
  const int id = mj_name2id(model, mjOBJ_BODY, body.c_str());
  EXPECT_GE(id, 0) << body;
  const Vec3 from = Eigen::Map<const Vec3>(data->xipos + 3 * id);
  while (data->time < kSeconds) mj_step(model, data);
  const double out = (Eigen::Map<const Vec3>(data->xipos + 3 * id) - from).norm();
  mj_deleteData(data);
  mj_deleteModel(model);
  return out;
}

struct BeforeAndAfter {
  TemporaryFolder folder;
  std::string before = folder.file("before.xml"), after = folder.file("after.xml");

  template <class Repair>
  BeforeAndAfter(const std::string& text, const Repair& repair) {
    write_text(before, text);
    OpenedScene opened = open_scene(before, {});
    NewPoses poses;
    for (const SettledObject& o : repair(opened.judged.scene).moved) poses[o.id] = o.to;
    opened.write(poses, after);
  }
};

TEST(RestInMujoco, CubesOfTheDrawerScene) {
  const std::string text =
      file_bytes(std::string(TRIVET_SOURCE_DIR) + "/tests/core/io/foreign/cases/drawer.xml",
                 1 << 20)
          .value_or("");
  const BeforeAndAfter scene(text, [](Scene& s) { return settle_scene(s, {}); });
  EXPECT_GT(moved_in_mujoco(scene.before, "in the drawer"), 9e-3);
  EXPECT_GT(moved_in_mujoco(scene.before, "sunk"), 1e-3);
  EXPECT_LT(moved_in_mujoco(scene.after, "in the drawer"), 1e-4);
  EXPECT_LT(moved_in_mujoco(scene.after, "sunk"), 1e-4);
}

// As a set of benchmark tasks stores its bowls, plates and boxes: centimetres in the air.
TEST(RestInMujoco, ALaidTable) {
  const char* const text = R"(<mujoco><worldbody>
    <geom type="plane" size="3 3 0.1"/>
    <body name="table" pos="0 0 0.4"><geom type="box" size="0.6 0.4 0.4"/></body>
    <body name="plate" pos="0 0 0.875"><freejoint/><geom type="cylinder" size="0.1 0.01"/></body>
    <body name="can" pos="0.3 0 0.92"><freejoint/><geom type="cylinder" size="0.03 0.06"/></body>
    </worldbody></mujoco>)";
  const BeforeAndAfter scene(text, [](Scene& s) { return settle_scene(s, {}); });
  for (const char* name : {"plate", "can"}) {
    EXPECT_GT(moved_in_mujoco(scene.before, name), 0.05) << name;
    EXPECT_LT(moved_in_mujoco(scene.after, name), 1e-3) << name;  // soft contacts let things sink
  }
}

// Finer meshes of ellipsoids that were tried came to rest on tips, from which MuJoCo tips them.
TEST(RestInMujoco, EggsCapsulesAndBalls) {
  const char* const text = R"(<mujoco><worldbody>
    <geom type="plane" size="3 3 0.1"/>
    <body name="egg" pos="0 0 0.0968"><freejoint/>
      <geom type="ellipsoid" size="0.033 0.03 0.05"/></body>
    <body name="capsule" pos="0.3 0 0.09"><freejoint/><geom type="capsule" size="0.02 0.03"/></body>
    <body name="ball" pos="0.6 0 0.1" quat="1 2 3 4"><freejoint/><geom size="0.035"/></body>
    </worldbody></mujoco>)";
  const BeforeAndAfter scene(text, [](Scene& s) { return settle_scene(s, {}); });
  for (const char* name : {"egg", "capsule", "ball"}) {
    EXPECT_GT(moved_in_mujoco(scene.before, name), 0.03) << name;
    EXPECT_LT(moved_in_mujoco(scene.after, name), 1e-3) << name;
  }
}

TEST(RestInMujoco, MendedNeighboursStay) {
  const char* const text = R"(<mujoco><worldbody>
    <geom type="plane" size="3 3 0.1"/>
    <body name="a" pos="0 0 0.049"><freejoint/><geom type="box" size="0.05 0.05 0.05"/></body>
    <body name="b" pos="0.096 0 0.052"><freejoint/><geom type="box" size="0.05 0.05 0.05"/></body>
    <body name="c" pos="0.05 0 0.148"><freejoint/><geom type="box" size="0.05 0.05 0.05"/></body>
    </worldbody></mujoco>)";
  const BeforeAndAfter scene(text, [](Scene& s) { return mend_scene(s, {}); });
  for (const char* name : {"a", "b", "c"})
    EXPECT_LT(moved_in_mujoco(scene.after, name), 5e-4) << name;
  EXPECT_GT(moved_in_mujoco(scene.before, "b"), 1e-3);
}

TEST(RestInMujoco, ContentsOfAClosedDrawer) {
  const std::string text =
      file_bytes(std::string(TRIVET_SOURCE_DIR) + "/tests/core/io/foreign/cases/drawer.xml",
                 1 << 20)
          .value_or("");
  const TemporaryFolder folder;
  write_text(folder.file("in.xml"), text);
  OpenedScene opened = open_scene(folder.file("in.xml"), {});
  NewPoses poses;
  for (const SettledObject& o : settle_scene(opened.judged.scene, {}).moved) poses[o.id] = o.to;
  move_joint_of(opened, joint_named(opened, "slide"), 0.05, OperationRun({}, {}), poses);
  opened.write_with_joints(poses, opened.joints, folder.file("out.xml"));
  EXPECT_LT(moved_in_mujoco(folder.file("out.xml"), "in the drawer"), 2e-4);
}

}  // namespace
}  // namespace trivet

#endif
