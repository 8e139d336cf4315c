// Damaged glTF in this very process: a model, or an error that names the file. Draco's library is
// left to tests/fuzz, where a process guards it.
#include <random>

#include "core/io/io_testing.h"
#include "core/io/json.h"
#include "core/io/read_model.h"
#include "core/io/textures/surface_look.h"
#include "support/effort.h"
#include "support/gltf_maker.h"
#include "support/mutated_gltf.h"

namespace trivet {
namespace {

using test::Gltf;
using test::GltfMaker;

struct Random {
  std::mt19937_64 engine;
  size_t below(size_t limit) { return limit ? engine() % limit : 0; }
};

// A cube with all that has lengths and offsets: sparse, strided, instanced, skinned, mirrored.
std::string cube_of_everything() {
  GltfMaker maker;
  maker.add_cube();
  const size_t ids = maker.add_view(std::string("\1\2", 2));
  const size_t values = maker.add_view(std::string(24, '\0'));
  maker.json["accessors"][0]["sparse"] = {
      {"count", 2},
      {"indices", {{"bufferView", ids}, {"componentType", 5121}}},
      {"values", {{"bufferView", values}}}};
  maker.json["bufferViews"][0]["byteStride"] = 12;
  const size_t places = maker.add_accessor(std::string(24, '\1'), 5126, 2, "VEC3");
  const size_t colours =
      maker.add_accessor(std::string(32, '\x7f'), 5121, 8, "VEC4", {{"normalized", true}});
  maker.json["materials"] = Gltf::parse(
      R"([{"name":"m","pbrMetallicRoughness":{"baseColorFactor":[1,0.5,0.25,1],"metallicFactor":0.5},
           "extensions":{"KHR_materials_clearcoat":{"clearcoatFactor":1}}}])");
  maker.primitive()["material"] = 0;
  maker.primitive()["mode"] = 4;
  maker.primitive()["attributes"].update({{"NORMAL", 0}, {"COLOR_0", colours}});
  maker.primitive()["targets"] = Gltf::array({{{"POSITION", 0}}});
  maker.json["skins"] = Gltf::array({{{"joints", {0}}}});
  maker.json["cameras"] =
      Gltf::parse(R"([{"type":"perspective","perspective":{"yfov":1,"znear":1}}])");
  maker.json["extensionsUsed"] = {"EXT_mesh_gpu_instancing"};
  maker.show_nodes(Gltf::array(
      {{{"name", "a"}, {"scale", {-1, 1, 1}}, {"children", {1, 2}}},
       {{"mesh", 0}, {"skin", 0}, {"rotation", {0, 0, 0, 1}}},
       {{"mesh", 0},
        {"camera", 0},
        {"extensions",
         {{"EXT_mesh_gpu_instancing", {{"attributes", {{"TRANSLATION", places}}}}}}}}}));
  return maker.glb();
}

class GltfFuzz : public testing::IoTest {
 protected:
  /// True if a model was read.
  bool reads(const std::string& bytes, std::uint64_t seed) const {
    ImportLimits limits;
    limits.max_triangles = 100'000;
    const std::string file = write("m.glb", bytes);
    try {
      const Model model = read_model(file, limits);
      surface_look(model);
      EXPECT_FALSE(model.mesh.triangles.empty()) << seed;
      EXPECT_EQ(model.face_material.size(), model.mesh.triangles.size()) << seed;
      for (const Vec3& p : model.mesh.vertices) EXPECT_TRUE(p.allFinite()) << seed;
      return true;
    } catch (const Error& e) {
      const std::string message = e.what();
      EXPECT_EQ(message.rfind(file, 0), 0u) << seed << ": " << message;
      EXPECT_EQ(message.find("json.exception"), message.npos) << seed << ": " << message;
      return false;
    }
  }
};

TEST_F(GltfFuzz, ReadsOrRefusesDamagedFiles) {
  std::vector<std::string> files{cube_of_everything()};
  for (const char* const name : {"ring", "quantize", "meshopt", "pack_c", "pack_vpf"})
    files.push_back(testing::read_bytes(std::string(TRIVET_SOURCE_DIR) + "/tests/support/gltf/" +
                                        name + ".glb"));
  for (const std::string& file : files) ASSERT_TRUE(reads(file, 0) || &file > &files[2]);
  const int count = test::with_effort(6000);
  int num_read = 0;
  for (int i = 1; i <= count; ++i) {
    Random random{std::mt19937_64(static_cast<std::uint64_t>(i))};
    num_read += reads(test::mutated_gltf(files[random.below(files.size())], random),
                      static_cast<std::uint64_t>(i));
  }
  std::cout << num_read << " of " << count << " damaged files read\n";
  EXPECT_GT(num_read, count / 20);  // else nothing behind the first checks is tried
  EXPECT_LT(num_read, count * 19 / 20);
}

// Texts that are nearly JSON: the same answer as the library's own parser, but for keys that come
// twice.
TEST(JsonFuzz, AgreesWithTheLibrary) {
  const std::string base =
      R"({"a":[1,-2.5e3,{"b":"\u00e9\n","c":[[],{}]},null],"d":{"e":true,"f":[0.1,"x"]}})";
  constexpr std::string_view kBytes = "{}[]\",:0123456789.-+eE\\untrfalse \n\xc3\xa9";
  int num_valid = 0;
  const int count = test::with_effort(20000);
  for (int i = 1; i <= count; ++i) {
    Random random{std::mt19937_64(static_cast<std::uint64_t>(i))};
    std::string text = base;
    for (size_t k = random.below(3) + 1; k-- > 0;) {
      const size_t at = random.below(text.size());
      if (random.below(2))
        text.insert(at, 1, kBytes[random.below(kBytes.size())]);
      else
        text[at] = kBytes[random.below(kBytes.size())];
    }
    const auto found = json_if_valid<Gltf>(text);
    const Gltf expected = Gltf::parse(text, nullptr, false);
    if (found) {
      EXPECT_EQ(*found, expected) << text;
    } else if (!expected.is_discarded()) {
      const std::string why = testing::error_of([&] { json_from_text<Gltf>(text, "t"); });
      EXPECT_NE(why.find("this key comes twice"), why.npos) << text << why;
    }
    num_valid += found.has_value();
  }
  EXPECT_GT(num_valid, count / 20);
}

}  // namespace
}  // namespace trivet
