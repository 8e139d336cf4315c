// Images of base colours in the files of all simulators, where each corner finds its colour again.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "core/io/read_model.h"
#include "core/io/textures/decoded_image.h"
#include "ops/simulation/simulation.h"
#include "support/temporary_folder.h"
#include "support/textured_square.h"

#ifdef TRIVET_TEST_MUJOCO
#include <mujoco/mujoco.h>
#endif

namespace trivet {
namespace {

using namespace trivet::test;

std::string bytes_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// A block of 1 x 1 x 0.5 m: each side shows an image of four colours, half of the light of each.
constexpr const char* kBlock =
    "mtllib block.mtl\n"
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 .5\nv 1 0 .5\nv 1 1 .5\nv 0 1 .5\n"
    "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nusemtl paper\n"
    "f 5/1 6/2 7/3 8/4\nf 4/1 3/2 2/3 1/4\nf 1/1 2/2 6/3 5/4\n"
    "usemtl tape\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
constexpr const char* kMaterials =
    "newmtl paper\nKd 1 1 1\nmap_Kd colours.png\nnewmtl tape\nKd 0.2 0.3 0.4\n";

class Looks : public ::testing::Test {
 protected:
  Looks() {
    write("block.obj", kBlock);
    write("block.mtl", kMaterials);
    write("colours.png", testing::four_colours_png());
    Object object;
    object.name = "block";
    object.model = std::make_shared<const Model>(read_model(m_folder.file("block.obj")));
    object.shape = make_shape(object.model->mesh);
    object.pose.translation = Vec3(0, 0, 1e-6);
    object.placed = true, object.state = ObjectState::Stable;
    m_scene.add(std::move(object));
  }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(m_folder.file(name), std::ios::binary) << text;
  }
  /// Files of the export, by ending.
  std::map<std::string, std::string> exported(const std::string& name, int mujoco = 3) const {
    SimulationOptions options;
    options.files.mujoco = mujoco;
    std::map<std::string, std::string> out;
    for (const std::string& file : export_simulation(m_scene, m_folder.file(name), options).files) {
      const std::string text = bytes_of(file);
      if (text.find("mtllib") == std::string::npos || text.find("vt ") != std::string::npos)
        out[std::filesystem::path(file).extension().string()] += text;
    }
    return out;
  }

  TemporaryFolder m_folder;
  Scene m_scene;
};

std::vector<int> colours(const std::string& png) {
  std::vector<int> out;
  const DecodedImage image = decode_image(png);
  for (size_t i = 0; i < image.rgba.size(); ++i)
    if (i % 4 != 3) out.push_back(image.rgba[i]);
  return out;
}

bool has(const std::string& text, const std::string& what) {
  return text.find(what) != std::string::npos;
}

TEST_F(Looks, AreInObjFilesOfSdfAndUrdf) {
  for (const char* const name : {"s.sdf", "s.urdf"}) {
    auto files = exported(name);
    EXPECT_EQ(colours(files[".png"]), colours(testing::four_colours_png()));
    EXPECT_TRUE(has(files[".mtl"], "map_Kd block_t0_")) << files[".mtl"];
    EXPECT_TRUE(has(files[".mtl"], "newmtl material1\nKd 0.")) << files[".mtl"];
    const std::string& obj = files[".obj"];
    for (const char* const line : {"vt 0 0\n", "vt 1 0\n", "vt 1 1\n", "vt 0 1\n"})
      EXPECT_TRUE(has(obj, line)) << line;
    EXPECT_TRUE(has(obj, "v 0 0 0.5\n") && has(obj, "usemtl material1\nf ")) << obj;
    EXPECT_TRUE(has(obj, "f 1/1 2/2 3/3\n")) << obj;
  }
}

TEST_F(Looks, AreInUsdAsPrimvarsAndShaders) {
  auto files = exported("s.usda");
  EXPECT_EQ(colours(files[".png"]), colours(testing::four_colours_png()));
  const std::string& usd = files[".usda"];
  EXPECT_TRUE(
      has(usd, "texCoord2f[] primvars:st = [(0, 0), (1, 0), (1, 1), (0, 0), (1, 1), (0, 1)"));
  EXPECT_TRUE(has(usd, "inputs:file = @./block_t0_"));
  EXPECT_TRUE(has(usd, "color3f inputs:diffuseColor.connect = </block/Looks/Material0/Image."));
  EXPECT_TRUE(has(usd, "float2 inputs:st.connect = </block/Looks/Material0/Coordinates."));
  EXPECT_TRUE(has(usd, "color3f inputs:diffuseColor = ("));  // of the tape
}

TEST_F(Looks, AreAssetsOfMujoco) {
  auto files = exported("s.xml");
  EXPECT_TRUE(has(files[".xml"], "<texture name=\"block_t0_")) << files[".xml"];
#ifdef TRIVET_TEST_MUJOCO
  exported("s.xml", mj_versionString()[0] - '0');
  char error[1000] = "";
  mjModel* const model = mj_loadXML(m_folder.file("s.xml").c_str(), nullptr, error, sizeof error);
  ASSERT_TRUE(model) << error;
  EXPECT_EQ(model->ntex, 1);
  EXPECT_EQ(model->tex_width[0], 2);
  int with_image = 0;
  for (int g = 0; g < model->ngeom; ++g) {
    const int material = model->geom_matid[g];
    const bool image = material >= 0 && model->mat_texid[material] == 0;
    with_image += image;
    if (image) {
      EXPECT_GE(model->mesh_texcoordadr[model->geom_dataid[g]], 0);
    }
  }
  EXPECT_EQ(with_image, 1);
  mj_deleteModel(model);
#endif
}

TEST_F(Looks, NameWhatTheyLeaveOut) {
  write("normal.png", testing::four_colours_png());
  write("block.mtl", std::string(kMaterials) + "norm normal.png\n");
  Object object = m_scene.at(m_scene.ids()[0]);
  object.name = "other";
  object.model = std::make_shared<const Model>(read_model(m_folder.file("block.obj")));
  object.pose.translation = Vec3(3, 0, 1e-6);
  m_scene.add(std::move(object));
  const SimulationExport done = export_simulation(m_scene, m_folder.file("n.usda"));
  EXPECT_TRUE(std::any_of(done.notes.begin(), done.notes.end(), [](const Sentence& note) {
    return has(in_english(note), "its images of normals are left out");
  }));
}

}  // namespace
}  // namespace trivet
