#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>

#include "core/base/error.h"
#include "core/scene/materials.h"
#include "ops/files/json/operations.h"
#include "ops/files/json/text.h"
#include "ops/files/layout/layout.h"
#include "support/json_corpus.h"

namespace trivet {
namespace {

using nlohmann::json;

json read_corpus() { return test::read_corpus("tests/ops/files/layout/corpus.json"); }

/// The reader's error message; empty if there is none.
std::string complaint(const std::string& text) { return test::complaint(parse_layout, text); }

TEST(Layout, ReadsCorpus) {
  const auto [num_good, num_bad] = test::expect_corpus(read_corpus(), parse_layout);
  EXPECT_GE(num_good, 15);
  EXPECT_GE(num_bad, 60);
}

TEST(Layout, KeepsValues) {
  const Layout layout = parse_layout(read_corpus()["base"].dump(), "a.json");
  EXPECT_TRUE(layout.floor);
  ASSERT_EQ(layout.objects.size(), 2u);
  const LayoutObject& table = layout.objects[0];
  EXPECT_EQ(table.name, "table");
  EXPECT_EQ(table.model, "table.obj");
  EXPECT_EQ(table.scale, 0.5);
  EXPECT_EQ(table.up, UpAxis::Y);
  EXPECT_TRUE(table.fixed);
  ASSERT_TRUE(table.pose);
  const LayoutObject& spoon = layout.objects[1];
  EXPECT_FALSE(spoon.scale);
  EXPECT_FALSE(spoon.up);
  EXPECT_FALSE(spoon.fixed);
  EXPECT_FALSE(spoon.pose);
  ASSERT_EQ(layout.operations.size(), 1u);
  const auto& put = std::get<PutOperation>(layout.operations[0]);
  EXPECT_EQ(put.object, "spoon");
  EXPECT_FALSE(put.settle_left);
  EXPECT_EQ(put.start.translation, Vec3(0.1, 0.2, 1.5));
  EXPECT_EQ(put.start.rotation.w, 1);
}

TEST(Layout, NormalisesQuaternions) {
  json base = read_corpus()["base"];
  base["operations"][0]["rotation"] = {2, 0, 0, -2};
  const Layout layout = parse_layout(base.dump(), "a.json");
  const Rotation r = std::get<PutOperation>(layout.operations[0]).start.rotation;
  EXPECT_NEAR(r.w, std::sqrt(0.5), 1e-15);
  EXPECT_NEAR(r.z, -std::sqrt(0.5), 1e-15);
}

TEST(Layout, RoundTripsToSameBits) {
  std::mt19937_64 rng(1);
  std::normal_distribution<double> normal;
  Layout layout;
  layout.floor = false;
  for (int i = 0; i < 1000; ++i) {
    LayoutObject o;
    o.name = std::to_string(i) + "_o", o.model = "m.obj", o.fixed = i % 3 == 0;
    o.scale = std::exp(normal(rng));
    if (i % 2) o.up = i % 4 == 1 ? UpAxis::Y : UpAxis::Z;
    const Rotation r = Rotation{normal(rng), normal(rng), normal(rng), normal(rng)}.normalized();
    const Pose pose{r, {normal(rng), normal(rng), normal(rng)}};
    if (i % 5) o.pose = pose;
    layout.objects.push_back(o);
    layout.operations.push_back(PutOperation{{o.name}, pose});
  }
  const std::string text = write_layout(layout);
  const Layout back = parse_layout(text, "a.json");
  EXPECT_EQ(write_layout(back), text);
  for (int i = 0; i < 1000; ++i) {
    const Pose& a = std::get<PutOperation>(layout.operations[i]).start;
    const Pose& b = std::get<PutOperation>(back.operations[i]).start;
    EXPECT_EQ(a.translation, b.translation);
    EXPECT_TRUE(a.rotation.w == b.rotation.w && a.rotation.x == b.rotation.x);
    EXPECT_TRUE(a.rotation.y == b.rotation.y && a.rotation.z == b.rotation.z);
    EXPECT_EQ(layout.objects[i].pose.has_value(), back.objects[i].pose.has_value());
    EXPECT_EQ(layout.objects[i].up, back.objects[i].up);
  }
}

// Every option differs from its default; some need all digits for their bits.
constexpr const char* kAllOperations[] = {
    R"({"op":"put","object":"a","position":[0.1,-0.3333333333333333,1e-07],)"
    R"("rotation":[0.0,1.0,0.0,0.0],"settle_left":true})",
    R"({"op":"push","object":"a","direction":[1.0,0.3333333333333333],"distance":0.1,)"
    R"("step_up":0.02,"step_down":0.03,"slide":false,"settle":false,"together":["b"],"settle_left":true})",
    R"({"op":"push","object":"a","to":[0.1,0.3333333333333333]})",
    R"({"op":"turn","object":"a","about":"normal","with":"floor","centre":[0.1,0.2,0.3],)"
    R"("angle_deg":0.3333333333333333,"settle":true})",
    R"({"op":"turn","object":"a","about":"line","with":"b","point":[0.1,0.2,0.3],)"
    R"("axis":[0.1,0.2,0.3],"angle_deg":-30.0})",
    R"({"op":"turn","object":"a","about":"point","point":[0.1,0.2,0.3],"axis":[0.1,0.2,0.3],)"
    R"("angle_deg":0.1,"settle":true,"together":["b","c"],"settle_left":true})",
    R"({"op":"pick_up","object":"a","distance":0.1,"with":"b","together":["c"],"settle_left":true})",
    R"({"op":"translate","object":"a","by":[0.1,0.2,0.3],"free":true,"settle":true,)"
    R"("together":["b"],"settle_left":true})",
    R"({"op":"rotate","object":"a","axis":[0.1,0.2,0.3],"angle_deg":0.1,"centre":[0.1,0.2,0.3],)"
    R"("free":true,"settle":true,"together":["b"],"settle_left":true})",
    R"({"op":"append","object":"a","model":"m.obj","scale":0.3333333333333333,"up":"y",)"
    R"("fixed":true})",
    R"({"op":"append","object":"a","model":"m.obj"})",
    R"({"op":"append","object":"a","model":"m.obj","material":"wood"})",
    R"({"op":"material","object":"a","material":"rubber"})",
    R"({"op":"material","object":"a",)"
    R"("material":{"friction":0.3333333333333333,"density":700.5,"restitution":0.1}})",
    R"({"op":"duplicate","object":"a","as":"b"})",
    R"({"op":"rename","object":"a","to":"b"})",
    R"({"op":"delete","object":"a","settle_left":true})",
    R"({"op":"lock","object":"a"})",
    R"({"op":"unlock","object":"a"})",
    R"({"op":"fix","object":"a"})",
    R"({"op":"unfix","object":"a"})",
    R"({"op":"group","object":"a","group":"set"})",
    R"({"op":"ungroup","object":"a"})",
    R"({"op":"push","object":"a","to":[0.1,-0.2],"normal":[0.0,-1.0,0.5],"slide":false})"};

TEST(Layout, RoundTripsOperationsToSameBits) {
  for (const char* text : kAllOperations) {
    const json document = parse_json(text, "a.json");
    EXPECT_EQ(operation_json(read_operation(JsonPlace(document, "a.json"))).dump(), text);
  }
  const json document = parse_json(kAllOperations[1], "a.json");
  const auto push = std::get<PushOperation>(read_operation(JsonPlace(document, "a.json")));
  EXPECT_EQ(push.direction, Vec2(1, 0.3333333333333333));
  EXPECT_EQ(push.distance, 0.1);
  EXPECT_EQ(push.step_up, 0.02);
  EXPECT_EQ(push.step_down, 0.03);
  EXPECT_FALSE(push.slide || push.settle);
  EXPECT_TRUE(push.settle_left);
}

TEST(Layout, GivesMaterials) {
  json base = read_corpus()["base"];
  base["material"] = {{"friction", 0.7}};
  base["objects"][1]["material"] = "steel";
  const Layout layout = parse_layout(base.dump(), "a.json");
  EXPECT_EQ(layout.material.friction, 0.7);
  EXPECT_EQ(layout.material.density, PhysicsMaterial().density);
  EXPECT_FALSE(layout.floor_material || layout.objects[0].material);
  ASSERT_TRUE(layout.objects[1].material);
  EXPECT_TRUE(same_material(*layout.objects[1].material, *material_preset("steel")));
  EXPECT_EQ(write_layout(parse_layout(write_layout(layout), "a.json")), write_layout(layout));
}

TEST(Layout, SchemaListsAllPresets) {
  std::ifstream file(TRIVET_SOURCE_DIR "/ops/files/layout/layout.schema.in.json");
  const json schema = json::parse(file);
  EXPECT_EQ(schema["$defs"]["material"]["oneOf"][0]["enum"], json(material_names()));
}

TEST(Layout, TruncatesLongValuesInMessages) {
  json base = read_corpus()["base"];
  base["objects"][1]["up"] = std::string(100'000, 'u');
  EXPECT_LT(complaint(base.dump()).size(), 200u);
}

TEST(Layout, SurvivesRandomBytesAndCuts) {
  std::mt19937_64 rng(2);
  const std::string good = read_corpus()["base"].dump();
  int num_refused = 0;
  for (int i = 0; i < 5000; ++i) {
    std::string text = good;
    for (int k = 0; k < 1 + i % 4; ++k) text[rng() % text.size()] = static_cast<char>(rng());
    if (i % 3 == 0) text.resize(rng() % text.size());
    num_refused += !complaint(text).empty();
  }
  EXPECT_GT(num_refused, 4000);
}

TEST(Layout, ReportsDeepNesting) {
  EXPECT_NE(complaint(std::string(1'000'000, '[')), "");
  EXPECT_NE(complaint(std::string(100'000, '[') + std::string(100'000, ']')), "");
}

TEST(ReadTextFile, NamesErrors) {
  const auto message = [](const std::string& path, std::uintmax_t limit) -> std::string {
    try {
      read_text_file(path, limit);
    } catch (const Error& e) {
      return e.what();
    }
    return "";
  };
  const std::string folder = testing::TempDir();
  EXPECT_EQ(message(folder + "none.json", 10),
            folder + "none.json: cannot be opened: No such file or directory");
  EXPECT_EQ(message(folder, 10), folder + ": is a folder, not a file");
  const std::string path = folder + "trivet_ten_bytes.json";
  std::ofstream(path) << "0123456789";
  EXPECT_EQ(message(path, 10), "");
  EXPECT_EQ(message(path, 9), path + ": is larger than the limit of 9 bytes");
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace trivet
