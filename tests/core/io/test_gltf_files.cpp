// Files of glTF as they come: containers, names, encodings, buffers beside them, extensions.
#include <filesystem>

#include "core/io/io_testing.h"
#include "core/io/read_model.h"
#include "support/gltf_maker.h"

namespace trivet {
namespace {

using test::Gltf;
using test::GltfMaker;
using testing::expect_parts;

GltfMaker cube() {
  GltfMaker maker;
  maker.add_cube();
  maker.show_nodes(Gltf::array({{{"mesh", 0}}}));
  return maker;
}

const char* const kCubeUri =
    "data:application/octet-stream;base64,AAAAvwAAAL8AAAC/AAAAPwAAAL8AAAC/AAAAvwAAAD8AAAC/AAAAP"
    "wAAAD8AAAC/AAAAvwAAAL8AAAA/AAAAPwAAAL8AAAA/AAAAvwAAAD8AAAA/AAAAPwAAAD8AAAA/AAACAAEAAQACAAM"
    "ABAAFAAYABQAHAAYAAAABAAQAAQAFAAQAAgAGAAMAAwAGAAcAAAAEAAIAAgAEAAYAAQADAAUAAwAHAAUA";

class GltfFiles : public testing::IoTest {
 protected:
  void expect_cube(const std::string& file) const {
    const Model model = read_model(file);
    EXPECT_EQ(model.format, "gltf2") << file;
    EXPECT_EQ(model.mesh.triangles.size(), 12u) << file;
    EXPECT_EQ(model.mesh.vertices.size(), 8u) << file;
    const Aabb box = model.mesh.box();
    EXPECT_EQ(box.lower, Vec3::Constant(-0.5)) << file;
    EXPECT_EQ(box.upper, Vec3::Constant(0.5)) << file;
  }
  void expect_refused(const std::string& file, const std::vector<std::string>& parts) const {
    const std::string message = testing::error_of([&] { read_model(file); });
    expect_parts(message, {file + ": "});
    expect_parts(message, parts);
    EXPECT_EQ(message.find("json.exception"), message.npos) << message;
  }
};

TEST_F(GltfFiles, ReadsByContentNotByName) {
  const std::string glb = cube().glb(), text = cube().text(kCubeUri);
  for (const char* const name : {"a.glb", "b.gltf", "C.GLB", "d.obj", "e.bin", "f"})
    expect_cube(write(name, glb));
  for (const char* const name : {"a.gltf", "b.glb", "C.GLTF"}) expect_cube(write(name, text));
}

TEST_F(GltfFiles, ReadsContainersAsTheyCome) {
  const GltfMaker maker = cube();
  std::string json = maker.with_buffer().dump();
  while (json.size() % 4 != 1) json += ' ';
  const std::string data = GltfMaker::chunk("BIN\0", maker.binary);
  const auto of = [&](const std::string& chunks) { return GltfMaker::container(chunks); };
  expect_cube(write("unpadded.glb", of(GltfMaker::chunk("JSON", json) + data)));
  expect_cube(write("aligned.glb", of(GltfMaker::chunk("JSON", json) + "   " + data)));
  expect_cube(write("zeros.glb", of(GltfMaker::chunk("JSON", json + std::string(3, '\0')) + data)));
  expect_cube(write("trailing.glb", maker.glb() + "and more"));
  expect_cube(write("more.glb", of(GltfMaker::chunk("JSON", json + "   ") + data +
                                   GltfMaker::chunk("XTRA", "what nobody knows"))));
  expect_cube(write("data.glb", of(GltfMaker::chunk("JSON", maker.text(kCubeUri)))));
  expect_refused(write("short.glb", maker.glb().substr(0, 200)), {"truncated: 200 bytes of"});
  expect_refused(write("none.glb", of(GltfMaker::chunk("JSON", json + "   "))),
                 {"buffer 0 has 0 bytes, expected"});
  expect_refused(write("three.glb", GltfMaker::container("", 3) + std::string(20, ' ')),
                 {"glTF version 3; accepted: 2"});
}

TEST_F(GltfFiles, ReadsTextsInUtf8) {
  const std::string text = cube().text(kCubeUri);
  expect_cube(write("mark.gltf", "\xef\xbb\xbf" + text));
  expect_cube(write("blank.gltf", "\n\t " + text + "\r\n"));
  std::string wide = "\xff\xfe";
  for (const char c : text) (wide += c) += '\0';
  expect_refused(write("wide.gltf", wide), {"is UTF-16 text; accepted: glTF in UTF-8"});
  expect_refused(write("latin.gltf", "{\"asset\":{\"copyright\":\"\xe9\"}}"), {"UTF-8"});
}

// Names of buffers: percent-encoded, as they are, below, and in another alphabet.
TEST_F(GltfFiles, FindsBuffersBeside) {
  const GltfMaker maker = cube();
  std::filesystem::create_directories(path("sub folder"));
  for (const char* const name :
       {"my cube.bin", "100%.bin", "a%20b.bin", "sub folder/x.bin", "w\xc3\xbcrfel.bin"})
    write(name, maker.binary);
  for (const char* const uri :
       {"my%20cube.bin", "my cube.bin", "100%.bin", "100%25.bin", "a%20b.bin", "./my%20cube.bin",
        "sub%20folder/x.bin", "sub%20folder/../my cube.bin", "w%C3%BCrfel.bin",
        "w\xc3\xbcrfel.bin"})
    expect_cube(write("m.gltf", maker.text(uri)));
  // Binary files name buffers, too.
  const Gltf json = maker.with_buffer({{"uri", "my%20cube.bin"}});
  expect_cube(write("m.glb", GltfMaker::container(GltfMaker::chunk("JSON", json.dump()))));
}

TEST_F(GltfFiles, NamesBuffersThatItDoesNotRead) {
  const GltfMaker maker = cube();
  std::filesystem::create_directories(path("m"));
  write("outside.bin", maker.binary);
  const auto file = [&](const std::string& uri) { return write("m/m.gltf", maker.text(uri)); };
  expect_refused(file("gone.bin"), {"names \"gone.bin\", which is missing"});
  expect_refused(file("gone%20one.bin"), {"names \"gone%20one.bin\", which is missing"});
  expect_refused(file("https://example.org/x.bin"), {"which is missing"});
  for (const char* const uri : {"../outside.bin", "%2e%2e/outside.bin", "/etc/passwd"})
    expect_refused(file(uri), {uri, "which is outside its folder"});
  Gltf zero = Gltf::parse(maker.text("x"));
  zero["buffers"][0]["uri"] = std::string("../outside.bin\0/../m/m.gltf", 27);
  expect_refused(write("m/m.gltf", zero.dump()), {"which is outside its folder"});
  zero["buffers"][0]["uri"] = "%2e%2e/outside.bin%00/../m/m.gltf";
  expect_refused(write("m/m.gltf", zero.dump()), {"which is outside its folder"});
  // The model is there by a path with "..", the buffer is not.
  file("gone.bin");
  expect_refused(path("m/../m/m.gltf"), {"names \"gone.bin\", which is missing"});
  expect_refused(file("data:text/plain,abc"), {"buffer 0 has 3 bytes, expected 168"});
  expect_refused(file("data:text/plain"), {"a data URI has no comma before its data"});
  write("m/short.bin", "abc");
  expect_refused(file("short.bin"), {"buffer 0 has 3 bytes, expected"});
}

TEST_F(GltfFiles, ObeysRequiredExtensions) {
  GltfMaker maker = cube();
  const auto file = [&](const Gltf& required) {
    maker.json["extensionsRequired"] = required;
    return write("m.glb", maker.glb());
  };
  expect_cube(file({"KHR_mesh_quantization", "KHR_texture_transform", "KHR_materials_unlit",
                    "EXT_mesh_gpu_instancing", "KHR_materials_variants"}));
  expect_refused(file({"ACME_folded"}), {"requires ACME_folded, which Trivet does not have"});
  expect_refused(file({"KHR_mesh_quantization", "ACME_a", "KHR_lights_punctual", "MSFT_lod"}),
                 {"requires ACME_a, MSFT_lod, which"});
  expect_refused(file({std::string(3000, 'x')}), {"requires xxx", "..."});
  expect_refused(file({1}), {"extensionsRequired"});
  expect_refused(file("KHR_mesh_quantization"), {"/extensionsRequired: has the type string"});
  // An extension that is only used is left out with a note.
  maker.json["extensionsUsed"] = {"ACME_folded"};
  maker.json["nodes"][0]["extensions"] = {{"ACME_folded", {{"by", 2}}}};
  const Model model = read_model(file(Gltf::array()));
  ASSERT_EQ(model.notes.size(), 1u);
  EXPECT_EQ(in_english(model.notes[0]), "left out: the extension ACME_folded");
}

TEST_F(GltfFiles, NamesThePlaceOfWrongTypes) {
  const std::pair<const char*, const char*> wrong[] = {
      {"/meshes", "7"},
      {"/meshes", "{\"a\":{}}"},
      {"/meshes/0", "[]"},
      {"/meshes/0/primitives", "{}"},
      {"/meshes/0/primitives/0", "null"},
      {"/meshes/0/primitives/0/attributes", "[0]"},
      {"/meshes/0/primitives/0/targets", "1"},
      {"/meshes/0/primitives/0/extensions", "\"x\""},
      {"/nodes", "\"x\""},
      {"/nodes/0/children", "1"},
      {"/nodes/0/extensions", "[]"},
      {"/scenes/0/nodes", "true"},
      {"/accessors", "[1]"},
      {"/bufferViews/0", "7"},
      {"/buffers", "{}"},
      {"/images", "[[]]"},
      {"/materials", "0"}};
  for (const auto& [place, value] : wrong) {
    Gltf json = Gltf::parse(cube().text(kCubeUri));
    json[Gltf::json_pointer(place)] = Gltf::parse(value);
    expect_refused(write("m.gltf", json.dump()), {"has the type", "; accepted: "});
  }
  expect_refused(write("m.gltf", "{\"asset\":7}"), {"glTF version unknown; accepted: 2"});
  expect_refused(write("m.gltf", "{\"asset\":{\"version\":\"3.0\"}}"),
                 {"version 3.0; accepted: 2"});
}

// Most of these ran into the time limit, or into the end of the stack.
TEST_F(GltfFiles, RefusesHostileJson) {
  const auto many = [](const std::string& text, int count) {
    std::string out;
    for (int i = 0; i < count; ++i) out += text;
    return out;
  };
  std::string keys;
  for (int i = 0; i < 100'000; ++i) keys += "\"k" + std::to_string(i) + "\":0,";
  const std::string rest = cube().text(kCubeUri).substr(1);
  expect_cube(write("keys.gltf", "{" + keys + rest));
  expect_cube(write("objects.gltf", "{\"extras\":[" + many("{},", 100'000) + "0]," + rest));
  expect_refused(write("deep.gltf", "{\"extras\":" + many("[", 200'000)), {"nested too deep"});
  expect_refused(
      write("deep.glb", GltfMaker::container(GltfMaker::chunk("JSON", many("{\"a\":", 200'000)))),
      {"nested too deep"});
  expect_refused(write("twice.gltf", "{\"nodes\":[]," + rest), {"/nodes: this key comes twice"});
}

}  // namespace
}  // namespace trivet
