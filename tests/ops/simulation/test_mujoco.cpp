// MuJoCo on exported scenes: loads and simulates them, and no object moves.
#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <map>
#include <set>

#include "core/base/error.h"
#include "core/scene/transaction.h"
#include "ops/files/layout/boxes.h"
#include "ops/files/layout/run.h"
#include "ops/simulation/simulate.h"
#include "ops/simulation/simulated_scene.h"
#include "ops/simulation/simulation.h"
#include "support/effort.h"
#include "support/settle_options.h"
#include "support/shared_data.h"
#include "support/temporary_folder.h"

#ifdef TRIVET_TEST_MUJOCO
#include <mujoco/mujoco.h>

namespace trivet {
namespace {

using namespace trivet::test;

constexpr double kSeconds = 10;

/// Written in the dialect of the MuJoCo that these tests link.
SimulationExport export_for_this(const Scene& scene, const std::string& path,
                                 SimulationOptions options = {}) {
  options.files.mujoco = mj_versionString()[0] == '2' ? kOldestMujoco : kNewestMujoco;
  return export_simulation(scene, path, options);
}

class Simulation {
 public:
  explicit Simulation(const std::string& path) {
    char error[1000] = "";
    m_model = mj_loadXML(path.c_str(), nullptr, error, sizeof error);
    EXPECT_TRUE(m_model) << error;
    if (!m_model) return;
    m_data = mj_makeData(m_model);
    mj_forward(m_model, m_data);
  }
  ~Simulation() {
    mj_deleteData(m_data);
    mj_deleteModel(m_model);
  }
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;

  explicit operator bool() const { return m_model; }
  const mjModel& model() const { return *m_model; }
  const mjData& data() const { return *m_data; }

  int body(const SimulationBody& b) const {
    return mj_name2id(m_model, mjOBJ_BODY, b.file_name.c_str());
  }
  Affine pose(const SimulationBody& b) const {
    Affine out;
    const int id = body(b);
    for (int r = 0; r < 3; ++r) {
      out.translation[r] = m_data->xpos[3 * id + r];
      for (int c = 0; c < 3; ++c) out.linear(r, c) = m_data->xmat[9 * id + 3 * r + c];
    }
    return out;
  }
  void set_pose(const SimulationBody& b, const Pose& pose) {
    const int joint = m_model->body_jntadr[body(b)];
    double* const q = m_data->qpos + m_model->jnt_qposadr[joint];
    for (int i = 0; i < 3; ++i) q[i] = pose.translation[i];
    const Rotation& r = pose.rotation;
    q[3] = r.w, q[4] = r.x, q[5] = r.y, q[6] = r.z;
    mj_forward(m_model, m_data);
  }
  void run(double seconds) {
    const double end = m_data->time + seconds;
    while (m_data->time < end) mj_step(m_model, m_data);
  }
  int warnings() const {
    int count = 0;
    for (const mjWarningStat& warning : m_data->warning) count += warning.number;
    return count;
  }

 private:
  mjModel* m_model = nullptr;
  mjData* m_data = nullptr;
};

/// Largest displacement of a body's corners, metres.
double largest_move(const SimulationModel& model, const Affine& from, const Affine& to) {
  double largest = 0;
  for (const ConvexPart& part : model.parts)
    for (const Vec3& v : part.vertices)
      largest = std::max(largest, (to.apply(v) - from.apply(v)).norm());
  return largest;
}

TEST(MuJoCo, KeepsSceneOfConvexObjectsAtRest) {
  const TemporaryFolder folder;
  const LaidOut laid_out = convex_objects();
  const SimulationExport done = export_for_this(laid_out.scene, folder.file("scene.xml"));
  for (const PartOverlap& o : done.overlaps)
    ADD_FAILURE() << o.a << " and " << o.b << " overlap by " << o.depth;
  Simulation simulation(folder.file("scene.xml"));
  ASSERT_TRUE(simulation);
  std::vector<Affine> before;
  for (const SimulationBody& body : done.scene.bodies) before.push_back(simulation.pose(body));
  simulation.run(kSeconds);
  EXPECT_EQ(simulation.warnings(), 0);
  size_t num_free = 0;
  for (size_t i = 0; i < before.size(); ++i) {
    const SimulationBody& body = done.scene.bodies[i];
    num_free += !body.fixed;
    const double moved =
        largest_move(done.scene.models[body.model], before[i], simulation.pose(body));
    std::printf("%-20s moved %.3g mm in %g s\n", body.name.c_str(), 1000 * moved, kSeconds);
    EXPECT_LT(moved, 1e-3) << body.name;
  }
  EXPECT_EQ(num_free, laid_out.starts.size());
}

/// For comparison: MuJoCo drops the objects itself, one after the other from the starts of Trivet's
/// PUTs. Reported, not judged.
TEST(MuJoCo, SettlesSameSceneItself) {
  const TemporaryFolder folder;
  const LaidOut laid_out = convex_objects();
  const SimulationExport done = export_for_this(laid_out.scene, folder.file("scene.xml"));
  Simulation simulation(folder.file("scene.xml"));
  ASSERT_TRUE(simulation);
  std::map<std::string, const SimulationBody*> body_of;
  for (const SimulationBody& body : done.scene.bodies) body_of[body.name] = &body;
  // Waiting objects stay far below the floor, out of the way; the plane supports those beside.
  std::vector<Affine> rests;
  for (const LetGo& start : laid_out.starts)
    rests.push_back(simulation.pose(*body_of.at(start.name)));
  for (size_t i = 0; i < laid_out.starts.size(); ++i)
    simulation.set_pose(*body_of.at(laid_out.starts[i].name),
                        {{}, Vec3(100 + 10.0 * static_cast<double>(i), 100, 2)});
  for (const LetGo& start : laid_out.starts) {
    simulation.set_pose(*body_of.at(start.name), start.pose);
    simulation.run(2);
  }
  simulation.run(kSeconds - 2);
  for (size_t i = 0; i < rests.size(); ++i) {
    const SimulationBody& body = *body_of.at(laid_out.starts[i].name);
    const double apart =
        largest_move(done.scene.models[body.model], rests[i], simulation.pose(body));
    std::printf("%-20s %.3g mm from where Trivet put it\n", body.name.c_str(), 1000 * apart);
    EXPECT_TRUE(std::isfinite(apart));
  }
}

TEST(MuJoCo, AgreesOnMassesAndInertias) {
  const TemporaryFolder folder;
  const LaidOut laid_out = convex_objects();
  SimulationOptions options;
  options.density = 700;
  const SimulationExport done = export_for_this(laid_out.scene, folder.file("scene.xml"), options);
  Simulation simulation(folder.file("scene.xml"));
  ASSERT_TRUE(simulation);
  for (const SimulationBody& body : done.scene.bodies) {
    const int id = simulation.body(body);
    ASSERT_GE(id, 0) << body.file_name;
    const mjModel& m = simulation.model();
    EXPECT_NEAR(m.body_mass[id], body.mass, 1e-12 * body.mass);
    const double* const i = m.body_inertia + 3 * id;
    EXPECT_NEAR(i[0] + i[1] + i[2], body.inertia.trace(), 1e-9 * body.inertia.trace());
    // MuJoCo's own values, from the volume of the part's mesh at density 1: each body has one part
    // here.
    int geom = m.body_geomadr[id] + m.body_geomnum[id] - 1;
    while (m.geom_type[geom] == mjGEOM_SPHERE) --geom;  // corners on the floor
    ASSERT_EQ(m.geom_type[geom], mjGEOM_MESH);
    const double volume = volume_of(done.scene.models[body.model].parts.at(0));
    EXPECT_NEAR(body.mass, *options.density * volume, 1e-4 * body.mass) << body.name;
  }
}

// A brick on a slab that lies on the floor: of each pair the smaller coefficient.
TEST(MuJoCo, TakesSmallerFrictionOfPairs) {
  const TemporaryFolder folder;
  Scene scene;
  const auto add = [&](const char* name, const Model& model, const Vec3& at, double friction) {
    Object object;
    object.name = name;
    object.model = std::make_shared<const Model>(model);
    object.shape = make_shape(model.mesh);
    object.pose.translation = at, object.placed = true;
    object.material.friction = friction;
    scene.add(std::move(object));
  };
  add("slab", box_model(0.5, 0.5, 0.05), Vec3(0, 0, 0.05), 0.7);
  add("brick", box_model(0.1, 0.1, 0.1), Vec3(0, 0, 0.2), 0.3);
  scene.floor_material.friction = 0.2;
  export_for_this(scene, folder.file("scene.xml"));
  Simulation simulation(folder.file("scene.xml"));
  ASSERT_TRUE(simulation);
  simulation.run(0.1);
  std::set<double> found;
  for (int i = 0; i < simulation.data().ncon; ++i)
    found.insert(simulation.data().contact[i].friction[0]);
  EXPECT_EQ(found, (std::set<double>{0.2, 0.3}));
}

TEST(MuJoCo, SimulatesWhatWasExported) {
  if (!can_simulate()) GTEST_SKIP() << "this build has no MuJoCo (Debian: libmujoco-dev)";
  const TemporaryFolder folder;
  LaidOut laid_out = convex_objects();
  SimulationOptions options;
  options.friction = 1;
  const SimulationExport stands =
      export_simulation(laid_out.scene, folder.file("scene.xml"), options);
  const SimulatedScene quiet = simulate(stands, 1);
  EXPECT_EQ(quiet.objects.size(), laid_out.starts.size());
  EXPECT_TRUE(stays(quiet));
  for (const SimulatedObject& o : quiet.objects) EXPECT_LT(o.moved, 1e-3) << o.name;
  const ObjectId box = *laid_out.scene.find("on floor");
  edit_object(laid_out.scene, box, [](Object& o) { o.pose.translation.z() += 0.5; });
  const SimulatedScene falls =
      simulate(export_simulation(laid_out.scene, folder.file("up.xml"), options), 1);
  EXPECT_FALSE(stays(falls));
  for (const SimulatedObject& o : falls.objects)
    if (o.name == "on floor") {  // half a metre, less 0.2 where it falls onto "on floor, too"
      EXPECT_GT(o.moved, 0.25);
    }
}

// Ten household objects in a bin, put one after another. With a hull for each component the bin is
// full, and all are thrown out. Whether they rest is up to friction, too: all need less than 2.
TEST(MuJoCo, LeavesObjectsInBin) {
  TRIVET_NEEDS_DATA("models/drake_bin.gltf");
  std::ifstream file(TRIVET_SOURCE_DIR "/tests/ops/simulation/bin.json");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const Layout layout = parse_layout(text, "bin.json");
  RunOptions as_paper;  // at the materials' friction two of them are refused
  as_paper.settle = test::perfect_friction();
  const LayoutRun run = run_layout(layout, models_in_folder(shared_data("models")), as_paper);
  ASSERT_TRUE(run.ok());
  const TemporaryFolder folder;
  SimulationOptions options;
  options.friction = 2;
  const SimulationExport done = export_simulation(run.scene, folder.file("bin.xml"), options);
  for (const PartOverlap& o : done.overlaps) EXPECT_LE(o.depth, o.allowed) << o.a << " " << o.b;
  const double seconds = test::with_effort(100) < 40 ? 1 : 5;  // simulated: most of the test's time
  const SimulatedScene simulated = simulate(done, seconds);
  ASSERT_EQ(simulated.objects.size(), 10u);
  EXPECT_EQ(simulated.num_warnings, 0);
  for (const SimulatedObject& o : simulated.objects) {
    std::printf("%-20s moved %.3g mm\n", o.name.c_str(), 1000 * o.moved);
    EXPECT_LT(o.moved, 1e-3) << o.name;
  }
  options.collision = CollisionRule::Components;
  EXPECT_THROW(export_simulation(run.scene, folder.file("hulls.xml"), options), Error);
}

}  // namespace
}  // namespace trivet

#else

TEST(MuJoCo, KeepsSceneOfConvexObjectsAtRest) {
  GTEST_SKIP() << "this build has no MuJoCo (Debian: libmujoco-dev)";
}

#endif
