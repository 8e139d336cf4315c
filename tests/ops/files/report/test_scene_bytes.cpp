// Scenes of models that came from arrays, as bytes and as files: back whole, bit for bit.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "core/base/error.h"
#include "core/io/mesh_model.h"
#include "core/mesh/weld_arrays.h"
#include "core/scene/fingerprint.h"
#include "ops/check/check.h"
#include "ops/files/report/scene_file.h"
#include "ops/operations/perform.h"
#include "support/settle_options.h"
#include "support/solids.h"

namespace trivet {
namespace {

namespace fs = std::filesystem;

// No vertex but those on the axes is a float32.
std::shared_ptr<const Model> model_of(const std::vector<Triangle>& triangles) {
  std::vector<Vec3> vertices;
  std::vector<Index3> ids;
  for (const Triangle& t : triangles) {
    const auto first = static_cast<Index>(vertices.size());
    ids.push_back({first, first + 1, first + 2});
    for (const Vec3& p : t) vertices.push_back(p / 3);
  }
  Model model = model_of_mesh(weld(vertices, ids).mesh);
  model.materials.push_back({"red", {0.9f, 0.1f, 1.0f / 3, 1}, 0.25f, 0.1f});
  for (size_t f = 0; f < model.face_material.size(); f += 2) model.face_material[f] = 1;
  return std::make_shared<const Model>(std::move(model));
}

Object object_from(const std::string& name, std::shared_ptr<const Model> model) {
  Object object;
  object.name = name;
  object.shape = make_shape(model->mesh);
  object.model = std::move(model);
  return object;
}

/// Two boxes that share a model, one upon the other, and a torus out of the scene.
Scene scene_from_arrays() {
  Scene scene;
  const auto box = model_of(test::box_triangles(Vec3(0.3, 0.2, 0.1)));
  const ObjectId a = scene.add(object_from("a", box)), b = scene.add(object_from("b", box));
  scene.add(object_from("out", model_of(test::torus(0.3, 0.1, 12, 8))));
  const Rotation turned = Rotation::about_axis(Vec3::UnitZ(), 0.3);
  EXPECT_TRUE(put(scene, a, {turned, Vec3(0.1, 0.2, 1)}).ok());
  EXPECT_TRUE(put(scene, b, {Rotation(), Vec3(0.13, 0.21, 1)}).ok());
  update_contacts(scene);
  return scene;
}

void expect_same(const Scene& back, const Scene& scene) {
  EXPECT_EQ(fingerprint(back), fingerprint(scene));
  ASSERT_EQ(back.ids().size(), scene.ids().size());
  for (const ObjectId id : scene.ids()) {
    const Object &is = back.at(*back.find(scene.at(id).name)), &was = scene.at(id);
    EXPECT_EQ(is.shape->mesh.vertices, was.shape->mesh.vertices) << was.name;
    EXPECT_EQ(is.shape->mesh.triangles, was.shape->mesh.triangles) << was.name;
    EXPECT_TRUE(is.model->path.empty());
    for (size_t f = 0; f < was.model->face_material.size(); ++f) {
      const Material &of = is.model->materials[is.model->face_material[f]],
                     &wanted = was.model->materials[was.model->face_material[f]];
      EXPECT_EQ(of.base_colour, wanted.base_colour) << was.name << " " << f;
      EXPECT_EQ(of.metallic, wanted.metallic);
      EXPECT_EQ(of.roughness, wanted.roughness);
    }
  }
}

Scene read_back(const std::string& bytes) {
  SceneFile back = read_scene_bytes(bytes);
  EXPECT_TRUE(back.notes.empty());
  update_contacts(back.scene, back.clearance);
  return std::move(back.scene);
}

TEST(SceneBytes, OfArraysComeBackWhole) {
  const Scene scene = scene_from_arrays();
  const std::string bytes = scene_file_bytes(scene, {}, {"1.0", "", 0});
  const Scene back = read_back(bytes);
  expect_same(back, scene);
  EXPECT_EQ(back.at(*back.find("a")).model, back.at(*back.find("b")).model);
  EXPECT_EQ(scene_file_bytes(back, {}, {"1.0", "", 0}), bytes);
}

TEST(SceneBytes, AreThoseOfTheFile) {
  const Scene scene = scene_from_arrays();
  const std::string path =
      (fs::path(testing::TempDir()) / ("bytes_" + std::to_string(getpid()) + ".glb")).string();
  write_scene_file(scene, {}, {"1.0", "models", 0}, path);
  std::ifstream in(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  EXPECT_EQ(scene_file_bytes(scene, {}, {"1.0", "models", 0}), bytes);
  SceneFile back = read_scene_file(path);
  update_contacts(back.scene, back.clearance);
  expect_same(back.scene, scene);
  fs::remove(path);
}

TEST(SceneBytes, OfFloat32MeshesHoldNoSecondCopy) {
  Scene scene;
  Model model = model_of_mesh(weld(test::box_triangles(Vec3(0.5, 0.25, 0.125))));
  const ObjectId id = scene.add(object_from("a", std::make_shared<const Model>(std::move(model))));
  ASSERT_TRUE(put(scene, id, {Rotation(), Vec3(0, 0, 1)}).ok());
  update_contacts(scene);
  const std::string bytes = scene_file_bytes(scene, {}, {});
  EXPECT_EQ(bytes.find("\"mesh\":{\"vertices\""), std::string::npos);
  expect_same(read_back(bytes), scene);
}

// Programs may leave Object::model out.
TEST(SceneBytes, OfObjectsWithoutModelsComeBackWhole) {
  Scene scene;
  const auto shape = make_shape(weld(test::box_triangles(Vec3(0.3, 0.2, 1.0 / 3))));
  for (const char* name : {"a", "b"}) {
    Object object;
    object.name = name;
    object.shape = shape;
    scene.add(std::move(object));
  }
  ASSERT_TRUE(stand(scene, *scene.find("a"), {{}, Vec3(0, 0, 0.34)}).ok());
  ASSERT_TRUE(put(scene, *scene.find("b"), {{}, Vec3(0, 0, 2)}, test::objects_alone()).ok());
  update_contacts(scene);
  EXPECT_TRUE(check_scene(scene).not_at_rest.size() == 1);  // "a" stands above the floor
  const Scene back = read_back(scene_file_bytes(scene, {}, {}));
  EXPECT_EQ(fingerprint(back), fingerprint(scene));
  EXPECT_EQ(back.at(*back.find("a")).shape->mesh.vertices, shape->mesh.vertices);
  EXPECT_EQ(back.at(*back.find("a")).model, back.at(*back.find("b")).model);
}

std::string complaint(const std::string& bytes) {
  try {
    read_scene_bytes(bytes);
  } catch (const Error& e) {
    EXPECT_EQ(e.kind(), Error::Kind::BadInput) << e.what();
    return e.what();
  }
  return "";
}

TEST(SceneBytes, ThatAreBrokenAreRefused) {
  const std::string bytes = scene_file_bytes(scene_from_arrays(), {}, {});
  for (const std::string& broken :
       {std::string(), std::string("nonsense"), bytes.substr(0, bytes.size() / 2)}) {
    const std::string what = complaint(broken);
    EXPECT_EQ(what.rfind("scene", 0), 0u) << what;
    EXPECT_EQ(what.find("trivet_"), std::string::npos) << what;
  }
}

// The file with something else in place of the first text that begins like this.
std::string changed(std::string bytes, const std::string& key, const std::string& value) {
  const size_t at = bytes.find("\"" + key + "\":\"") + key.size() + 4;
  const size_t end = bytes.find('"', at);
  EXPECT_LE(value.size(), end - at);
  bytes.replace(at, value.size(), value);
  return bytes;
}

TEST(SceneBytes, WithOtherMeshesAreRefused) {
  const std::string bytes = scene_file_bytes(scene_from_arrays(), {}, {});
  const size_t mesh = bytes.find("\"mesh\":{\"vertices\"");
  ASSERT_NE(mesh, std::string::npos);
  // A vertex that is not finite, one that is another, and an id out of range.
  for (const auto& [key, value] :
       {std::pair("vertices", "AAAAAAAA+H8A"), std::pair("vertices", "AAAAAAAAAAAA"),
        std::pair("triangles", "////////")}) {
    const std::string part = changed(bytes.substr(mesh), key, value);
    const std::string what = complaint(bytes.substr(0, mesh) + part);
    EXPECT_NE(what.find("/models/0/mesh"), std::string::npos) << what;
  }
}

}  // namespace
}  // namespace trivet
