#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <random>

#include "core/base/error.h"
#include "core/io/atomic_file.h"
#include "core/io/export.h"
#include "core/io/gltf/glb_container.h"
#include "core/io/read_model.h"
#include "ops/files/layout/boxes.h"
#include "ops/files/report/extras.h"
#include "ops/files/report/geometry.h"
#include "ops/files/report/report.h"
#include "ops/files/report/scene_file.h"

namespace trivet {
namespace {

namespace fs = std::filesystem;

/// Provides a folder per test.
class SceneFileTest : public testing::Test {
 protected:
  SceneFileTest() {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    m_folder = fs::path(testing::TempDir()) / (std::to_string(getpid()) + "_" + info->name());
    fs::create_directories(m_folder);
  }
  ~SceneFileTest() override { fs::remove_all(m_folder); }

  std::string file(const std::string& name) const { return (m_folder / name).string(); }

  /// Writes a model file: a box with its faces in both materials, under this transform of its node.
  void write_model(const std::string& name, const Vec3& half, const Affine& transform) const {
    ExportScene scene;
    const auto model = std::make_shared<const Model>(box_model(half.x(), half.y(), half.z()));
    scene.objects.push_back({"box", model, transform, ""});
    write_scene(scene, file(name));
  }

  LayoutRun run(const std::string& layout) const {
    return run_layout(parse_layout(layout, "a.json"), models_in_folder(m_folder.string()), {});
  }

  std::string m_layout = R"({"trivet": 1, "objects": [
      {"name": "slab", "model": "slab.glb", "fixed": true, "position": [0.1, 0.2, 0.050001]},
      {"name": "a", "model": "cube.glb", "scale": 0.7},
      {"name": "b", "model": "cube.glb", "up": "z"},
      {"name": "out", "model": "other.glb"}],
    "operations": [
      {"op": "put", "object": "a", "position": [0.1, 0.2, 1], "rotation": [1, 0.1, 0.2, 0.3]},
      {"op": "put", "object": "b", "position": [0.13, 0.2, 1], "rotation": [3, 1, 0, 2]}]})";

  /// A transform whose products with float32 positions are not float32.
  Affine turned() const {
    Affine transform;
    transform.linear = Rotation::about_axis(Vec3(1, 2, 3).normalized(), 0.3).matrix();
    return transform;
  }

  void write_models(const Affine& transform) const {
    write_model("slab.glb", Vec3(0.5, 0.5, 0.05), Affine());
    write_model("cube.glb", Vec3(0.05, 0.05, 0.05), transform);
    write_model("other.glb", Vec3(0.1, 0.1, 0.1), Affine());
  }

  LayoutRun write_boxes(const Affine& transform) const {
    write_models(transform);
    LayoutRun made = run(m_layout);
    EXPECT_TRUE(made.ok());
    write_scene_file(made.scene, parse_layout(m_layout, "a.json"), {"1.0", "", 0},
                     file("scene.glb"));
    return made;
  }

  std::string complaint(const std::string& path) const {
    try {
      read_scene_file(path);
    } catch (const Error& e) {
      EXPECT_EQ(e.kind(), Error::Kind::BadInput) << e.what();
      return e.what();
    }
    return "";
  }

  fs::path m_folder;
};

/// The report of a scene without the history of operations.
std::string state_of(Scene scene) {
  LayoutRun run;
  run.scene = std::move(scene);
  finish_run({}, run);
  return report_json(run, {});
}

TEST_F(SceneFileTest, RoundTripsBitwiseWithoutModels) {
  const LayoutRun made = write_boxes(Affine());
  for (const char* model : {"slab.glb", "cube.glb"}) fs::remove(file(model));
  const SceneFile back = read_scene_file(file("scene.glb"));
  EXPECT_TRUE(back.notes.empty());
  EXPECT_EQ(state_of(back.scene), state_of(made.scene));
  Layout layout = parse_layout(m_layout, "a.json");
  layout.settle = rules_of({});
  EXPECT_EQ(write_layout(back.layout), write_layout(layout));
  const Object &a = back.scene.at(*back.scene.find("a")), &b = back.scene.at(*back.scene.find("b"));
  EXPECT_EQ(a.model, b.model);
  EXPECT_EQ(a.shape, b.shape);
  EXPECT_FALSE(back.scene.at(*back.scene.find("out")).placed);
}

TEST_F(SceneFileTest, KeepsPhysicsMaterials) {
  m_layout.replace(m_layout.find("\"objects\""), 0,
                   R"("material": {"friction": 0.3333333333333333}, "floor_material": "stone", )");
  m_layout.replace(m_layout.find("\"scale\": 0.7"), 0, R"("material": "wood", )");
  const LayoutRun made = write_boxes(Affine());
  const SceneFile back = read_scene_file(file("scene.glb"));
  EXPECT_EQ(state_of(back.scene), state_of(made.scene));
  const auto material = [&](const char* name) {
    return back.scene.at(*back.scene.find(name)).material;
  };
  EXPECT_EQ(material("a").name, "wood");
  EXPECT_EQ(material("a").density, 700);
  EXPECT_EQ(material("out").friction, 0.3333333333333333);
  EXPECT_EQ(back.scene.floor_material.name, "stone");
}

// A .glb groups faces by material; here they alternate.
TEST_F(SceneFileTest, RoundTripsAppearanceAndOrderOfFaces) {
  m_layout = R"({"trivet": 1, "objects": [{"name": "a", "model": "cube.obj"}],
    "operations": [{"op": "put", "object": "a", "position": [0, 0, 1], "rotation": [3, 1, 0, 2]}]})";
  const Layout layout = parse_layout(m_layout, "a.json");
  const LayoutRun made = run_layout(
      layout,
      [](const std::string&, const Tessellation&) { return box_model(0.25, 0.125, 0.0625); }, {});
  ASSERT_TRUE(made.ok());
  write_scene_file(made.scene, layout, {}, file("scene.glb"));

  const SceneFile back = read_scene_file(file("scene.glb"));
  EXPECT_EQ(state_of(back.scene), state_of(made.scene));
  const Model &model = *back.scene.at(*back.scene.find("a")).model, expected = box_model(1, 1, 1);
  ASSERT_EQ(model.face_material.size(), 12u);
  for (Index f = 0; f < 12; ++f) {
    const Material& material = model.materials[model.face_material[f]];
    const Material& made_of = expected.materials[expected.face_material[f]];
    EXPECT_EQ(material.name, made_of.name) << f;
    EXPECT_EQ(material.base_colour, made_of.base_colour) << f;
  }
}

// The model's own nodes are kept below the object's: no rounding, and no model file is needed.
TEST_F(SceneFileTest, RoundTripsGeometryUnderTurnedNodesBitwise) {
  const LayoutRun made = write_boxes(turned());
  const SceneFile back = read_scene_file(file("scene.glb"));
  EXPECT_TRUE(back.notes.empty());
  EXPECT_EQ(state_of(back.scene), state_of(made.scene));

  fs::remove(file("cube.glb"));
  const SceneFile alone = read_scene_file(file("scene.glb"));
  EXPECT_TRUE(alone.notes.empty());
  EXPECT_EQ(state_of(alone.scene), state_of(made.scene));
}

TEST_F(SceneFileTest, ReportsRoundedGeometryWhenModelIsGone) {
  m_layout = R"({"trivet": 1, "objects": [{"name": "a", "model": "cube.glb"}],
    "operations": [{"op": "put", "object": "a", "position": [0, 0, 1]}]})";
  const Layout layout = parse_layout(m_layout, "a.json");
  const LayoutRun made = run_layout(
      layout, [](const std::string&, const Tessellation&) { return box_model(0.1, 0.2, 1.0 / 3); },
      {});
  ASSERT_TRUE(made.ok());
  write_scene_file(made.scene, layout, {}, file("scene.glb"));
  const SceneFile rounded = read_scene_file(file("scene.glb"));
  ASSERT_EQ(rounded.notes.size(), 1u);
  EXPECT_NE(in_english(rounded.notes[0]).find("\"cube.glb\""), std::string::npos);
  EXPECT_NE(in_english(rounded.notes[0]).find("float32"), std::string::npos);
  EXPECT_EQ(check_scene(rounded.scene).interpenetrating_pairs(), 0);
}

TEST_F(SceneFileTest, IgnoresChangedModelFile) {
  write_boxes(turned());
  write_model("cube.glb", Vec3(0.06, 0.05, 0.05), turned());
  const SceneFile back = read_scene_file(file("scene.glb"));
  EXPECT_TRUE(back.notes.empty());
  EXPECT_NEAR(back.scene.at(*back.scene.find("a")).shape->mass.volume, 1e-3, 1e-8);
}

TEST_F(SceneFileTest, OmitsUnplacedObjectWhoseModelIsGone) {
  write_boxes(Affine());
  fs::remove(file("other.glb"));
  const SceneFile back = read_scene_file(file("scene.glb"));
  EXPECT_FALSE(back.scene.find("out"));
  ASSERT_EQ(back.notes.size(), 1u);
  EXPECT_NE(in_english(back.notes[0]).find("\"out\""), std::string::npos);
}

TEST_F(SceneFileTest, RoundTripsFarModelBitwise) {
  Affine far;
  far.translation = Vec3(1000, -2000, 500);
  write_models(far);
  m_layout = R"({"trivet": 1, "floor": false, "objects": [
      {"name": "a", "model": "cube.glb", "fixed": true, "position": [0, 0, 0]}]})";
  const LayoutRun made = run(m_layout);
  write_scene_file(made.scene, parse_layout(m_layout, "a.json"), {}, file("scene.glb"));
  const SceneFile back = read_scene_file(file("scene.glb"));
  EXPECT_EQ(state_of(back.scene), state_of(made.scene));
}

/// The same scene file after an edit of its JSON.
void edit(const std::string& path, const std::function<void(nlohmann::json&)>& change) {
  const std::string text = read_glb_json(path);
  std::ifstream in(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  nlohmann::json json = nlohmann::json::parse(text);
  change(json);
  write_file_atomically(path, pack_glb(json.dump(), bytes.substr(20 + text.size() + 8)));
}

/// The node of an object, among the scene's own; the model's nodes are below it.
nlohmann::json& node_of(nlohmann::json& j, const std::string& name) {
  for (const size_t root : j["scenes"][0]["nodes"])
    if (j["nodes"][root]["name"] == name) return j["nodes"][root];
  throw std::runtime_error("no such node: " + name);
}

TEST_F(SceneFileTest, RefusesChangesByOtherPrograms) {
  const auto expect = [&](const std::function<void(nlohmann::json&)>& change,
                          const std::string& what) {
    write_boxes(Affine());
    edit(file("scene.glb"), change);
    const std::string message = complaint(file("scene.glb"));
    EXPECT_NE(message.find(what), std::string::npos) << message;
  };
  expect([](nlohmann::json&) {}, "");
  EXPECT_EQ(complaint(file("scene.glb")), "");
  expect([](nlohmann::json& j) { node_of(j, "a")["matrix"][12] = 0.5; }, "\"a\" was moved");
  expect([](nlohmann::json& j) { node_of(j, "a")["name"] = "cup"; }, "has no mesh for \"a\"");
  expect([](nlohmann::json& j) { node_of(j, "a")["mesh"] = 0; }, "another program has changed it");
  expect([](nlohmann::json& j) { j["nodes"].erase(2); }, "scene.glb");
  expect([](nlohmann::json& j) { j["scenes"][0].erase("extras"); }, "has no data of Trivet");
  expect([](nlohmann::json& j) { j["scenes"][0]["extras"]["trivet"]["trivet"] = 7; },
         "/trivet/trivet: 7 is not accepted; accepted: 1");
  expect([](nlohmann::json& j) { j["scenes"][0]["extras"]["trivet"]["objects"][1]["model"] = 9; },
         "/trivet/objects/1/model: 9 is not accepted");
  expect([](nlohmann::json& j) { j["scenes"][0]["extras"]["trivet"]["objects"][1]["name"] = "b"; },
         "\"b\"");
}

TEST_F(SceneFileTest, RefusesOtherFiles) {
  EXPECT_NE(complaint(file("none.glb")), "");
  EXPECT_NE(complaint(m_folder.string()), "");
  std::ofstream(file("text.glb")) << "no glTF at all, but long enough to have a header";
  EXPECT_NE(complaint(file("text.glb")), "");
  write_models(Affine());
  EXPECT_NE(complaint(file("cube.glb")).find("has no data of Trivet"), std::string::npos);
  EXPECT_FALSE(is_scene_file(file("cube.glb")));
}

TEST_F(SceneFileTest, SurvivesBrokenFiles) {
  write_boxes(Affine());
  std::ifstream in(file("scene.glb"), std::ios::binary);
  const std::string good{std::istreambuf_iterator<char>(in), {}};
  std::mt19937_64 rng(3);
  int num_refused = 0;
  for (int i = 0; i < 300; ++i) {
    std::string bytes = good;
    for (int k = 0; k < 1 + i % 5; ++k) bytes[rng() % bytes.size()] = static_cast<char>(rng());
    if (i % 3 == 0) bytes.resize(rng() % bytes.size());
    std::ofstream(file("broken.glb"), std::ios::binary) << bytes;
    num_refused += !complaint(file("broken.glb")).empty();
  }
  EXPECT_GE(num_refused, 150);  // a changed byte of a name or a normal is harmless
}

TEST_F(SceneFileTest, WritesGeometryInOtherFormats) {
  write_boxes(Affine());
  const SceneFile back = read_scene_file(file("scene.glb"));
  for (const char* name : {"scene.obj", "scene.ply", "scene.stl"}) {
    write_scene_file(back.scene, back.layout, {}, file(name));
    EXPECT_EQ(read_model(file(name)).mesh.triangles.size(), 36u) << name;
  }
}

TEST(Geometry, FingerprintDependsOnEveryBitAndOrder) {
  const Mesh mesh = box_model(1, 2, 3).mesh;
  const std::string fingerprint = geometry_fingerprint(mesh);
  Mesh other = mesh;
  other.vertices[3].y() = std::nextafter(other.vertices[3].y(), 10.0);
  EXPECT_NE(geometry_fingerprint(other), fingerprint);
  other = mesh;
  std::swap(other.triangles[2], other.triangles[3]);
  EXPECT_NE(geometry_fingerprint(other), fingerprint);
  other = mesh;  // different numbering, same triangles
  std::swap(other.vertices[0], other.vertices[1]);
  for (Index3& t : other.triangles)
    for (Index& v : t) v = v < 2 ? 1 - v : v;
  EXPECT_EQ(geometry_fingerprint(other), fingerprint);
}

TEST_F(SceneFileTest, KeepsReserve) {
  Layout layout;
  layout.settle.robust = true;
  EXPECT_EQ(parse_scene_extras(scene_extras({}, layout, {}), "a.glb").layout.settle.robust, true);
}

// Scene files that state no rules are of the time when friction was perfect.
TEST_F(SceneFileTest, KeepsRulesOfSettling) {
  const auto kept = [](const Layout& layout, bool states_rules) {
    auto json = nlohmann::json::parse(scene_extras({}, layout, {}));
    EXPECT_EQ(json["trivet"]["layout"]["settle"].size(), 3u);
    if (!states_rules) json["trivet"]["layout"].erase("settle");
    return parse_scene_extras(json.dump(), "a.glb").layout.settle;
  };
  Layout layout;
  EXPECT_EQ(kept(layout, true).perfect_friction, false);
  EXPECT_EQ(kept(layout, true).whole_at_rest, true);
  layout.settle.perfect_friction = true;
  EXPECT_EQ(kept(layout, true).perfect_friction, true);
  EXPECT_EQ(kept(layout, true).robust, false);
  EXPECT_EQ(kept({}, false).perfect_friction, true);
  EXPECT_EQ(kept({}, false).whole_at_rest, false);
}

}  // namespace
}  // namespace trivet
