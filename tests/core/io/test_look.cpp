// Appearance preserved along with the geometry: hierarchy, materials, textures, cameras, lights.
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/io/export.h"
#include "core/io/gltf/document.h"
#include "core/io/io_testing.h"
#include "core/io/look.h"
#include "core/model/exported_floats.h"

namespace trivet {
namespace {

using testing::expect_parts;

class LookTest : public testing::IoTest {};

// The shortest PNG header and a JPEG-like prefix: damaged, which no look minds.
const std::string kPng = std::string("\x89PNG\r\n\x1a\n", 8) + "pixels of the one";
const std::string kJpeg = std::string("\xff\xd8\xff\xe0", 4) + "pixels of the other";

std::string joined(const std::vector<Sentence>& notes) {
  std::string out;
  for (const Sentence& note : notes) out += in_english(note) + "\n";
  return out;
}

/// Resolves all references by index in place: equal for equal content, independent of its location
/// in the file. Follows the specification, not the code under test.
class Resolver {
 public:
  explicit Resolver(const GltfDocument& document) : m_document(document) {}

  GltfJson node(size_t id) const {
    GltfJson out = m_document.json.at("nodes").at(id);
    if (out.contains("children"))
      for (GltfJson& child : out["children"]) child = node(child.get<size_t>());
    if (out.contains("mesh")) out["mesh"] = mesh(out["mesh"].get<size_t>());
    if (out.contains("camera"))
      out["camera"] = m_document.json["cameras"].at(out["camera"].get<size_t>());
    if (out.contains("extensions") && out["extensions"].contains("KHR_lights_punctual")) {
      GltfJson& light = out["extensions"]["KHR_lights_punctual"]["light"];
      light =
          m_document.json["extensions"]["KHR_lights_punctual"]["lights"].at(light.get<size_t>());
    }
    return out;
  }

  GltfJson mesh(size_t id) const {
    GltfJson out = m_document.json.at("meshes").at(id);
    for (GltfJson& primitive : out["primitives"]) {
      for (auto& [name, accessor] : primitive["attributes"].items()) accessor = values(accessor);
      if (primitive.contains("indices")) primitive["indices"] = values(primitive["indices"]);
      if (primitive.contains("material"))
        primitive["material"] =
            textured(m_document.json["materials"].at(primitive["material"].get<size_t>()));
    }
    return out;
  }

 private:
  GltfJson values(const GltfJson& id) const {
    GltfJson out = m_document.json.at("accessors").at(id.get<size_t>());
    const GltfJson& view = m_document.json["bufferViews"].at(out["bufferView"].get<size_t>());
    const size_t begin = view["byteOffset"].get<size_t>();
    std::string hex;
    for (size_t i = begin; i < begin + view["byteLength"].get<size_t>(); ++i)
      hex += std::to_string(static_cast<unsigned char>(m_document.binary.at(i))) + " ";
    out["bufferView"] = hex;
    return out;
  }

  GltfJson textured(GltfJson material) const {
    for (auto& [key, value] : material.items()) {
      if (!value.is_object()) continue;
      value = textured(value);
      if (key.ends_with("Texture")) value["index"] = texture(value["index"].get<size_t>());
    }
    return material;
  }

  GltfJson texture(size_t id) const {
    GltfJson out = m_document.json["textures"].at(id);
    if (out.contains("sampler"))
      out["sampler"] = m_document.json["samplers"].at(out["sampler"].get<size_t>());
    const size_t image = out["source"].get<size_t>();
    out["source"] = {{"image", m_document.json["images"].at(image)},
                     {"bytes", *m_document.images.at(image)}};
    return out;
  }

  const GltfDocument& m_document;
};

GltfJson lamp_json() {
  const std::string nodes = R"([
    {"name":"lamp","mesh":0,"children":[1,3],"extras":{"maker":["ACME",null,0.1]}},
    {"name":"arm","translation":[0,0.36,0],"rotation":[0,0,0.3826834323650898,0.9238795325112867],"children":[2]},
    {"name":"shade","mesh":0,"scale":[1.5,1,1.5],"extensions":{"KHR_lights_punctual":{"light":0}}},
    {"name":"eye","camera":0,"matrix":[1,0,0,0,0,1,0,0,0,0,1,0,0.5,0.5,1,1]}])";
  GltfJson json = GltfJson::parse(testing::tetrahedron_gltf(nodes, "[0]"));
  const size_t position =
      json["meshes"][0]["primitives"][0]["attributes"]["POSITION"].get<size_t>();
  json["extensionsUsed"] = {"KHR_lights_punctual", "KHR_materials_clearcoat", "ACME_secret"};
  json["extensions"]["KHR_lights_punctual"]["lights"] = GltfJson::array(
      {{{"type", "point"}, {"name", "bulb"}, {"color", {1, 0.9, 0.7}}, {"intensity", 12.5}}});
  json["images"] = GltfJson::array({{{"uri", "a%20b.png"}}, {{"uri", "c.jpg"}, {"name", "see"}}});
  json["samplers"] = GltfJson::array({{{"magFilter", 9728}, {"wrapS", 33071}}});
  json["textures"] = GltfJson::array({{{"source", 0}, {"sampler", 0}}, {{"source", 1}}});
  json["materials"] = GltfJson::array(
      {{{"name", "unused"}},
       {{"name", "lacquer"},
        {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 1}}}, {"metallicFactor", 0.1}}},
        {"extensions",
         {{"KHR_materials_clearcoat", {{"clearcoatTexture", {{"index", 0}, {"texCoord", 1}}}}},
          {"ACME_secret", {{"accessor", 3}}}}},
        {"extras", {{"paint", {1, 2.5, "x"}}}}}});
  json["cameras"] = GltfJson::array(
      {{{"type", "perspective"}, {"perspective", {{"yfov", 0.7}, {"znear", 0.01}}}}});
  GltfJson& primitive = json["meshes"][0]["primitives"][0];
  primitive["material"] = 1;
  primitive["attributes"]["COLOR_0"] = position;  // as good as any
  return json;
}

std::string write_lamp(const std::filesystem::path& folder) {
  std::ofstream(folder / "a b.png", std::ios::binary) << kPng;
  std::ofstream(folder / "c.jpg", std::ios::binary) << kJpeg;
  const std::string path = (folder / "lamp.gltf").string();
  std::ofstream(path) << lamp_json().dump();
  return path;
}

ExportScene two_of(const Model& model) {
  const auto shared = std::make_shared<const Model>(model);
  Pose pose;
  pose.rotation = Rotation::about_axis(Vec3(1, 2, 3).normalized(), 0.4);
  pose.translation = Vec3(0.3, -7.7, 1.1);
  return {
      {{"first", shared, world_from_object(pose, UpAxis::Y, 0.01), ""}, {"second", shared, {}, ""}},
      ""};
}

// Expected lamp: without unknown extensions, images with their type.
GltfJson expected_lamp(const std::string& path) {
  GltfDocument source = read_gltf_document(path, {});
  for (GltfJson& material : source.json["materials"])
    if (material.contains("extensions")) material["extensions"].erase("ACME_secret");
  source.json["images"][0]["mimeType"] = "image/png";
  source.json["images"][1]["mimeType"] = "image/jpeg";
  return Resolver(source).node(0);
}

TEST_F(LookTest, KeepsGltfUnchanged) {
  const std::string lamp = write_lamp(folder());
  const Model model = read_model(lamp);
  ASSERT_TRUE(model.appearance);
  expect_parts(in_english(model.notes.empty() ? Sentence() : model.notes.front()),
               {"left out", "ACME_secret"});
  const GltfJson expected = expected_lamp(lamp);
  for (const char* name : {"s.glb", "s.gltf"}) {
    write_scene(two_of(model), path(name));
    const GltfDocument written = read_gltf_document(path(name), {});
    EXPECT_EQ(written.json["meshes"].size(), 1u) << name;  // independent of the number of uses
    EXPECT_EQ(written.json["images"].size(), 2u) << name;
    EXPECT_EQ(written.json["materials"].size(), 1u) << name;  // the unused one is omitted
    ASSERT_EQ(scene_roots(written.json).size(), 2u);
    for (const int root : scene_roots(written.json)) {
      const GltfJson& object = written.json["nodes"][root];
      ASSERT_EQ(object["children"].size(), 1u);
      const GltfJson found = Resolver(written).node(object["children"][0].get<size_t>());
      EXPECT_EQ(found, expected) << name;
    }
  }
  EXPECT_EQ(testing::read_bytes(path("s_see.jpg")), kJpeg);
  EXPECT_EQ(testing::read_bytes(path("s_a_b.png")), kPng);
}

// Re-read, the model below an object's node equals the original model bit for bit.
TEST_F(LookTest, RoundTripsModelsToSameBits) {
  const Model model = read_model(write_lamp(folder()));
  write_scene(two_of(model), path("s.glb"));
  GltfDocument written = read_gltf_document(path("s.glb"), {});
  const int object = scene_roots(written.json).front();
  std::ofstream(path("again.gltf")) << [&] {
    GltfJson json = written.json;
    json["scenes"][0]["nodes"] = json["nodes"][object]["children"];
    json.erase("images"), json.erase("textures");
    json["materials"] = GltfJson::array({GltfJson::object()});
    json["buffers"] =
        GltfJson::array({{{"uri", "again.bin"}, {"byteLength", written.binary.size()}}});
    return json.dump();
  }();
  write("again.bin", written.binary);
  const Model again = read_model(path("again.gltf"));
  EXPECT_TRUE(testing::same_triangles(testing::triangles_of(again.mesh),
                                      testing::triangles_of(model.mesh)));
}

// Images beside the target belong to another scene and must not be overwritten.
TEST_F(LookTest, DoesNotOverwriteImagesOfOthers) {
  const Model model = read_model(write_lamp(folder()));
  std::filesystem::create_directory(path("out"));
  write("out/again_c.jpg", "somebody's");
  write("out/again_see.jpg", "somebody's");
  testing::expect_parts(
      testing::error_of([&] { write_scene(two_of(model), path("out/again.gltf")); }),
      {"out/again_", ".jpg", "accepted: another name"});
  size_t num_files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(path("out"))) {
    EXPECT_EQ(testing::read_bytes(entry.path().string()), "somebody's");
    ++num_files;
  }
  EXPECT_EQ(num_files, 2u);
}

TEST_F(LookTest, WritesExportedPositions) {
  const Model model = read_model(write_lamp(folder()));
  const ExportScene scene = two_of(model);
  write_scene(scene, path("s.glb"));
  const auto read = testing::reference_scene(path("s.glb"));
  ASSERT_EQ(read.size(), 2u);
  for (size_t i = 0; i < 2; ++i) {
    const auto positions = exported_positions(scene.objects[i]);
    ASSERT_EQ(read[i].triangles.size(), model.mesh.triangles.size());
    for (size_t f = 0; f < read[i].triangles.size(); ++f)
      for (int k = 0; k < 3; ++k) {
        const Vec3 expected = positions[model.mesh.triangles[f][k]].cast<double>();
        EXPECT_LE((read[i].triangles[f][k] - expected).cwiseAbs().maxCoeff(),
                  std::abs(expected.maxCoeff()) * 0x1p-23);
      }
  }
}

// Far from its origin, a pivot keeps the object's matrix small.
TEST_F(LookTest, TurnsFarModelsAboutPivot) {
  GltfJson json = lamp_json();
  json["nodes"][0]["translation"] = {1000, 20, -500};
  write_lamp(folder());
  const Model model = read_model(write("far.gltf", json.dump()));
  ASSERT_TRUE(model.appearance);
  const ExportScene scene = two_of(model);
  write_scene(scene, path("s.glb"));
  const GltfDocument written = read_gltf_document(path("s.glb"), {});
  const GltfJson& object = written.json["nodes"][scene_roots(written.json).front()];
  EXPECT_EQ(name_of(written.json["nodes"][object["children"][0].get<size_t>()]), "pivot");
  const auto read = testing::reference_scene(path("s.glb"));
  const auto positions = exported_positions(scene.objects[0]);
  const Affine& world = scene.objects[0].world_from_object;
  for (size_t f = 0; f < read[0].triangles.size(); ++f)
    for (int k = 0; k < 3; ++k) {
      const Index v = model.mesh.triangles[f][k];
      EXPECT_TRUE(read[0].triangles[f][k].isApprox(positions[v].cast<double>(), 1e-7));
      EXPECT_TRUE(read[0].triangles[f][k].isApprox(world.apply(model.mesh.vertices[v]), 2e-7));
    }
}

TEST_F(LookTest, ReadsObjWithTexture) {
  write("wood.png", kPng);
  write("t.mtl",
        "newmtl oak\nKd 0.5 0.5 0.5\nmap_Kd textures\\wood.png\n"
        "newmtl ash\nmap_Kd lost.png\n");
  const Model model = read_model(
      write("t.obj",
            "mtllib t.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvt 0.25 0\nvt 1 0\nvt 0 0.75\n"
            "o top\nusemtl oak\nf 1/1 2/2 3/3\nf 1/1 3/3 2/2\no leg\nusemtl ash\nf 1/1 2/2 4/3\n"));
  ASSERT_TRUE(model.appearance);
  expect_parts(joined(model.notes), {"left out", "lost.png", "not drawn", "wood"});
  write_scene(two_of(model), path("s.glb"));
  const GltfDocument written = read_gltf_document(path("s.glb"), {});
  ASSERT_EQ(written.images.size(), 1u);
  EXPECT_EQ(*written.images[0], kPng);
  EXPECT_EQ(written.json["images"][0]["mimeType"], "image/png");
  ASSERT_EQ(written.json["meshes"].size(), 2u);
  const GltfJson& primitive = written.json["meshes"][0]["primitives"][0];
  const GltfJson& accessor =
      written.json["accessors"][primitive["attributes"]["TEXCOORD_0"].get<size_t>()];
  const GltfJson& view = written.json["bufferViews"][accessor["bufferView"].get<size_t>()];
  std::vector<float> uv(2 * accessor["count"].get<size_t>());
  std::memcpy(uv.data(), written.binary.data() + view["byteOffset"].get<size_t>(), 4 * uv.size());
  ASSERT_EQ(uv.size(), 12u);  // two sides with normals of their own
  EXPECT_EQ(uv[0], 0.25f);
  EXPECT_EQ(uv[1], 1.0f);  // v runs down in glTF
  EXPECT_EQ(uv[5], 0.25f);
  const auto material = written.json["materials"][primitive["material"].get<size_t>()];
  EXPECT_EQ(material["name"], "oak");
  EXPECT_TRUE(material["pbrMetallicRoughness"].contains("baseColorTexture"));
  std::vector<std::string> names;
  const GltfJson& object = written.json["nodes"][scene_roots(written.json).front()];
  for (const GltfJson& child : object["children"])
    names.push_back(name_of(written.json["nodes"][child.get<size_t>()]));
  EXPECT_EQ(names, (std::vector<std::string>{"top", "leg"}));
}

TEST_F(LookTest, IsNullForPlainModels) {
  EXPECT_FALSE(read_model(write("t.obj", testing::tetrahedron_obj())).appearance);
  EXPECT_FALSE(read_model(write("t.ply", testing::tetrahedron_ply())).appearance);
  EXPECT_FALSE(read_model(write("t.stl", testing::tetrahedron_stl())).appearance);
}

TEST_F(LookTest, ReadsVertexColoursOfPly) {
  const Model model = read_model(
      write("t.ply",
            "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
            "property float z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
            "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
            "0 0 0 255 0 0\n1 0 0 0 255 0\n0 1 0 0 0 188\n3 0 1 2\n"));
  ASSERT_TRUE(model.appearance);
  write_scene(two_of(model), path("s.glb"));
  const GltfDocument written = read_gltf_document(path("s.glb"), {});
  const GltfJson& attributes = written.json["meshes"][0]["primitives"][0]["attributes"];
  const GltfJson& accessor = written.json["accessors"].at(attributes.at("COLOR_0").get<size_t>());
  const GltfJson& view = written.json["bufferViews"][accessor["bufferView"].get<size_t>()];
  float colours[12];
  std::memcpy(colours, written.binary.data() + view["byteOffset"].get<size_t>(), sizeof colours);
  EXPECT_EQ(colours[0], 1);
  EXPECT_EQ(colours[1], 0);
  EXPECT_EQ(colours[5], 1);
  EXPECT_NEAR(colours[10], 0.5, 0.005);  // sRGB 188
  EXPECT_EQ(colours[11], 1);
}

// A broken look keeps the geometry, and no data is invented.
TEST_F(LookTest, LeavesOutBrokenLooks) {
  write_lamp(folder());
  const auto note_of = [&](const GltfJson& json) {
    const Model model = read_model(write("broken.gltf", json.dump()));
    EXPECT_FALSE(model.appearance);
    EXPECT_EQ(model.mesh.triangles.size(), 8u);
    return in_english(model.notes.empty() ? Sentence() : model.notes.back());
  };
  GltfJson json = lamp_json();  // in an extension that the importer does not know
  json["materials"][1]["extensions"]["KHR_materials_iridescence"]["iridescenceTexture"]["index"] =
      9;
  expect_parts(note_of(json), {"left out", "element 9 of \"textures\", which has 2"});
}

TEST_F(LookTest, NotesMissingImages) {
  const std::string lamp = write_lamp(folder());
  std::filesystem::remove(folder() / "c.jpg");
  const Model model = read_model(lamp);
  ASSERT_TRUE(model.appearance);
  expect_parts(joined(model.notes), {"left out: the image \"see\", missing"});
  write_scene(two_of(model), path("s.glb"));
  EXPECT_EQ(read_gltf_document(path("s.glb"), {}).images.size(), 1u);
}

// Scenes embed only images, whatever file a model names.
TEST_F(LookTest, EmbedsOnlyImages) {
  GltfJson json = lamp_json();
  json["images"][0]["uri"] = "secret.txt";
  json["images"][1]["uri"] = "/etc/passwd";
  write("secret.txt", "a secret");
  const Model model = read_model(write("spy.gltf", json.dump()));
  ASSERT_TRUE(model.appearance);
  EXPECT_EQ(count(*model.appearance).images, 0u);
}

TEST_F(LookTest, CountsForDisplay) {
  const AppearanceCounts counts = count(*read_model(write_lamp(folder())).appearance);
  EXPECT_EQ(counts.nodes, 4u);
  EXPECT_EQ(counts.meshes, 1u);
  EXPECT_EQ(counts.textures, 2u);
  EXPECT_EQ(counts.image_bytes, kPng.size() + kJpeg.size());
  EXPECT_EQ(counts.cameras, 1u);
  EXPECT_EQ(counts.lights, 1u);
}

}  // namespace
}  // namespace trivet
