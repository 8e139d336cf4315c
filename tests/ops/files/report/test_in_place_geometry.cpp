// Geometry of objects of scenes in place: below mirrors, quantised, instanced.
#include <gtest/gtest.h>

#include <fstream>

#include "core/base/error.h"
#include "core/mesh/adjacency.h"
#include "core/mesh/mass.h"
#include "ops/files/inplace/scene_objects.h"
#include "support/gltf_maker.h"
#include "support/temporary_folder.h"

namespace trivet {
namespace {

using test::Gltf;
using test::GltfMaker;

class InPlaceGeometry : public ::testing::Test {
 protected:
  std::unique_ptr<GltfScene> scene_of(const GltfMaker& maker, SceneRule rule) const {
    const std::string path = m_folder.file("scene.glb");
    std::ofstream(path, std::ios::binary) << maker.glb();
    return std::make_unique<GltfScene>(path, rule, ImportLimits());
  }
  static Model model_of(const GltfScene& scene, size_t object) {
    return scene.models()(scene.model_name(object), {});
  }

 private:
  test::TemporaryFolder m_folder;
};

// A cube with one corner higher: 1.25 cubic units, of which no mirror image is a turned one.
GltfMaker lifted_cube() {
  GltfMaker maker;
  std::vector<float> corners = GltfMaker::cube_corners();
  corners[3 * 7 + 2] = 2;
  const size_t positions = maker.add_accessor(GltfMaker::bytes_of(corners), 5126, 8, "VEC3");
  maker.add_mesh(positions, maker.add_cube_indices());
  return maker;
}

double volume_of_object(const Model& model) {
  const MassProperties mass = mass_properties(model.mesh, make_adjacency(model.mesh));
  EXPECT_EQ(mass.rule, MassRule::Volume);
  return mass.volume;
}

double signed_volume(const Mesh& mesh) {
  double sum = 0;
  for (Index f = 0; f < static_cast<Index>(mesh.triangles.size()); ++f) {
    const Triangle t = mesh.triangle(f);
    sum += t[0].dot(t[1].cross(t[2])) / 6;
  }
  return sum;
}

TEST_F(InPlaceGeometry, KeepsInsideBelowMirrors) {
  const Gltf mirrors[] = {{{"scale", {-1, 1, 1}}},
                          {{"scale", {2, 1, -0.5}}},
                          {{"matrix", {0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}}}};
  for (const Gltf& mirror : mirrors)
    for (const SceneRule rule : {SceneRule::Roots, SceneRule::Meshes}) {
      GltfMaker maker = lifted_cube();
      Gltf parent = mirror, alone = mirror;
      parent["children"] = {1};
      alone["mesh"] = 0;
      maker.show_nodes(Gltf::array({parent,
                                    {{"mesh", 0}, {"translation", {3, 0, 0}}},
                                    alone,
                                    {{"mesh", 0}, {"translation", {0, 0, 9}}}}));
      const auto scene = scene_of(maker, rule);
      ASSERT_EQ(scene->objects().size(), 3u);
      for (size_t i = 0; i < 3; ++i) {
        const Model model = model_of(*scene, i);
        EXPECT_NEAR(signed_volume(model.mesh), 1.25, 1e-6) << mirror << " object " << i;
        EXPECT_NEAR(signed_volume(model.mesh), volume_of_object(model), 1e-12);
      }
    }
}

// Integers of a node's scale: the object is as large as a program shows it.
TEST_F(InPlaceGeometry, ReadsQuantisedObjects) {
  GltfMaker maker;
  std::vector<std::uint16_t> corners;
  for (int i = 0; i < 8; ++i) {
    for (int axis = 0; axis < 3; ++axis) corners.push_back((i >> axis & 1) ? 65535 : 0);
    corners.push_back(0);  // to a multiple of 4 bytes
  }
  const size_t view = maker.add_view(GltfMaker::bytes_of(corners), {{"byteStride", 8}});
  const size_t positions = maker.add("accessors", {{"bufferView", view},
                                                   {"componentType", 5123},
                                                   {"normalized", true},
                                                   {"count", 8},
                                                   {"type", "VEC3"}});
  maker.add_mesh(positions, maker.add_cube_indices());
  maker.json["extensionsRequired"] = {"KHR_mesh_quantization"};
  maker.show_nodes(Gltf::array({{{"mesh", 0}, {"scale", {2, 2, 2}}}, {{"mesh", 0}}}));
  const auto scene = scene_of(maker, SceneRule::Roots);
  ASSERT_EQ(scene->objects().size(), 2u);
  EXPECT_NEAR(volume_of_object(model_of(*scene, 0)), 8, 1e-12);
  EXPECT_NEAR(volume_of_object(model_of(*scene, 1)), 1, 1e-12);
}

TEST_F(InPlaceGeometry, TakesInstancesAsPartsOfTheirNode) {
  GltfMaker maker;
  maker.add_cube();
  const size_t places = maker.add_accessor(
      GltfMaker::bytes_of(std::vector<float>{0, 0, 0, 3, 0, 0}), 5126, 2, "VEC3");
  maker.json["extensionsRequired"] = {"EXT_mesh_gpu_instancing"};
  maker.show_nodes(Gltf::array(
      {{{"mesh", 0},
        {"extensions", {{"EXT_mesh_gpu_instancing", {{"attributes", {{"TRANSLATION", places}}}}}}}},
       {{"mesh", 0}, {"translation", {0, 5, 0}}}}));
  for (const SceneRule rule : {SceneRule::Roots, SceneRule::Meshes}) {
    const auto scene = scene_of(maker, rule);
    ASSERT_EQ(scene->objects().size(), 2u);
    EXPECT_NEAR(volume_of_object(model_of(*scene, 0)), 2, 1e-12);
    EXPECT_NEAR(volume_of_object(model_of(*scene, 1)), 1, 1e-12);
  }
}

TEST_F(InPlaceGeometry, RefusesWhatIsRequiredAndUnknown) {
  GltfMaker maker;
  maker.add_cube();
  maker.json["extensionsRequired"] = {"ACME_folded"};
  maker.show_nodes(Gltf::array({{{"mesh", 0}}}));
  try {
    scene_of(maker, SceneRule::Roots);
    FAIL() << "no Error was thrown";
  } catch (const Error& e) {
    EXPECT_NE(std::string(e.what()).find("requires ACME_folded"), std::string::npos) << e.what();
  }
}

}  // namespace
}  // namespace trivet
