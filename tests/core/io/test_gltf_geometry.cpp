// glTF as Trivet's own reader has it: accessors, modes of primitives, nodes, what is left out.
#include <cmath>

#include "core/io/io_testing.h"
#include "core/io/read_model.h"
#include "core/mesh/adjacency.h"
#include "core/mesh/mass.h"
#include "support/gltf_maker.h"

namespace trivet {
namespace {

using test::Gltf;
using test::GltfMaker;
using testing::expect_parts;

MassProperties mass_of(const Model& model) {
  return mass_properties(model.mesh, make_adjacency(model.mesh));
}

std::string lines_of(const std::vector<Sentence>& notes) {
  std::string out;
  for (const Sentence& note : notes) out += in_english(note) + "\n";
  return out;
}

class GltfGeometry : public testing::IoTest {
 protected:
  Model read(const GltfMaker& maker) const { return read_model(write("m.glb", maker.glb())); }
  std::string refusal(const GltfMaker& maker) const {
    return testing::error_of([&] { read(maker); });
  }
  void expect_cube(const Model& model, double error, const char* what) const {
    const MassProperties mass = mass_of(model);
    EXPECT_EQ(model.mesh.vertices.size(), 8u) << what;
    EXPECT_EQ(mass.rule, MassRule::Volume) << what;
    EXPECT_NEAR(mass.volume, 1, error) << what;
    EXPECT_NEAR(mass.area, 6, error) << what;
    EXPECT_LT(mass.centre.norm(), error) << what;
  }
};

// Corners at 0 and `most` of an integer type, moved and scaled to a cube of 1 by the node.
template <class T>
GltfMaker integer_cube(T least, T most, int component, bool normalized, size_t stride) {
  GltfMaker maker;
  std::vector<T> corners;
  for (int i = 0; i < 8; ++i)
    for (int axis = 0; axis < 3; ++axis) corners.push_back((i >> axis & 1) ? most : least);
  const size_t view =
      maker.add_view(GltfMaker::bytes_of(corners, 3, stride), {{"byteStride", stride}});
  const size_t positions = maker.add("accessors", {{"bufferView", view},
                                                   {"componentType", component},
                                                   {"normalized", normalized},
                                                   {"count", 8},
                                                   {"type", "VEC3"}});
  maker.add_mesh(positions, maker.add_cube_indices());
  const double from = normalized ? (std::is_signed_v<T> ? -1 : 0) : double(least);
  const double to = normalized ? 1 : double(most);
  const double scale = 1 / (to - from), shift = -(from + to) / 2 * scale;
  maker.json["extensionsRequired"] = {"KHR_mesh_quantization"};
  maker.show_nodes(Gltf::array(
      {{{"mesh", 0}, {"scale", {scale, scale, scale}}, {"translation", {shift, shift, shift}}}}));
  return maker;
}

TEST_F(GltfGeometry, ReadsIntegersOfEveryType) {
  for (const bool n : {false, true}) {
    expect_cube(read(integer_cube<std::int8_t>(-127, 127, 5120, n, 4)), 1e-6, "int8");
    expect_cube(read(integer_cube<std::uint8_t>(0, 255, 5121, n, 8)), 1e-6, "uint8");
    expect_cube(read(integer_cube<std::int16_t>(-32767, 32767, 5122, n, 8)), 1e-6, "int16");
    expect_cube(read(integer_cube<std::uint16_t>(0, 65535, 5123, n, 12)), 1e-6, "uint16");
  }
  // The least of a normalised type is -1, too.
  expect_cube(read(integer_cube<std::int8_t>(-128, 127, 5120, true, 4)), 1e-6, "int8 of -128");
  expect_cube(read(integer_cube<std::int16_t>(-32768, 32767, 5122, true, 8)), 1e-6, "int16");
}

TEST_F(GltfGeometry, ExportsIntegersAsFloats) {
  const Model model = read(integer_cube<std::uint16_t>(0, 65535, 5123, true, 8));
  ASSERT_TRUE(model.appearance) << lines_of(model.notes);
  EXPECT_TRUE(model.notes.empty()) << lines_of(model.notes);
}

TEST_F(GltfGeometry, ReadsIndicesOfEveryType) {
  const auto cube_with = [&](auto type, int component) {
    GltfMaker maker;
    std::vector<decltype(type)> ids;
    for (const auto& face : test::kCubeFaces)
      for (const int v : face) ids.push_back(static_cast<decltype(type)>(v));
    const size_t positions = maker.add_cube_positions();
    maker.add_mesh(positions,
                   maker.add_accessor(GltfMaker::bytes_of(ids), component, 36, "SCALAR"));
    maker.show_nodes(Gltf::array({{{"mesh", 0}}}));
    return maker;
  };
  expect_cube(read(cube_with(std::uint8_t(), 5121)), 1e-12, "uint8");
  expect_cube(read(cube_with(std::uint16_t(), 5123)), 1e-12, "uint16");
  expect_cube(read(cube_with(std::uint32_t(), 5125)), 1e-12, "uint32");
  expect_parts(refusal(cube_with(float(), 5126)), {"primitive 0", "component type 5126"});
}

TEST_F(GltfGeometry, ReadsOffsetsWithinOneView) {
  GltfMaker maker;
  std::string bytes = "a few bytes that nobody needs...";  // 32
  bytes += GltfMaker::bytes_of(GltfMaker::cube_corners(), 3, 28);
  const size_t view = maker.add_view(bytes, {{"byteStride", 28}});
  const size_t positions = maker.add("accessors", {{"bufferView", view},
                                                   {"byteOffset", 32},
                                                   {"componentType", 5126},
                                                   {"count", 8},
                                                   {"type", "VEC3"}});
  maker.add_mesh(positions, maker.add_cube_indices());
  maker.show_nodes(Gltf::array({{{"mesh", 0}}}));
  expect_cube(read(maker), 1e-12, "offset");
  maker.json["accessors"][positions]["byteOffset"] = 52;
  expect_parts(refusal(maker), {"extends beyond its buffer"});
}

// A sparse accessor replaces values of a view, of zeros, and with bytes as indices.
TEST_F(GltfGeometry, ReadsSparseAccessors) {
  const auto sparse_cube = [&](bool with_view, int component) {
    GltfMaker maker;
    std::vector<float> corners = GltfMaker::cube_corners();
    const std::vector<float> last(corners.end() - 6, corners.end());
    std::fill(corners.end() - 6, corners.end(), with_view ? 9.0f : 0.0f);
    size_t positions = maker.add_accessor(GltfMaker::bytes_of(corners), 5126, 8, "VEC3");
    const std::string ids = component == 5121 ? std::string("\6\7", 2) : std::string("\6\0\7\0", 4);
    const size_t id_view = maker.add_view(ids), values = maker.add_view(GltfMaker::bytes_of(last));
    maker.json["accessors"][positions]["sparse"] = {
        {"count", 2},
        {"indices", {{"bufferView", id_view}, {"componentType", component}}},
        {"values", {{"bufferView", values}}}};
    maker.add_mesh(positions, maker.add_cube_indices());
    maker.show_nodes(Gltf::array({{{"mesh", 0}}}));
    return maker;
  };
  expect_cube(read(sparse_cube(true, 5121)), 1e-12, "bytes");
  expect_cube(read(sparse_cube(true, 5123)), 1e-12, "shorts");
  ASSERT_TRUE(read(sparse_cube(true, 5123)).appearance);
  GltfMaker out_of_range = sparse_cube(true, 5121);
  out_of_range.json["accessors"][0]["count"] = 7;
  expect_parts(refusal(out_of_range), {"of 7 items replaces item 7"});
  // Six zeros and two corners: a line, with faces that have no area.
  GltfMaker zeros = sparse_cube(false, 5121);
  zeros.json["accessors"][0].erase("bufferView");
  EXPECT_EQ(read(zeros).mesh.vertices.size(), 3u);
  zeros.json["accessors"][0]["count"] = std::uint64_t{1} << 40;
  expect_parts(refusal(zeros), {"no data", "accepted: up to 16777216"});
}

// Two triangles of a square as a list, strip and fan, with and without indices.
TEST_F(GltfGeometry, TakesStripsAndFansApart) {
  const std::vector<float> strip{0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 2, 0};
  const std::vector<float> fan{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, -1, 1, 0};
  for (const int mode : {5, 6})
    for (const bool indexed : {false, true}) {
      GltfMaker maker;
      const size_t positions =
          maker.add_accessor(GltfMaker::bytes_of(mode == 5 ? strip : fan), 5126, 5, "VEC3");
      maker.add_mesh(positions,
                     maker.add_accessor(std::string("\0\1\2\3\4", 5), 5121, 5, "SCALAR"));
      maker.primitive()["mode"] = mode;
      if (!indexed) maker.primitive().erase("indices");
      maker.show_nodes(Gltf::array({{{"mesh", 0}}}));
      const Model model = read(maker);
      ASSERT_EQ(model.mesh.triangles.size(), 3u);
      for (Index f = 0; f < 3; ++f) {
        const Triangle t = model.mesh.triangle(f);
        EXPECT_EQ((t[1] - t[0]).cross(t[2] - t[0]), Vec3(0, 0, 1)) << mode << " face " << f;
      }
      EXPECT_TRUE(testing::same_triangles(testing::triangles_of(model.mesh),
                                          testing::reference_triangles(path("m.glb"))));
    }
}

TEST_F(GltfGeometry, CountsPointsLinesAndRests) {
  GltfMaker maker;
  const size_t positions = maker.add_cube_positions(), indices = maker.add_cube_indices();
  maker.add_mesh(positions, indices);
  Gltf primitives = maker.json["meshes"][0]["primitives"];
  for (const int mode : {0, 1, 2, 3, 0})
    primitives.push_back({{"attributes", {{"POSITION", positions}}}, {"mode", mode}});
  primitives.push_back({{"attributes", {{"POSITION", positions}}}});  // 8 vertices: 2 triangles
  primitives.push_back({{"attributes", {{"COLOR_0", positions}}}, {"indices", indices}});
  maker.json["meshes"][0]["primitives"] = primitives;
  maker.show_nodes(Gltf::array({{{"mesh", 0}}, {{"mesh", 0}}}));
  const Model model = read(maker);
  EXPECT_EQ(model.mesh.triangles.size(), 2 * 14u);
  expect_parts(lines_of(model.notes), {"points left out: 32\n", "lines left out: 38\n",
                                       "vertices left out, too few for another triangle: 4\n",
                                       "primitives left out, as they have no positions: 2\n"});
  maker.json["meshes"][0]["primitives"][0]["mode"] = 7;
  expect_parts(refusal(maker), {"mode 7", "accepted: 0 to 6"});
  maker.json["meshes"][0]["primitives"] = Gltf::array({primitives[1]});
  expect_parts(refusal(maker), {"contains no triangle (points left out: 16)"});
}

Gltf moved(double x, Gltf node) {
  node["translation"] = {x, 0, 0};
  return node;
}

// Quaternions of other lengths would scale and shear, as some programs do.
TEST_F(GltfGeometry, BringsRotationsToLength1) {
  const double root_half = std::sqrt(0.5);
  for (const double length : {1.0, 0.5, 2.0, 1e-12, 1e12}) {
    GltfMaker maker;
    maker.add_cube();
    const double part = length * root_half;
    maker.show_nodes(
        Gltf::array({{{"mesh", 0}, {"rotation", {0, 0, part, part}}, {"scale", {1, 2, 4}}}}));
    const Model model = read(maker);
    const Vec3 size = model.mesh.box().upper - model.mesh.box().lower;
    EXPECT_NEAR((size - Vec3(2, 1, 4)).norm(), 0, 1e-6) << length;
    EXPECT_EQ(model.notes.size(), length == 1 ? 0 : 1);
    if (length != 1) expect_parts(lines_of(model.notes), {"brought to length 1: 1"});
  }
  GltfMaker maker;
  maker.add_cube();
  maker.show_nodes(Gltf::array({{{"mesh", 0}, {"rotation", {0, 0, 0, 0}}, {"name", "n"}}}));
  expect_parts(refusal(maker), {"\"n\"", "rotation has no length", "accepted: a quaternion"});
  maker.json["nodes"][0] = {{"mesh", 0},
                            {"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 2}}};
  expect_parts(refusal(maker), {"matrix has not 0 0 0 1 as its last row"});
}

// A mirror in any form turns the order of corners: the boxes stay solid.
TEST_F(GltfGeometry, TurnsWindingBelowMirrors) {
  const std::vector<Gltf> mirrors = {{{"scale", {-1, 1, 1}}},
                                     {{"scale", {1, -1, 1}}},
                                     {{"scale", {-1, -1, -1}}},
                                     {{"matrix", {0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}}},
                                     {{"scale", {1, 1, -1}}, {"rotation", {0.6, 0, 0, 0.8}}}};
  for (const Gltf& mirror : mirrors) {
    GltfMaker maker;
    maker.add_cube();
    Gltf parent = mirror, twice = mirror;
    parent["children"] = {2};
    twice["children"] = {4};
    Gltf alone = mirror;
    alone["mesh"] = 0;
    // A plain cube, one below a mirror, one below two, and one that is a mirror itself.
    maker.show_nodes(Gltf::array({moved(-9, {{"mesh", 0}}), parent, moved(2, {{"mesh", 0}}), twice,
                                  moved(5, {{"scale", {-1, 1, 1}}, {"mesh", 0}}), alone}));
    const Model model = read(maker);
    const MassProperties mass = mass_of(model);
    EXPECT_EQ(mass.rule, MassRule::Volume) << mirror;
    EXPECT_NEAR(mass.volume, 4, 1e-6) << mirror;
    EXPECT_TRUE(testing::same_triangles(testing::triangles_of(model.mesh),
                                        testing::reference_triangles(path("m.glb"))))
        << mirror;
    expect_parts(lines_of(model.notes), {"mirrored meshes, winding turned round: 2"});
  }
}

// Four legs of 0.1 x 0.1 x 0.5 and a top of 1.2 x 0.1 x 0.8; two legs are mirrored copies.
TEST_F(GltfGeometry, WeighsATableWithMirroredLegs) {
  GltfMaker maker;
  maker.add_cube();
  Gltf nodes =
      Gltf::array({{{"mesh", 0}, {"scale", {1.2, 0.1, 0.8}}, {"translation", {0, 0.55, 0}}}});
  for (const int side : {1, -1})
    for (const int end : {1, -1}) {
      const size_t leg = nodes.size() + 1;
      nodes.push_back({{"scale", {side, 1, 1}}, {"children", {leg}}});
      nodes.push_back(
          {{"mesh", 0}, {"scale", {0.1, 0.5, 0.1}}, {"translation", {0.5, 0.25, 0.3 * end}}});
    }
  maker.show_nodes(nodes);
  const MassProperties mass = mass_of(read(maker));
  const double top = 1.2 * 0.1 * 0.8, legs = 4 * 0.1 * 0.1 * 0.5;
  EXPECT_EQ(mass.rule, MassRule::Volume);
  EXPECT_NEAR(mass.volume, top + legs, 1e-8);
  EXPECT_LT((mass.centre - Vec3(0, (top * 0.55 + legs * 0.25) / (top + legs), 0)).norm(), 1e-7);
}

TEST_F(GltfGeometry, ReadsSkinsAndMorphTargetsAtRest) {
  GltfMaker maker;
  maker.add_cube();
  maker.json["skins"] = Gltf::array({{{"joints", {1}}}});
  maker.primitive()["targets"] = Gltf::array({{{"POSITION", 0}}});
  maker.json["meshes"][0]["weights"] = {1};
  // A skin whose mesh has no joints: assimp crashes.
  maker.show_nodes(Gltf::array({{{"mesh", 0}, {"skin", 0}}, {{"name", "joint"}}}));
  const Model model = read(maker);
  expect_cube(model, 1e-12, "skinned");
  expect_parts(lines_of(model.notes), {"meshes with bones, read in bind pose: 1",
                                       "meshes with morph targets, read without them: 1",
                                       "left out: skins", "left out: morph target weights"});
}

TEST_F(GltfGeometry, ReadsTheDefaultSceneAndNamesTheOthers) {
  GltfMaker maker;
  maker.add_cube();
  maker.show_nodes(Gltf::array({{{"mesh", 0}}, moved(3, {{"mesh", 0}})}));
  maker.json["scenes"] =
      Gltf::parse(R"([{"name":"first","nodes":[0]},{"name":"both","nodes":[0,1]},{"nodes":[1]}])");
  maker.json["scene"] = 1;
  const Model both = read(maker);
  EXPECT_EQ(both.mesh.triangles.size(), 24u);
  expect_parts(lines_of(both.notes), {"other scenes left out: 2 (\"first\", \"\")"});
  maker.json.erase("scene");
  EXPECT_EQ(read(maker).mesh.triangles.size(), 12u);
  maker.json["scene"] = 3;
  expect_parts(refusal(maker), {"element 3 of \"scenes\", which has 3"});
  maker.json.erase("scene"), maker.json.erase("scenes");
  expect_parts(refusal(maker), {"has no scene"});
}

TEST_F(GltfGeometry, NamesWhatIsWrongWithPrimitives) {
  GltfMaker maker;
  maker.add_cube();
  maker.json["meshes"][0]["name"] = "box";
  maker.show_nodes(Gltf::array({{{"mesh", 0}}}));
  maker.json["accessors"][1]["count"] = 35;
  maker.json["accessors"][0]["count"] = 7;
  expect_parts(refusal(maker), {"mesh 'box', primitive 0: index 10 refers to vertex 7 of 7"});
  maker.json["accessors"][0] = {
      {"bufferView", 0}, {"componentType", 5130}, {"count", 8}, {"type", "VEC3"}};
  expect_parts(refusal(maker), {"mesh 'box', primitive 0", "component type 5130"});
  maker.json["accessors"][0]["componentType"] = 5126;
  maker.json["accessors"][0]["count"] = 8;
  maker.json["nodes"][0]["rotation"] = {0, 0, 1};
  expect_parts(refusal(maker), {"a node's rotation has not 4 numbers"});
  maker.json["nodes"] = Gltf::parse(R"([{"mesh":0,"children":[0]}])");
  expect_parts(refusal(maker), {"do not form a tree"});
  maker.json["nodes"] = Gltf::parse(R"([{"mesh":5}])");
  expect_parts(refusal(maker), {"element 5 of \"meshes\", which has 1"});
}

}  // namespace
}  // namespace trivet
