// Scenes that share a folder of meshes: one file for all sizes of a model, read by the engines.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include "apps/demo/shapes/models.h"
#include "ops/files/layout/boxes.h"
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
#ifdef TRIVET_TEST_MUJOCO
#include <mujoco/mujoco.h>
#endif

namespace trivet {
namespace {

using namespace trivet::test;

/// Trays with a block in each, all of the same two models.
class TraysOfSizes {
 public:
  explicit TraysOfSizes(const std::vector<double>& sizes,
                        const Model& tray = open_box(0.2, 0.2, 0.01),
                        const Vec3& block = Vec3(0.1, 0.1, 0.060002), double half = 0.05)
      : m_tray(tray), m_block(box_model(half, half, half)) {
    for (const double size : sizes) {
      add("tray", m_tray, size, size * Vec3(0, 0, 0.010001));
      add("block", m_block, size, size * block);
      m_x += 1;
    }
  }
  const Scene& scene() const { return m_scene; }

 private:
  struct Shared {
    std::shared_ptr<const Model> model;
    std::shared_ptr<const Shape> shape;
    explicit Shared(Model made)
        : model(std::make_shared<const Model>(std::move(made))), shape(make_shape(model->mesh)) {}
  };
  void add(const std::string& name, const Shared& shared, double size, const Vec3& at) {
    Object object;
    object.name = name + "_" + std::to_string(int(m_x));
    object.model = shared.model, object.shape = shared.shape, object.scale = size;
    object.pose = {{}, at + Vec3(m_x, 0, 0)};
    object.placed = true, object.state = ObjectState::Stable;
    m_scene.add(std::move(object));
  }

  Shared m_tray, m_block;
  Scene m_scene;
  double m_x = 0;
};

SimulationExport export_shared(const Scene& scene, const std::string& path) {
  SimulationOptions options;
  options.files.mesh_folder = "meshes";
  options.files.for_many_scenes = true;
  options.files.mujoco = kOldestMujoco;
  return export_simulation(scene, path, options);
}

std::set<std::string> files_in(const std::string& folder) {
  std::set<std::string> out;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    out.insert(entry.path().filename().string());
  return out;
}

std::string text_of(const std::string& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

constexpr const char* kExtensions[] = {".xml", ".urdf", ".sdf", ".usda"};

TEST(ManyScenes, HaveOneFileForAllSizesOfAModel) {
  for (const std::string extension : kExtensions) {
    const TemporaryFolder folder;
    export_shared(TraysOfSizes({1}).scene(), folder.file("one" + extension));
    const std::set<std::string> of_one = files_in(folder.file("meshes"));
    EXPECT_GT(of_one.size(), 4u) << "the tray's parts";
    export_shared(TraysOfSizes({0.5, 1, 2}).scene(), folder.file("three" + extension));
    EXPECT_EQ(files_in(folder.file("meshes")), of_one) << extension;
  }
}

TEST(ManyScenes, ShareWholeModelsHoweverTheirPartsAreSplit) {
  const auto without_parts = [](const std::set<std::string>& files) {
    std::set<std::string> out;
    for (const std::string& file : files)
      if (file.find("_c_") == std::string::npos) out.insert(file);
    return out;
  };
  for (const std::string extension : kExtensions) {
    const TemporaryFolder folder;
    const auto bowl = [&](double size, const Vec3& block) {
      return TraysOfSizes({size}, shapes::make_bowl(), block, 0.01).scene();
    };
    export_shared(bowl(1, Vec3(0, 0, 0.06)), folder.file("one" + extension));
    const std::set<std::string> before = files_in(folder.file("meshes"));
    export_shared(bowl(1.3, Vec3(0.04, -0.01, 0.07)), folder.file("other" + extension));
    const std::set<std::string> after = files_in(folder.file("meshes"));
    EXPECT_EQ(without_parts(after), without_parts(before)) << extension;
    EXPECT_GT(after.size(), before.size()) << "other parts of the bowl";
  }
}

TEST(ManyScenes, StateSizesInUsdBelowTheBody) {
  const TemporaryFolder folder;
  export_shared(TraysOfSizes({0.5, 1, 2}).scene(), folder.file("scene.usda"));
  const std::string text = text_of(folder.file("scene.usda"));
  for (const std::string size : {"(0.5, 0.5, 0.5)", "(1, 1, 1)", "(2, 2, 2)"}) {
    const std::size_t at = text.find("xformOp:scale = " + size);
    ASSERT_NE(at, std::string::npos) << size;
    EXPECT_LT(text.rfind("physics:mass", at), text.rfind("def Xform \"Shape\"", at));
  }
  const std::regex reference("@\\./([^@]+)@");
  int count = 0;
  for (std::sregex_iterator it(text.begin(), text.end(), reference), end; it != end; ++it, ++count)
    EXPECT_TRUE(std::filesystem::exists(folder.file((*it)[1]))) << (*it)[1];
  EXPECT_GT(count, 12) << "six bodies and their parts";
}

TEST(ManyScenes, AreReadBySdformatWithTheirSizes) {
#ifdef TRIVET_TEST_SDFORMAT
  const TemporaryFolder folder;
  const SimulationExport done =
      export_shared(TraysOfSizes({0.5, 1, 2}).scene(), folder.file("scene.sdf"));
  sdf::Root root;
  for (const sdf::Error& error : root.Load(folder.file("scene.sdf")))
    ADD_FAILURE() << error.Message();
  ASSERT_EQ(root.WorldCount(), 1u);
  for (const SimulationBody& body : done.scene.bodies) {
    const SimulationModel& model = done.scene.models[body.model];
    const sdf::Link* const link = root.WorldByIndex(0)->ModelByName(body.file_name)->LinkByIndex(0);
    EXPECT_EQ(link->Inertial().MassMatrix().Mass(), body.mass);
    ASSERT_EQ(link->CollisionCount(), model.parts.size());
    EXPECT_EQ(link->VisualByIndex(0)->Geom()->MeshShape()->Scale().X(), model.scale);
    for (std::uint64_t i = 0; i < link->CollisionCount(); ++i) {
      const sdf::Mesh* const mesh = link->CollisionByIndex(i)->Geom()->MeshShape();
      EXPECT_EQ(mesh->Scale().Z(), model.scale);
      EXPECT_TRUE(std::filesystem::exists(folder.file(mesh->Uri()))) << mesh->Uri();
    }
  }
#else
  GTEST_SKIP() << "this build has no SDFormat (Debian: libsdformat-dev)";
#endif
}

// All worlds below the folder TRIVET_SDF_WORLDS, such as those of an exported batch.
TEST(ManyScenes, OfAFolderAreReadBySdformat) {
  const char* const worlds = std::getenv("TRIVET_SDF_WORLDS");
  if (!worlds) GTEST_SKIP() << "TRIVET_SDF_WORLDS names no folder";
#ifdef TRIVET_TEST_SDFORMAT
  int num_worlds = 0, num_models = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(worlds)) {
    if (entry.path().extension() != ".sdf") continue;
    sdf::Root root;
    for (const sdf::Error& error : root.Load(entry.path().string()))
      ADD_FAILURE() << entry.path() << ": " << error.Message();
    ASSERT_EQ(root.WorldCount(), 1u) << entry.path();
    for (std::uint64_t i = 0; i < root.WorldByIndex(0)->ModelCount(); ++i) {
      const sdf::Link* const link = root.WorldByIndex(0)->ModelByIndex(i)->LinkByIndex(0);
      const sdf::Mesh* const mesh = link->VisualByIndex(0)->Geom()->MeshShape();
      if (!mesh) continue;  // the floor
      EXPECT_TRUE(std::filesystem::exists(entry.path().parent_path() / mesh->Uri()));
      ++num_models;
    }
    ++num_worlds;
  }
  std::printf("%d worlds with %d objects are read by libsdformat\n", num_worlds, num_models);
  EXPECT_GT(num_models, 0);
#endif
}

TEST(ManyScenes, AreReadByUrdfdomWithTheirSizes) {
#ifdef TRIVET_TEST_URDFDOM
  const TemporaryFolder folder;
  const SimulationExport done =
      export_shared(TraysOfSizes({0.5, 1, 2}).scene(), folder.file("scene.urdf"));
  const urdf::ModelInterfaceSharedPtr robot = urdf::parseURDF(text_of(folder.file("scene.urdf")));
  ASSERT_TRUE(robot);
  for (const SimulationBody& body : done.scene.bodies) {
    const auto link = robot->getLink(body.file_name);
    ASSERT_TRUE(link);
    for (const auto& collision : link->collision_array) {
      const auto mesh = std::dynamic_pointer_cast<urdf::Mesh>(collision->geometry);
      ASSERT_TRUE(mesh);
      EXPECT_EQ(mesh->scale.y, done.scene.models[body.model].scale);
    }
  }
#else
  GTEST_SKIP() << "this build has no urdfdom (Debian: liburdfdom-dev)";
#endif
}

#ifdef TRIVET_TEST_MUJOCO
/// World box of a body's collision meshes.
Aabb box_in_mujoco(const mjModel& model, const mjData& data, int body) {
  Aabb out;
  for (int g = model.body_geomadr[body]; g < model.body_geomadr[body] + model.body_geomnum[body];
       ++g) {
    if (model.geom_type[g] != mjGEOM_MESH || model.geom_contype[g] == 0) continue;
    const int mesh = model.geom_dataid[g];
    for (int v = 0; v < model.mesh_vertnum[mesh]; ++v) {
      const float* const from = model.mesh_vert + 3 * (model.mesh_vertadr[mesh] + v);
      const mjtNum point[3] = {from[0], from[1], from[2]};
      mjtNum at[3];
      mju_rotVecMat(at, point, data.geom_xmat + 9 * g);
      out.extend(Vec3(at[0], at[1], at[2]) +
                 Vec3(data.geom_xpos[3 * g], data.geom_xpos[3 * g + 1], data.geom_xpos[3 * g + 2]));
    }
  }
  return out;
}
#endif

TEST(ManyScenes, AreOfTheirSizesAndAtRestInMuJoCo) {
#ifdef TRIVET_TEST_MUJOCO
  const TemporaryFolder folder;
  const TraysOfSizes trays({0.5, 1, 2});
  const SimulationExport done = export_shared(trays.scene(), folder.file("scene.xml"));
  char error[1000] = "";
  const std::unique_ptr<mjModel, void (*)(mjModel*)> model(
      mj_loadXML(folder.file("scene.xml").c_str(), nullptr, error, sizeof error), mj_deleteModel);
  ASSERT_TRUE(model) << error;
  const std::unique_ptr<mjData, void (*)(mjData*)> data(mj_makeData(model.get()), mj_deleteData);
  mj_forward(model.get(), data.get());
  const auto body_of = [&](const SimulationBody& body) {
    return mj_name2id(model.get(), mjOBJ_BODY, body.file_name.c_str());
  };
  std::vector<Aabb> before;
  for (const SimulationBody& body : done.scene.bodies) {
    const Object& object = trays.scene().at(*trays.scene().find(body.name));
    Aabb expected;
    for (const Vec3& v : object.shape->mesh.vertices)
      expected.extend(object.pose.translation + object.scale * v);
    before.push_back(box_in_mujoco(*model, *data, body_of(body)));
    EXPECT_LT((before.back().lower - expected.lower).norm(), 1e-5) << body.name;
    EXPECT_LT((before.back().upper - expected.upper).norm(), 1e-5) << body.name;
  }
  while (data->time < 1) mj_step(model.get(), data.get());
  mj_forward(model.get(), data.get());
  for (size_t i = 0; i < before.size(); ++i) {
    const Aabb after = box_in_mujoco(*model, *data, body_of(done.scene.bodies[i]));
    EXPECT_LT((after.lower - before[i].lower).norm(), 1e-3) << done.scene.bodies[i].name;
  }
#else
  GTEST_SKIP() << "this build has no MuJoCo (Debian: libmujoco-dev)";
#endif
}

}  // namespace
}  // namespace trivet
