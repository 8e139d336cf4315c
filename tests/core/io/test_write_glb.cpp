// Scenes as binary glTF, read back bit for bit by other readers.
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/io/export.h"
#include "core/io/io_testing.h"
#include "core/io/read_model.h"
#include "core/model/exported_floats.h"

namespace trivet {
namespace {

using nlohmann::json;
using testing::error_of;
using testing::expect_parts;
using testing::sorted;

class WriteGlb : public testing::IoTest {};

std::shared_ptr<const Model> shared(Model model) {
  return std::make_shared<const Model>(std::move(model));
}

Affine placed(const Vec3& axis, double s, const Vec3& translation, double scale = 1) {
  Pose pose;
  pose.rotation = Rotation::about_axis(axis.normalized(), s);
  pose.translation = translation;
  return world_from_object(pose, UpAxis::Y, scale);
}

std::vector<Triangle> exported_triangles(const ExportObject& object) {
  const std::vector<Eigen::Vector3f> positions = exported_positions(object);
  std::vector<Triangle> out;
  for (const Index3& t : object.model->mesh.triangles)
    out.push_back({positions[t[0]].cast<double>(), positions[t[1]].cast<double>(),
                   positions[t[2]].cast<double>()});
  return out;
}

Aabb box_of(const std::vector<Triangle>& triangles) {
  Aabb out;
  for (const Triangle& t : triangles)
    for (const Vec3& p : t) out.extend(p);
  return out;
}

// Bit for bit, but where a reader adds an object's place.
void expect_exported(const ExportScene& scene, const std::vector<testing::NamedTriangles>& read) {
  ASSERT_EQ(read.size(), scene.objects.size());
  for (const ExportObject& object : scene.objects) {
    const auto found = std::find_if(read.begin(), read.end(),
                                    [&](const auto& r) { return r.name == object.name; });
    ASSERT_NE(found, read.end()) << object.name;
    const std::vector<Triangle> exported = exported_triangles(object);
    if (ExportedPlacement(object, object.model->mesh.box()).place().isZero(0)) {
      EXPECT_TRUE(testing::same_triangles(sorted(found->triangles), sorted(exported)))
          << object.name;
      continue;
    }
    const Aabb there = box_of(found->triangles), wanted = box_of(exported);
    EXPECT_EQ(found->triangles.size(), exported.size());
    EXPECT_LT((there.lower - wanted.lower).norm() + (there.upper - wanted.upper).norm(),
              1e-6 * (1 + wanted.max_abs_coordinate()))
        << object.name;
  }
}

struct Glb {
  json document;
  std::string binary;
};

// Parses the container by the specification: magic, version, lengths, alignment, padding, no
// trailing bytes.
Glb parsed(const std::string& bytes) {
  const auto number = [&](size_t at) {
    std::uint32_t value = 0;
    EXPECT_LE(at + 4, bytes.size());
    if (at + 4 <= bytes.size()) std::memcpy(&value, bytes.data() + at, 4);
    return value;
  };
  Glb out;
  EXPECT_EQ(bytes.substr(0, 4), "glTF");
  EXPECT_EQ(number(4), 2u);
  EXPECT_EQ(number(8), bytes.size());
  const size_t json_bytes = number(12);
  EXPECT_EQ(bytes.substr(16, 4), "JSON");
  EXPECT_EQ(json_bytes % 4, 0u);
  out.document = json::parse(bytes.substr(20, json_bytes));
  size_t end = 20 + json_bytes;
  if (end < bytes.size()) {
    const size_t binary_bytes = number(end);
    EXPECT_EQ(binary_bytes % 4, 0u);
    EXPECT_EQ(bytes.substr(end + 4, 4), std::string("BIN\0", 4));
    out.binary = bytes.substr(end + 8, binary_bytes);
    end += 8 + binary_bytes;
  }
  EXPECT_EQ(end, bytes.size());
  return out;
}

std::vector<float> floats(const Glb& glb, const json& accessor) {
  const json& view = glb.document["bufferViews"].at(accessor["bufferView"].get<size_t>());
  std::vector<float> out(3 * accessor["count"].get<size_t>());
  EXPECT_EQ(out.size() * 4, view["byteLength"].get<size_t>());
  std::memcpy(out.data(), glb.binary.data() + view["byteOffset"].get<size_t>(), 4 * out.size());
  return out;
}

void check_positions(const Glb& glb, const json& accessor) {
  const std::vector<float> values = floats(glb, accessor);
  for (int axis = 0; axis < 3; ++axis) {
    float lower = INFINITY, upper = -INFINITY;
    for (size_t i = axis; i < values.size(); i += 3)
      lower = std::min(lower, values[i]), upper = std::max(upper, values[i]);
    EXPECT_EQ(accessor["min"].at(axis).get<double>(), lower);
    EXPECT_EQ(accessor["max"].at(axis).get<double>(), upper);
  }
}

void check_primitive(const Glb& glb, const json& primitive) {
  const json& accessors = glb.document["accessors"];
  const json& position = accessors.at(primitive["attributes"]["POSITION"].get<size_t>());
  const json& normal = accessors.at(primitive["attributes"]["NORMAL"].get<size_t>());
  const json& index = accessors.at(primitive["indices"].get<size_t>());
  EXPECT_EQ(position["type"], "VEC3");
  EXPECT_EQ(position["componentType"], 5126);
  EXPECT_EQ(position["count"], normal["count"]);
  check_positions(glb, position);
  const std::vector<float> normals = floats(glb, normal);
  for (size_t i = 0; i < normals.size(); i += 3)
    EXPECT_NEAR(std::hypot(normals[i], normals[i + 1], normals[i + 2]), 1, 1e-5);
  EXPECT_EQ(index["componentType"], 5125);
  EXPECT_EQ(index["count"].get<size_t>() % 3, 0u);
  const json& view = glb.document["bufferViews"].at(index["bufferView"].get<size_t>());
  EXPECT_EQ(view["target"], 34963);
  std::vector<std::uint32_t> ids(index["count"].get<size_t>());
  std::memcpy(ids.data(), glb.binary.data() + view["byteOffset"].get<size_t>(), 4 * ids.size());
  for (const std::uint32_t id : ids) EXPECT_LT(id, position["count"].get<size_t>());
  EXPECT_LT(primitive["material"].get<size_t>(), glb.document["materials"].size());
}

/// Checks the rules of glTF 2.0 that this writer could break.
Glb checked(const std::string& bytes) {
  const Glb glb = parsed(bytes);
  const json& root = glb.document;
  EXPECT_EQ(root["asset"]["version"], "2.0");
  EXPECT_EQ(root["asset"]["generator"], "Trivet");
  for (const auto& [key, value] : root.items()) {
    if (value.is_array()) {
      EXPECT_FALSE(value.empty()) << key;
    }
  }
  size_t end = 0;
  for (const json& view : root.value("bufferViews", json::array())) {
    EXPECT_EQ(view["byteOffset"].get<size_t>() % 4, 0u);
    EXPECT_GE(view["byteOffset"].get<size_t>(), end);
    end = view["byteOffset"].get<size_t>() + view["byteLength"].get<size_t>();
  }
  EXPECT_LE(end, glb.binary.size());
  if (root.contains("buffers")) {
    EXPECT_EQ(root["buffers"].size(), 1u);
    EXPECT_EQ(root["buffers"][0]["byteLength"].get<size_t>(), end);
    EXPECT_LT(glb.binary.size() - end, 4u);
  }
  for (const json& mesh : root.value("meshes", json::array()))
    for (const json& primitive : mesh["primitives"]) check_primitive(glb, primitive);
  for (const json& node : root.value("nodes", json::array())) {
    if (node.contains("mesh")) {
      EXPECT_LT(node["mesh"].get<size_t>(), root["meshes"].size());
    }
    if (node.contains("matrix")) {
      EXPECT_EQ(node["matrix"].size(), 16u);
      for (const json& entry : node["matrix"])
        EXPECT_EQ(entry.get<double>(), static_cast<float>(entry.get<double>()));
    }
  }
  return glb;
}

ExportScene example_scene() {
  Model two = testing::tetrahedron_model();
  two.materials = {{"red", {1, 0, 0, 1}, 0, 0.5f}, {"glass", {0.1f, 0.2f, 0.3f, 0.25f}, 0, 0}};
  two.face_material = {1, 0, 1, 0};
  const auto near = shared(two);
  const auto far = shared(testing::tetrahedron_model(Vec3(1000.1, -2000.7, 300.3)));
  ExportScene scene;
  scene.objects = {
      {"plain", near, Affine(), ""},
      {"cup é", near, placed({1, 2, 3}, 0.7, {0.1, 0.2, 0.3}, 0.37), R"({"b":1,"a":[0.1,"x"]})"},
      {"far", far, placed({-1, 0.2, 0.4}, -1.3, {-7.7, 8.8, 0.001}, 1.7), ""}};
  scene.extras_json = R"({"trivet":{"gap":1.0000000000000002e-7}})";
  return scene;
}

TEST_F(WriteGlb, PassesOwnValidation) {
  write_scene(example_scene(), path("s.glb"));
  const Glb glb = checked(testing::read_bytes(path("s.glb")));
  const json& root = glb.document;
  ASSERT_EQ(root["nodes"].size(), 4u);   // "far" is below a place
  EXPECT_EQ(root["meshes"].size(), 2u);  // shared models are stored once
  EXPECT_EQ(root["nodes"][0]["mesh"], root["nodes"][1]["mesh"]);
  EXPECT_EQ(root["nodes"][1]["name"], "cup é");
  EXPECT_EQ(root["meshes"][0]["primitives"].size(), 2u);  // one per material
  ASSERT_EQ(root["materials"].size(), 3u);
  EXPECT_EQ(root["materials"][1]["alphaMode"], "BLEND");
  EXPECT_EQ(root["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"],
            json::array({1.0, 0.0, 0.0, 1.0}));
}

TEST_F(WriteGlb, GivesExportedPositionsToEveryReader) {
  const ExportScene scene = example_scene();
  write_scene(scene, path("s.glb"));
  const auto read = testing::reference_scene(path("s.glb"));
  expect_exported(scene, read);
}

TEST_F(WriteGlb, WritesSingleNodeScene) {
  ExportScene scene = example_scene();
  scene.objects.erase(scene.objects.begin(), scene.objects.begin() + 2);
  write_scene(scene, path("s.glb"));
  const auto read = testing::reference_scene(path("s.glb"));
  ASSERT_EQ(read.size(), 1u);
  EXPECT_TRUE(testing::same_triangles(sorted(read[0].triangles),
                                      sorted(exported_triangles(scene.objects[0]))));
}

TEST_F(WriteGlb, ExportsCloseToWorld) {
  for (const ExportObject& object : example_scene().objects) {
    const std::vector<Eigen::Vector3f> positions = exported_positions(object);
    ASSERT_EQ(positions.size(), object.model->mesh.vertices.size());
    Aabb world;
    for (const Vec3& v : object.model->mesh.vertices)
      world.extend(object.world_from_object.apply(v));
    for (size_t v = 0; v < positions.size(); ++v) {
      const Vec3 exact = object.world_from_object.apply(object.model->mesh.vertices[v]);
      EXPECT_LT((positions[v].cast<double>() - exact).norm(), 4e-7 * world.max_abs_coordinate());
    }
  }
}

// Far from its origin, a model keeps its shape: the rounding is relative to its size.
TEST_F(WriteGlb, KeepsShapeOfFarModels) {
  ExportObject object{"far", shared(testing::tetrahedron_model(Vec3(1e6, 1e6, 1e6))), {}, ""};
  object.world_from_object.translation = Vec3(-1e6, -1e6, -1e6);
  for (const Eigen::Vector3f& p : exported_positions(object))
    EXPECT_LT((p.cast<double>() - p.cast<double>().array().round().matrix()).norm(), 1e-6);
}

// In a wide scene float32 coordinates would have steps of a millimetre at 10 km.
TEST_F(WriteGlb, PutsFarObjectsBelowPlaces) {
  for (const double x : {0.0, 10.0, 1e3, -1e4, 123456.7}) {
    const ExportObject object{"a", shared(testing::tetrahedron_model()),
                              placed({1, 2, 3}, 0.3, {x, 0.3 * x, 0.7}), ""};
    write_scene({{object}, ""}, path("s.glb"));
    const json document = parsed(testing::read_bytes(path("s.glb"))).document;
    const json& root = document["nodes"][document["scenes"][0]["nodes"][0].get<size_t>()];
    EXPECT_EQ(root["name"], std::abs(x) > 16 ? "place" : "a") << x;
    const ExportedPlacement exported(object, object.model->mesh.box());
    std::vector<Triangle> expected;
    for (const Index3& t : object.model->mesh.triangles) {
      Triangle corners;
      for (int k = 0; k < 3; ++k) {
        const Vec3& vertex = object.model->mesh.vertices[t[k]];
        corners[k] = exported(vertex);
        EXPECT_LT((corners[k] - object.world_from_object.apply(vertex)).norm(), 3e-6) << x;
      }
      expected.push_back(corners);
    }
    const Mesh read = read_model(path("s.glb")).mesh;
    Aabb box, exact;
    for (const Vec3& v : read.vertices) box.extend(Vec3(v.x(), -v.z(), v.y()));
    for (const Triangle& t : expected)
      for (const Vec3& v : t) exact.extend(v);
    EXPECT_LT((box.lower - exact.lower).norm() + (box.upper - exact.upper).norm(), 3e-6) << x;
  }
}

TEST_F(WriteGlb, RoundTripsModels) {
  Model model = testing::tetrahedron_model();
  model.materials[0] = {"brass", {0.5f, 0.25f, 0.125f, 1.0f}, 0.75f, 0.25f};
  write_scene({{{"one", shared(model), placed({0, 0, 1}, 0.1, {1, 2, 3}), ""}}, ""}, path("s.glb"));
  const Model read = read_model(path("s.glb"));
  EXPECT_EQ(read.mesh.triangles.size(), 4u);
  const Material& brass = read.materials[read.face_material[0]];
  EXPECT_EQ(brass.name, "brass");
  EXPECT_EQ(brass.base_colour, model.materials[0].base_colour);
  EXPECT_EQ(brass.metallic, 0.75f);
  EXPECT_EQ(brass.roughness, 0.25f);
}

// A slope of 45 degrees, squeezed: its normal tilts opposite to the positions.
TEST_F(WriteGlb, TransformsNormalsByInverseTranspose) {
  Model model;
  model.mesh = weld({{Vec3(0, 0, 0), Vec3(0, 1, 0), Vec3(-1, 0, 1)}});
  ExportObject object{"slope", shared(model), {}, ""};
  object.world_from_object.linear = Vec3(3, 1, 1).asDiagonal();
  write_scene({{object}, ""}, path("s.glb"));
  const Model read = read_model(path("s.glb"));
  ASSERT_EQ(read.corner_normals.size(), 1u);
  // World: (1/3, 0, 1) before normalisation; y up: (x, z, -y).
  const Eigen::Vector3f expected = Eigen::Vector3f(1, 3, 0).normalized();
  for (const Eigen::Vector3f& n : read.corner_normals[0])
    EXPECT_TRUE(n.isApprox(expected, 1e-6f)) << n.transpose();
}

TEST_F(WriteGlb, KeepsDegenerateTriangles) {
  Model model;
  const Vec3 a(0, 0, 0), b(1, 0, 0), c(0, 1, 0);
  model.mesh = weld({{a, b, c}, {a, a, b}, {b, b, b}, {a, b, c}, {a, b, 0.5 * (a + b)}});
  write_scene({{{"d", shared(model), {}, ""}}, ""}, path("s.glb"));
  checked(testing::read_bytes(path("s.glb")));
  EXPECT_EQ(testing::reference_triangles(path("s.glb")).size(), 5u);
}

TEST_F(WriteGlb, RoundTripsExtras) {
  write_scene(example_scene(), path("s.glb"));
  const SceneExtras extras = read_scene_extras(path("s.glb"));
  EXPECT_EQ(extras.scene_json, R"({"trivet":{"gap":1.0000000000000002e-07}})");
  ASSERT_EQ(extras.node_json.size(), 1u);
  EXPECT_EQ(extras.node_json[0].first, "cup é");
  EXPECT_EQ(extras.node_json[0].second, R"({"b":1,"a":[0.1,"x"]})");  // order kept
}

TEST_F(WriteGlb, WritesEmptyScenesAndMeshes) {
  write_scene({}, path("none.glb"));
  checked(testing::read_bytes(path("none.glb")));
  EXPECT_TRUE(read_scene_extras(path("none.glb")).node_json.empty());
  write_scene({{{"empty", shared(Model()), {}, "{}"}}, ""}, path("empty.glb"));
  const Glb glb = checked(testing::read_bytes(path("empty.glb")));
  EXPECT_FALSE(glb.document["nodes"][0].contains("mesh"));
}

TEST_F(WriteGlb, IsDeterministic) {
  write_scene(example_scene(), path("a.glb"));
  write_scene(example_scene(), path("b.glb"));
  EXPECT_EQ(testing::read_bytes(path("a.glb")), testing::read_bytes(path("b.glb")));
}

TEST_F(WriteGlb, EncodesNamesInAnyEncoding) {
  ExportScene scene = example_scene();
  scene.objects[0].name = "caf\xe9";  // Latin-1
  write_scene(scene, path("s.glb"));
  checked(testing::read_bytes(path("s.glb")));
}

TEST_F(WriteGlb, RefusesInvalidExtrasAndPoses) {
  ExportScene scene = example_scene();
  scene.objects[1].extras_json = "{broken";
  expect_parts(error_of([&] { write_scene(scene, path("s.glb")); }), {"cup é", "not valid JSON"});
  scene = example_scene();
  scene.objects[0].world_from_object.translation.x() = 1e39;
  expect_parts(error_of([&] { write_scene(scene, path("s.glb")); }), {"'plain'", "float32"});
  scene.objects[0].world_from_object.translation.x() = std::nan("");
  expect_parts(error_of([&] { exported_positions(scene.objects[0]); }), {"'plain'", "float32"});
  expect_parts(error_of([&] { write_scene(scene, path("s.fbx")); }),
               {path("s.fbx"), ".fbx", ".glb", ".obj", ".ply", ".stl"});
  EXPECT_TRUE(std::filesystem::is_empty(folder()));
}

// Real models, turned: every bit of every vertex.
TEST_F(WriteGlb, WritesRealModelsBitForBit) {
  const std::string cup = testing::shared_path("data/models/sh3d_s_cup.obj");
  const std::string tea = testing::shared_path("data/models/polyhaven_tea_set_01_1k.gltf");
  if (cup.empty() || tea.empty()) GTEST_SKIP() << "no ../shared/data/models";
  const auto cup_model = shared(read_model(cup)), tea_model = shared(read_model(tea));
  ExportScene scene;
  for (int i = 0; i < 4; ++i) {
    const Vec3 place(0.3 * i, -17.1 * i, 0.7);
    scene.objects.push_back({"cup " + std::to_string(i), cup_model,
                             placed({1, 1.0 * i, 0.3}, 0.1 + 0.3 * i, place, 0.01), ""});
    scene.objects.push_back({"tea " + std::to_string(i), tea_model,
                             placed({0, 0.1, 1.0 + i}, -0.2 + 0.3 * i, place), ""});
  }
  write_scene(scene, path("s.glb"));
  parsed(testing::read_bytes(path("s.glb")));  // the tea set equals its own file
  const auto read = testing::reference_scene(path("s.glb"));
  expect_exported(scene, read);
}

}  // namespace
}  // namespace trivet
