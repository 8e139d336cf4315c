// glTF as packers write it: quantised, compressed by meshoptimizer and Draco, instanced. The files
// in tests/support/gltf hold one ring, of which the numbers are known.
#include <cmath>
#include <numbers>

#include "core/io/export.h"
#include "core/io/gltf/meshopt_attributes.h"
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

class GltfPacked : public testing::IoTest {
 protected:
  static std::string fixture(const std::string& name) {
    return std::string(TRIVET_SOURCE_DIR) + "/tests/support/gltf/" + name;
  }
  Model read(const GltfMaker& maker) const { return read_model(write("m.glb", maker.glb())); }
  std::string refusal(const GltfMaker& maker) const {
    return testing::error_of([&] { read(maker); });
  }
};

// 8 x 6 corners about (0.5, 1, 0).
std::vector<Vec3> ring_corners() {
  std::vector<Vec3> out;
  for (int i = 0; i < 8; ++i)
    for (int j = 0; j < 6; ++j) {
      const double a = i * std::numbers::pi / 4, b = j * std::numbers::pi / 3;
      const double r = 2 + std::cos(b);
      out.emplace_back(r * std::cos(a) + 0.5, std::sin(b) + 1, r * std::sin(a));
    }
  return out;
}

// Distance of any point from the nearest of the others, at most.
double greatest_distance(const std::vector<Vec3>& points, const std::vector<Vec3>& others) {
  double greatest = 0;
  for (const Vec3& p : points) {
    double least = INFINITY;
    for (const Vec3& q : others) least = std::min(least, (p - q).norm());
    greatest = std::max(greatest, least);
  }
  return greatest;
}

// The same mesh within the quantum: each corner is there, and the solid between them.
void expect_ring(const Model& model, double quantum, const std::string& what) {
  ASSERT_EQ(model.mesh.vertices.size(), 48u) << what;
  EXPECT_EQ(model.mesh.triangles.size(), 96u) << what;
  EXPECT_LT(greatest_distance(model.mesh.vertices, ring_corners()), quantum) << what;
  EXPECT_LT(greatest_distance(ring_corners(), model.mesh.vertices), quantum) << what;
  const MassProperties mass = mass_properties(model.mesh, make_adjacency(model.mesh));
  EXPECT_EQ(mass.rule, MassRule::Volume) << what;
  // Six corners: the hexagon's area times the way of its centre, chords instead of arcs.
  EXPECT_NEAR(mass.volume, 29.393876913398156, 100 * quantum) << what;
  EXPECT_LT((mass.centre - Vec3(0.5, 1, 0)).norm(), 10 * quantum) << what;
  EXPECT_EQ(model.corner_normals.size(), 96u) << what;
}

TEST_F(GltfPacked, ReadsWhatPackersWrite) {
  expect_ring(read_model(fixture("ring.glb")), 1e-6, "plain");
  // 14 bits for 6 units, which is what both packers use.
  const double quantum_of_14_bits = std::sqrt(3.0) * 6 / 16383;
  expect_ring(read_model(fixture("quantize.glb")), quantum_of_14_bits, "quantised");
  const std::pair<const char*, double> packed[] = {{"meshopt.glb", quantum_of_14_bits},
                                                   {"pack_c.glb", quantum_of_14_bits},
                                                   {"pack_vpf.glb", 1e-4},
                                                   {"pack_cz.glb", quantum_of_14_bits},
                                                   {"draco.glb", quantum_of_14_bits}};
  for (const auto& [name, quantum] : packed) {
    std::string message;
    try {
      expect_ring(read_model(fixture(name)), quantum, name);
      continue;
    } catch (const Error& e) {
      message = e.what();
    }
    // A build without the decoder says so.
    EXPECT_NE(message.find("this build lacks"), message.npos) << message;
  }
}

TEST_F(GltfPacked, ExportsWhatWasPacked) {
  const auto model = std::make_shared<const Model>(read_model(fixture("quantize.glb")));
  ASSERT_TRUE(model->appearance);
  write_scene({{{"ring", model, {}, ""}}, ""}, path("s.glb"));
  const Model again = read_model(path("s.glb"));
  EXPECT_TRUE(again.notes.empty());
  ASSERT_EQ(again.mesh.vertices.size(), model->mesh.vertices.size());
  EXPECT_EQ(again.mesh.triangles, model->mesh.triangles);
}

TEST_F(GltfPacked, NamesWhatIsDamaged) {
  for (const char* const name : {"meshopt.glb", "pack_c.glb", "draco.glb"}) {
    const std::string good = testing::read_bytes(fixture(name));
    std::string bytes = good;
    const size_t data = bytes.find("BIN", 20) + 4;
    for (size_t i = data; i < data + 40; ++i) bytes[i] = static_cast<char>(~bytes[i]);
    expect_parts(testing::error_of([&] { read_model(write("m.glb", bytes)); }), {path("m.glb")});
    if (std::string(name) == "draco.glb") continue;  // what it decodes counts
    bytes = good;
    bytes.replace(bytes.find("\"count\":48"), 10, "\"count\":-1");
    expect_parts(testing::error_of([&] { read_model(write("m.glb", bytes)); }),
                 {path("m.glb"), "-1 is not an index or a size"});
  }
}

// The example of the specification: 16 deltas of 4 bits, two of them in bytes of their own.
TEST(MeshoptAttributes, DecodesTheSpecifiedExample) {
  const std::string deltas("\x17\x5f\xf0\xbc\x77\xa9\x21\x00\x34\xb5", 10);
  // Bits 1, 2, 4 and 8, the third for the only group; the other bytes of the element are zero.
  const std::string bytes = std::string("\xa1\xa9\x02", 3) + deltas + std::string(19 + 5, '\0');
  const std::string found = gltf::decoded_attributes(bytes, 16, 4);
  ASSERT_EQ(found.size(), 64u);
  const int expected[] = {-1, -4, -3, 26, -91, 0, -6, 6, -4, -4, 5, -5, 1, -1, 0, 0};
  for (int i = 0, sum = 0; i < 16; ++i) {
    sum += expected[i];
    EXPECT_EQ(static_cast<signed char>(found[static_cast<size_t>(4 * i)]),
              static_cast<signed char>(sum))
        << i;
    EXPECT_EQ(found.substr(static_cast<size_t>(4 * i + 1), 3), std::string(3, '\0'));
  }
  for (size_t size = 0; size < bytes.size(); ++size)
    EXPECT_EQ(gltf::decoded_attributes(bytes.substr(0, size), 16, 4), "") << size;
  EXPECT_EQ(gltf::decoded_attributes(bytes + "x", 16, 4), "");
  std::string wrong_mode = bytes;
  wrong_mode.back() = 3;
  EXPECT_EQ(gltf::decoded_attributes(wrong_mode, 16, 4), "");
}

TEST(MeshoptAttributes, TurnsLumaToColours) {
  std::string grey("\xc8\x00\x00\xff", 4), red("\x40\x40\xc0\xc0", 4);
  gltf::apply_colour_filter(grey, 4);
  EXPECT_EQ(grey, std::string("\xc8\xc8\xc8\xff", 4));
  gltf::apply_colour_filter(red, 4);  // 64 + 64 + 64, 64 - 64, 64 - 64 + 64; 64 of 127
  EXPECT_EQ(red, std::string("\xc0\x00\x40\x80", 4));
  std::string wide("\x0f\x00\x00\x00\x00\x00\x0f\x00", 8);  // 4 bits of 16
  gltf::apply_colour_filter(wide, 8);
  EXPECT_EQ(wide, std::string("\xff\xff\xff\xff\xff\xff\xff\xff", 8));
}

// Eight cubes in a row, in the forms that instances may have.
GltfMaker row_of_cubes(const Gltf& more_of_node = Gltf::object()) {
  GltfMaker maker;
  maker.add_cube();
  std::vector<float> places;
  for (int i = 0; i < 8; ++i) places.insert(places.end(), {2.0f * static_cast<float>(i), 0, 0});
  const size_t translations = maker.add_accessor(GltfMaker::bytes_of(places), 5126, 8, "VEC3");
  Gltf node = {{"mesh", 0},
               {"extensions",
                {{"EXT_mesh_gpu_instancing", {{"attributes", {{"TRANSLATION", translations}}}}}}}};
  node.update(more_of_node);
  maker.json["extensionsRequired"] = {"EXT_mesh_gpu_instancing"};
  maker.show_nodes(Gltf::array({node}));
  return maker;
}

Gltf& instances_of(GltfMaker& maker) {
  return maker.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"];
}

double volume_of(const Model& model) {
  const MassProperties mass = mass_properties(model.mesh, make_adjacency(model.mesh));
  return mass.rule == MassRule::Volume ? mass.volume : -1;
}

TEST_F(GltfPacked, ReadsInstances) {
  const Model row = read(row_of_cubes());
  EXPECT_EQ(row.mesh.triangles.size(), 8 * 12u);
  EXPECT_NEAR(volume_of(row), 8, 1e-12);
  EXPECT_EQ(row.mesh.box().upper, Vec3(14.5, 0.5, 0.5));
  ASSERT_TRUE(row.appearance);
  EXPECT_TRUE(row.notes.empty());

  // Scales, of which some mirror, and turns as normalised shorts: a quarter about z.
  GltfMaker maker = row_of_cubes({{"scale", {1, 1, 2}}});
  std::vector<float> scales;
  std::vector<std::int16_t> turns;
  for (int i = 0; i < 8; ++i) {
    scales.insert(scales.end(), {i % 2 ? -1.0f : 1.0f, 0.5f, 1});
    turns.insert(turns.end(), {0, 0, 23170, 23170});
  }
  const size_t scale = maker.add_accessor(GltfMaker::bytes_of(scales), 5126, 8, "VEC3");
  const size_t turn =
      maker.add_accessor(GltfMaker::bytes_of(turns), 5122, 8, "VEC4", {{"normalized", true}});
  instances_of(maker)["SCALE"] = scale;
  instances_of(maker)["ROTATION"] = turn;
  instances_of(maker)["_COLOUR"] = 99;  // of others
  const Model turned = read(maker);
  EXPECT_NEAR(volume_of(turned), 8 * 0.5 * 2, 1e-3);
  EXPECT_LT((turned.mesh.box().upper - Vec3(14.25, 0.5, 1)).norm(), 1e-3);
  EXPECT_EQ(in_english(turned.notes),
            std::vector<std::string>{"mirrored meshes, winding turned round: 4"});
}

TEST_F(GltfPacked, KeepsChildrenOfInstances) {
  GltfMaker maker = row_of_cubes({{"translation", {0, 3, 0}}, {"children", {1}}});
  Gltf nodes = maker.json["nodes"];
  nodes.push_back({{"mesh", 0}, {"translation", {0, 2, 0}}});
  maker.show_nodes(nodes);
  const Model model = read(maker);
  EXPECT_EQ(model.mesh.triangles.size(), 9 * 12u);
  EXPECT_EQ(model.mesh.box().upper, Vec3(14.5, 5.5, 0.5));
}

TEST_F(GltfPacked, NamesWhatIsWrongWithInstances) {
  GltfMaker maker = row_of_cubes();
  maker.json["accessors"].back()["count"] = 7;
  instances_of(maker)["SCALE"] = 0;
  expect_parts(refusal(maker), {"instances have 8 values of SCALE for 7 instances"});
  maker = row_of_cubes();
  instances_of(maker)["ROTATION"] = 2;
  expect_parts(refusal(maker), {"instances have a ROTATION of 3 components"});
  maker = row_of_cubes();
  const float nan = NAN;
  maker.binary.replace(maker.binary.size() - 4, 4, reinterpret_cast<const char*>(&nan), 4);
  expect_parts(refusal(maker), {"instance 7 has a TRANSLATION that is not finite"});
  maker = row_of_cubes();
  maker.json["accessors"].back().erase("bufferView");
  maker.json["accessors"].back()["count"] = 1 << 24;
  expect_parts(refusal(maker), {"more than 1000000 instances, the limit"});
}

}  // namespace
}  // namespace trivet
