// MuJoCo itself as the judge of what the reader computes.
#include <gtest/gtest.h>

#include "core/io/foreign/foreign_testing.h"

#ifdef TRIVET_TEST_MUJOCO
#include <mujoco/mujoco.h>

#include <fstream>
#include <nlohmann/json.hpp>

namespace trivet {
namespace {

using namespace trivet::test;

constexpr double kRounding = 1e-12;

/// A model as MuJoCo compiles it, at the reference or at a keyframe.
class Compiled {
 public:
  Compiled(const std::string& path, int key) {
    char error[1000] = "";
    m_model = mj_loadXML(path.c_str(), nullptr, error, sizeof error);
    EXPECT_TRUE(m_model) << error;
    if (!m_model) return;
    m_data = mj_makeData(m_model);
    if (key >= 0) mj_resetDataKeyframe(m_model, m_data, key);
    mj_kinematics(m_model, m_data);
    mj_comPos(m_model, m_data);
  }
  ~Compiled() {
    mj_deleteData(m_data);
    mj_deleteModel(m_model);
  }
  Compiled(const Compiled&) = delete;
  Compiled& operator=(const Compiled&) = delete;
  explicit operator bool() const { return m_model; }

  int id(const std::string& name) const { return mj_name2id(m_model, mjOBJ_BODY, name.c_str()); }
  Pose pose(int body) const {
    const double *p = m_data->xpos + 3 * body, *q = m_data->xquat + 4 * body;
    return {{q[0], q[1], q[2], q[3]}, {p[0], p[1], p[2]}};
  }
  double mass(int body) const { return m_model->body_mass[body]; }
  Vec3 centre(int body) const { return Eigen::Map<const Vec3>(m_data->xipos + 3 * body); }
  Vec3 moments(int body) const { return Eigen::Map<const Vec3>(m_model->body_inertia + 3 * body); }

 private:
  mjModel* m_model = nullptr;
  mjData* m_data = nullptr;
};

double difference(const Pose& a, const Pose& b) {
  const Mat3 turned = a.rotation.matrix() - b.rotation.matrix();
  return std::max((a.translation - b.translation).norm(), turned.cwiseAbs().maxCoeff());
}

void expect_as_mujoco(const std::string& path, const ForeignScene& scene, int key) {
  const Compiled compiled(path, key);
  ASSERT_TRUE(compiled);
  int compared = 0;
  for (const ForeignBody& body : scene.bodies) {
    const int id = compiled.id(body.name);
    if (id < 0) continue;  // a geom of the world
    ++compared;
    EXPECT_LT(difference(body.pose, compiled.pose(id)), kRounding) << body.name;
  }
  EXPECT_GE(compared, 3);
}

TEST(MujocoPoses, AreOursAtTheReferenceAndAtAKey) {
  const TemporaryFolder folder;
  const std::string path = folder.file("scene.xml");
  write_text(path, kFrames);
  expect_as_mujoco(path, read_mjcf(path, {}, no_mesh), 0);
  ForeignOptions reference;
  reference.key = "none";
  expect_as_mujoco(path, read_mjcf(path, reference, no_mesh), -1);
}

TEST(MujocoMasses, AreOurs) {
  const TemporaryFolder folder;
  const std::string path = folder.file("scene.xml");
  write_text(path, kFrames);
  const Compiled compiled(path, 0);
  const ForeignScene scene = read_mjcf(path, {}, no_mesh);
  ASSERT_TRUE(compiled);
  for (const char* name : {"turned", "axes", "ball", "given"}) {
    const ForeignBody* const body = find_body(scene, name);
    ASSERT_TRUE(body && body->mass) << name;
    const int id = compiled.id(name);
    EXPECT_NEAR(body->mass->kilograms, compiled.mass(id), 1e-12 * compiled.mass(id)) << name;
    const Vec3 centre = world_from_object(body->pose, UpAxis::Z, 1).apply(*body->mass->centre);
    EXPECT_LT((centre - compiled.centre(id)).norm(), kRounding) << name;
    ASSERT_TRUE(body->mass->inertia) << name;
    EXPECT_NEAR(body->mass->inertia->trace(), compiled.moments(id).sum(),
                1e-10 * compiled.moments(id).sum())
        << name;
  }
  // Welded bodies are two for MuJoCo, and its version 2 weighs meshes otherwise: a box of 3 kg and
  // a pyramid of 4 kg.
  const double box = compiled.mass(compiled.id("welded"));
  EXPECT_NEAR(find_body(scene, "loose")->mass->kilograms, box + 4, 1e-9);
}

}  // namespace
}  // namespace trivet

#endif
