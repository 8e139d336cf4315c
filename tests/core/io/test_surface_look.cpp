// Look of a model as renderers take it: texture coordinates, colours, materials and images, in the
// order of its triangles.
#include <Eigen/Geometry>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/base/image.h"
#include "core/io/base64.h"
#include "core/io/gltf/document.h"
#include "core/io/io_testing.h"
#include "core/io/read_model.h"
#include "core/io/textures/surface_look.h"
#include "core/picture/png.h"
#include "support/textured_square.h"

namespace trivet {
namespace {

using testing::append_numbers;
using testing::expect_parts;
using testing::four_colours_png;
using testing::square_json;

class SurfaceLookTest : public testing::IoTest {
 protected:
  std::string write_json(const GltfJson& json) const { return write("m.gltf", json.dump()); }
};

TEST_F(SurfaceLookTest, ReadsTexturedGltf) {
  write("c.png", four_colours_png());
  const Model model = read_model(write_json(square_json()));
  EXPECT_TRUE(model.notes.empty()) << in_english(model.notes.front());
  const auto look = surface_look(model);
  ASSERT_TRUE(look);
  ASSERT_EQ(look->images.size(), 1u);
  const DecodedImage& finest = look->images[0]->levels.front();
  EXPECT_EQ(finest.rgba, decode_image(four_colours_png()).rgba);
  EXPECT_TRUE(look->images[0]->srgb);
  const std::vector<ImageSummary> images = images_of(model);
  ASSERT_EQ(images.size(), 1u);
  EXPECT_EQ(images[0].name, "c");
  EXPECT_EQ(images[0].kind, "PNG");
  EXPECT_EQ(images[0].width, 2);
  EXPECT_EQ(images[0].bytes, four_colours_png().size());
  EXPECT_EQ(look->face_material, (std::vector<Index>{0, 0}));
  EXPECT_EQ(look->finishes[0].base_colour.image, 0);
  EXPECT_EQ(look->finishes[0].transparency, Transparency::None);
  EXPECT_EQ(look->materials[0].base_colour, (std::array<float, 4>{1, 1, 1, 1}));
  ASSERT_EQ(look->coordinates[0].size(), 2u);
  EXPECT_TRUE(look->coordinates[1].empty());
  for (Index f = 0; f < 2; ++f)
    for (int k = 0; k < 3; ++k) {
      const Vec3 p = model.mesh.triangle(f)[k];
      const Eigen::Vector2f at = look->coordinates[0][size_t(f)][size_t(k)];
      EXPECT_EQ(at.x(), float(p.x()));
      EXPECT_EQ(at.y(), float(1 - p.y()));
    }
}

// The importer turns triangles below a mirror; texture coordinates go along with their corners.
TEST_F(SurfaceLookTest, FollowsCornersOfMirroredNodes) {
  write("c.png", four_colours_png());
  GltfJson json = square_json();
  json["nodes"][0]["scale"] = {-1, 1, 1};
  const Model model = read_model(write_json(json));
  const auto look = surface_look(model);
  ASSERT_TRUE(look);
  ASSERT_EQ(look->coordinates[0].size(), 2u);
  for (Index f = 0; f < 2; ++f) {
    const Triangle t = model.mesh.triangle(f);
    EXPECT_GT((t[1] - t[0]).cross(t[2] - t[0]).z(), 0);
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector2f at = look->coordinates[0][size_t(f)][size_t(k)];
      EXPECT_EQ(at, Eigen::Vector2f(float(-t[k].x()), float(1 - t[k].y())));
    }
  }
}

TEST_F(SurfaceLookTest, ReadsSamplersTransformsAndFactors) {
  write("c.png", four_colours_png());
  GltfJson json = square_json();
  json["samplers"] = GltfJson::array({{{"wrapS", 33071}, {"wrapT", 33648}, {"magFilter", 9728}}});
  json["textures"][0]["sampler"] = 0;
  GltfJson& material = json["materials"][0];
  const float quarter_turn = 1.57079633f;
  material = {{"alphaMode", "MASK"},
              {"alphaCutoff", 0.25},
              {"emissiveFactor", {0.5, 0, 1}},
              {"emissiveTexture", {{"index", 0}}},
              {"normalTexture", {{"index", 0}, {"scale", 0.5}}},
              {"extensions", {{"KHR_materials_emissive_strength", {{"emissiveStrength", 4}}}}}};
  material["pbrMetallicRoughness"] = {
      {"baseColorFactor", {0.25, 0.5, 0.75, 1}},
      {"metallicFactor", 0.5},
      {"roughnessFactor", 0.125},
      {"metallicRoughnessTexture", {{"index", 0}}},
      {"baseColorTexture",
       {{"index", 0},
        {"extensions",
         {{"KHR_texture_transform",
           {{"offset", {0.5, 0.25}}, {"rotation", quarter_turn}, {"scale", {2, 3}}}}}}}}};
  json["extensionsUsed"] = {"KHR_texture_transform", "KHR_materials_emissive_strength"};
  const auto look = surface_look(read_model(write_json(json)));
  ASSERT_TRUE(look);
  const SurfaceFinish& finish = look->finishes[0];
  EXPECT_EQ(finish.transparency, Transparency::Cut);
  EXPECT_EQ(finish.cutoff, 0.25f);
  EXPECT_EQ(finish.emitted, (std::array<float, 3>{2, 0, 4}));
  EXPECT_EQ(finish.normal_scale, 0.5f);
  EXPECT_EQ(look->materials[0].base_colour, (std::array<float, 4>{0.25f, 0.5f, 0.75f, 1}));
  EXPECT_EQ(look->materials[0].metallic, 0.5f);
  EXPECT_EQ(look->materials[0].roughness, 0.125f);
  const TextureUse& use = finish.base_colour;
  EXPECT_EQ(use.wrap_u, TextureWrap::Clamp);
  EXPECT_EQ(use.wrap_v, TextureWrap::Mirror);
  EXPECT_TRUE(use.nearest);
  // A quarter turn against the clock as the image is seen: to the right becomes up.
  const float expected[2][3] = {{0, 3, 0.5f}, {-2, 0, 0.25f}};
  for (size_t r = 0; r < 2; ++r)
    for (size_t c = 0; c < 3; ++c) EXPECT_NEAR(use.transform[r][c], expected[r][c], 1e-6);
  // The same image holds colours for one use, and numbers for another.
  EXPECT_EQ(look->images.size(), 2u);
  EXPECT_NE(finish.normal.image, finish.base_colour.image);
  EXPECT_EQ(finish.emission.image, finish.base_colour.image);
  ASSERT_EQ(look->tangents.size(), 2u);
  for (const Eigen::Vector4f& t : look->tangents)  // not mirrored
    EXPECT_TRUE(t.isApprox(Eigen::Vector4f(1, 0, 0, 1), 1e-6f));
}

TEST_F(SurfaceLookTest, ReadsGlass) {
  GltfJson json = square_json();
  json.erase("textures");
  json.erase("images");
  json["materials"][0] = {
      {"pbrMetallicRoughness", {{"baseColorFactor", {0.5, 1, 1, 1}}, {"metallicFactor", 0}}},
      {"extensions",
       {{"KHR_materials_transmission", {{"transmissionFactor", 0.75}}},
        {"KHR_materials_ior", {{"ior", 1.25}}},
        {"KHR_materials_volume",
         {{"thicknessFactor", 1},
          {"attenuationDistance", 0.5},
          {"attenuationColor", {1, 0.25, 0}}}}}}};
  json["extensionsUsed"] = {"KHR_materials_transmission", "KHR_materials_ior",
                            "KHR_materials_volume"};
  const auto look = surface_look(read_model(write_json(json)));
  ASSERT_TRUE(look);
  const Glass& glass = look->finishes[0].glass;
  EXPECT_EQ(glass.share, 0.75f);
  EXPECT_EQ(glass.index, 1.25f);
  ASSERT_TRUE(glass.absorbed_per_unit);
  EXPECT_EQ((*glass.absorbed_per_unit)[0], 0);
  EXPECT_NEAR((*glass.absorbed_per_unit)[1], -std::log(0.25) / 0.5, 1e-6);
  EXPECT_TRUE(std::isfinite((*glass.absorbed_per_unit)[2])) << "black";
  EXPECT_LT(look->materials[0].base_colour[3], 0.5f) << "see-through without rays, too";
  EXPECT_EQ(look->finishes[0].transparency, Transparency::None) << "not a sheet";
  // Metal lets nothing in; without the extension a material is as before.
  json["materials"][0]["pbrMetallicRoughness"]["metallicFactor"] = 1;
  EXPECT_FALSE(surface_look(read_model(write_json(json))));
}

TEST_F(SurfaceLookTest, TellsWhatIsTransparent) {
  write("c.png", four_colours_png());
  const auto transparency = [&](const std::string& mode, double alpha, bool textured) {
    GltfJson json = square_json();
    json["materials"][0]["alphaMode"] = mode;
    json["materials"][0]["emissiveFactor"] = {1, 1, 1};  // a look in any case
    json["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"] = {1, 1, 1, alpha};
    if (!textured) json["materials"][0]["pbrMetallicRoughness"].erase("baseColorTexture");
    const auto look = surface_look(read_model(write_json(json)));
    return std::pair(look->finishes[0].transparency, look->materials[0].base_colour[3]);
  };
  EXPECT_EQ(transparency("OPAQUE", 0.5, true), std::pair(Transparency::None, 1.0f));
  EXPECT_EQ(transparency("MASK", 1, true).first, Transparency::Cut);
  EXPECT_EQ(transparency("MASK", 1, false).first, Transparency::None);
  EXPECT_EQ(transparency("BLEND", 1, true).first, Transparency::Blend);
  EXPECT_EQ(transparency("BLEND", 0.5, false), std::pair(Transparency::None, 0.5f));
}

// Colours that equal positions show that corners keep their triangles: lists, strips and fans, in
// nested nodes, beside primitives of points.
TEST_F(SurfaceLookTest, FollowsTrianglesOfTheModel) {
  GltfJson json = square_json();
  json.erase("images"), json.erase("textures"), json.erase("materials");
  GltfJson& primitives = json["meshes"][0]["primitives"];
  primitives[0] = {{"attributes", {{"POSITION", 0}, {"COLOR_0", 0}}}, {"indices", 2}};
  GltfJson strip = {{"attributes", {{"POSITION", 0}, {"COLOR_0", 0}}}, {"mode", 5}};
  GltfJson fan = strip, points = strip;
  fan["mode"] = 6, points["mode"] = 0;
  primitives.push_back(points), primitives.push_back(strip), primitives.push_back(fan);
  GltfJson other = {{"primitives", GltfJson::array({fan, primitives[0]})}};
  json["meshes"].push_back(other);
  json["nodes"] =
      GltfJson::parse(R"([{"children":[1,3]},{"mesh":1,"children":[2]},{"mesh":0},{"mesh":1}])");
  const Model model = read_model(write_json(json));
  const auto look = surface_look(model);
  ASSERT_TRUE(look);
  ASSERT_EQ(look->colours.size(), model.mesh.triangles.size());
  ASSERT_EQ(look->colours.size(), 14u);
  for (Index f = 0; f < 14; ++f)
    for (int k = 0; k < 3; ++k)
      EXPECT_TRUE(look->colours[size_t(f)][size_t(k)].head<3>() ==
                  model.mesh.triangle(f)[k].cast<float>())
          << f;
}

TEST_F(SurfaceLookTest, LeavesGeometryAlone) {
  write("c.png", four_colours_png());
  const Model textured = read_model(write_json(square_json()));
  GltfJson plain = square_json();
  plain["meshes"][0]["primitives"][0]["attributes"].erase("TEXCOORD_0");
  plain.erase("images"), plain.erase("textures"), plain.erase("materials");
  plain["meshes"][0]["primitives"][0].erase("material");
  const Model bare = read_model(write_json(plain));
  EXPECT_EQ(textured.mesh.vertices, bare.mesh.vertices);
  EXPECT_EQ(textured.mesh.triangles, bare.mesh.triangles);
  EXPECT_FALSE(surface_look(bare));
}

TEST_F(SurfaceLookTest, ReadsColoursOfAllTypes) {
  GltfJson json = square_json();
  std::string buffer;
  append_numbers<std::uint8_t>(buffer,
                               {255, 51, 0, 255, 0, 0, 0, 0, 255, 255, 255, 51, 0, 255, 0, 255});
  json["buffers"].push_back({{"byteLength", buffer.size()},
                             {"uri", "data:application/octet-stream;base64," + base64(buffer)}});
  json["bufferViews"].push_back({{"buffer", 1}, {"byteOffset", 0}, {"byteLength", 16}});
  json["accessors"].push_back({{"bufferView", 3},
                               {"componentType", 5121},
                               {"normalized", true},
                               {"count", 4},
                               {"type", "VEC4"}});
  json["meshes"][0]["primitives"][0]["attributes"]["COLOR_0"] = 3;
  json.erase("images"), json.erase("textures"), json.erase("materials");
  json["meshes"][0]["primitives"][0].erase("material");
  const auto look = surface_look(read_model(write_json(json)));
  ASSERT_TRUE(look);
  EXPECT_TRUE(look->colours[0][0].isApprox(Eigen::Vector4f(1, 0.2f, 0, 1)));
  EXPECT_TRUE(look->colours[0][2].isApprox(Eigen::Vector4f(1, 1, 1, 0.2f)));
}

TEST_F(SurfaceLookTest, ReadsObjWithItsPicture) {
  write("c.png", four_colours_png());
  write("t.mtl", "newmtl paint\nKd 1 1 1\nmap_Kd c.png\n");
  const Model model = read_model(
      write("t.obj",
            "mtllib t.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
            "usemtl paint\nf 1/1 2/2 3/3\nf 1/1 3/3 4/4\n"));
  const auto look = surface_look(model);
  ASSERT_TRUE(look);
  ASSERT_EQ(look->images.size(), 1u);
  EXPECT_EQ(look->images[0]->levels.front().rgba, decode_image(four_colours_png()).rgba);
  for (Index f = 0; f < 2; ++f)
    for (int k = 0; k < 3; ++k) {
      const Vec3 p = model.mesh.triangle(f)[k];
      EXPECT_EQ(look->coordinates[0][size_t(f)][size_t(k)],
                Eigen::Vector2f(float(p.x()), float(1 - p.y())));
    }
}

TEST_F(SurfaceLookTest, NamesWhatIsNotDrawn) {
  const auto notes_of = [&](const std::string& bytes) {
    write("c.png", bytes);
    const Model model = read_model(write_json(square_json()));
    EXPECT_EQ(model.mesh.triangles.size(), 2u);
    EXPECT_FALSE(surface_look(model));
    return in_english(model.notes.empty() ? Sentence() : model.notes.back());
  };
  expect_parts(notes_of(four_colours_png().substr(0, 60)), {"not drawn", "\"c\"", "damaged PNG"});
  expect_parts(notes_of("no picture"), {"left out", "\"c\"", "neither PNG, JPEG nor WebP"});
  std::filesystem::remove(folder() / "c.png");
  const Model model = read_model(write_json(square_json()));
  expect_parts(in_english(model.notes.front()), {"left out", "missing"});
}

TEST_F(SurfaceLookTest, LooksOnlyIntoTheModelsFolder) {
  const auto outside = folder().parent_path() / "surface_look_outside.png";
  std::ofstream(outside, std::ios::binary) << four_colours_png();
  for (const std::string& name : {std::string("../surface_look_outside.png"), outside.string()}) {
    const Model model = read_model(write_json(square_json(name)));
    EXPECT_FALSE(surface_look(model));
    expect_parts(in_english(model.notes.empty() ? Sentence() : model.notes.front()), {"left out"});
  }
  std::filesystem::create_symlink(outside, folder() / "link.png");
  EXPECT_FALSE(surface_look(read_model(write_json(square_json("link.png")))));
  std::filesystem::remove(outside);
}

TEST_F(SurfaceLookTest, KeepsToItsMemory) {
  Image image{64, 64, {}};
  image.rgba.assign(4 * 64 * 64, 255);
  write("c.png", encode_png(image));
  const Model model = read_model(write_json(square_json()));
  EXPECT_EQ(surface_look(model)->images[0]->levels.front().width, 64);
  const auto small = surface_look(model, 4000);
  EXPECT_EQ(small->images[0]->levels.front().width, 16);
  EXPECT_LE(small->image_bytes(), 4000u);
}

// Coordinates and ids beyond their buffers make no look; the importer refuses most by itself.
TEST_F(SurfaceLookTest, RefusesBrokenAccessors) {
  write("c.png", four_colours_png());
  for (const auto& [key, value] : {std::pair("count", GltfJson(5)),
                                   {"byteOffset", GltfJson(1u << 30)},
                                   {"componentType", GltfJson(7)},
                                   {"type", GltfJson("MAT4")}}) {
    GltfJson json = square_json();
    json["accessors"][1][key] = value;
    try {
      EXPECT_FALSE(surface_look(read_model(write_json(json)))) << key;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), Error::Kind::BadInput);
    }
  }
}

}  // namespace
}  // namespace trivet
