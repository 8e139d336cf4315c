#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/scene/transaction.h"
#include "ops/files/layout/boxes.h"
#include "ops/files/report/report.h"

namespace trivet {
namespace {

using Json = nlohmann::ordered_json;

std::vector<std::string> keys(const Json& object) {
  std::vector<std::string> out;
  for (const auto& [key, value] : object.items()) out.push_back(key);
  return out;
}

LayoutRun run_boxes(int num_threads = 0) {
  const Layout layout = parse_layout(R"({"trivet": 1, "objects": [
      {"name": "slab", "model": "slab.obj", "fixed": true, "position": [0.1, 0.2, 0.050001]},
      {"name": "a", "model": "cube.obj"}, {"name": "b", "model": "cube.obj"},
      {"name": "out", "model": "cube.obj"}],
    "operations": [
      {"op": "put", "object": "a", "position": [0.1, 0.2, 1], "rotation": [1, 0.1, 0.2, 0.3]},
      {"op": "put", "object": "b", "position": [0.13, 0.2, 1], "rotation": [3, 1, 0, 2]},
      {"op": "put", "object": "out", "position": [0.1, 0.2, 0.05]}]})",
                                     "a.json");
  const ModelSource source = [](const std::string& name, const Tessellation&) {
    return name == "slab.obj" ? box_model(0.5, 0.5, 0.05) : box_model(0.05, 0.05, 0.05);
  };
  RunOptions options;
  options.num_threads = num_threads;
  return run_layout(layout, source, options);
}

TEST(Report, HasKeysInDocumentedOrder) {
  ReportOptions options;
  options.version = "1.2.3";
  const Json report = Json::parse(report_json(run_boxes(), options));
  EXPECT_EQ(keys(report),
            (std::vector<std::string>{"trivet", "version", "backend", "device", "gpu_method",
                                      "gpu_lists", "confirmation", "settle", "objects",
                                      "operations", "check", "stability"}));
  EXPECT_EQ(keys(report["settle"]),
            (std::vector<std::string>{"perfect_friction", "whole_at_rest", "literal_paper_rules"}));
  EXPECT_EQ(report["trivet"], 1);
  EXPECT_EQ(report["version"], "1.2.3");
  ASSERT_EQ(report["objects"].size(), 4u);
  for (const Json& object : report["objects"])
    EXPECT_EQ(keys(object), (std::vector<std::string>{
                                "name", "model", "triangles", "world_from_file", "centre_of_mass",
                                "mass_rule", "material", "kilograms", "state", "supported_by",
                                "contacts", "stability_margin", "least_friction"}));
  for (const Json& contact : report["objects"][1]["contacts"])
    EXPECT_EQ(keys(contact), (std::vector<std::string>{"with", "type", "points", "normal", "gap"}));
  ASSERT_EQ(report["operations"].size(), 3u);
  for (const Json& operation : report["operations"]) {
    const bool ok = operation["status"] == "ok";
    std::vector<std::string> expected{"op", "object", "status", "reason"};
    if (!ok) expected.insert(expected.end(), {"cause", "objects", "numbers"});
    expected.insert(expected.end(), {"motions", "milliseconds"});
    if (ok) expected.insert(expected.end(), {"ended", "moved"});
    EXPECT_EQ(keys(operation), expected);
  }
  EXPECT_EQ(keys(report["check"]),
            (std::vector<std::string>{"interpenetrating_pairs", "pairs_passing_through",
                                      "pairs_touching", "pairs_apart", "smallest_gap",
                                      "all_at_rest", "pairs", "not_at_rest", "hovering"}));
}

TEST(Report, StatesOutcomeOfEachObject) {
  const Json report = Json::parse(report_json(run_boxes(), {}));
  const Json &slab = report["objects"][0], &a = report["objects"][1], &out = report["objects"][3];
  EXPECT_EQ(slab["state"], "fixed");
  EXPECT_EQ(slab["supported_by"], Json::array({"floor"}));
  EXPECT_TRUE(slab["stability_margin"].is_null());
  EXPECT_EQ(a["state"], "stable");
  EXPECT_EQ(a["supported_by"], Json::array({"slab"}));
  EXPECT_EQ(a["contacts"][0]["with"], "slab");
  EXPECT_EQ(a["contacts"][0]["type"], "area");
  EXPECT_GT(a["stability_margin"], 0.01);
  EXPECT_EQ(out["state"], "unplaced");
  EXPECT_TRUE(out["world_from_file"].is_null());
  EXPECT_TRUE(out["centre_of_mass"].is_null());
  EXPECT_EQ(out["contacts"], Json::array());
  EXPECT_EQ(report["operations"][2]["status"], "refused");
  EXPECT_NE(report["operations"][2]["reason"], "");
  EXPECT_EQ(report["check"]["interpenetrating_pairs"], 0);
  EXPECT_EQ(report["check"]["all_at_rest"], true);
}

TEST(Report, RoundTripsNumbersBitwise) {
  const LayoutRun run = run_boxes();
  const Json report = Json::parse(report_json(run, {}));
  int num_checked = 0;
  for (size_t i = 0; i < 3; ++i) {
    const Object& object = run.scene.at(run.scene.ids()[i]);
    const Affine world_from_file = object.world_from_object();
    const Json& m = report["objects"][i]["world_from_file"];
    ASSERT_EQ(m.size(), 16u);
    for (int r = 0; r < 3; ++r) {
      for (int c = 0; c < 3; ++c) EXPECT_EQ(m[4 * r + c], world_from_file.linear(r, c));
      EXPECT_EQ(m[4 * r + 3], world_from_file.translation[r]);
      EXPECT_EQ(report["objects"][i]["centre_of_mass"][r], object.centre_of_mass()[r]);
    }
    EXPECT_EQ(m[15], 1.0);
    for (const ObjectContact& entry : object.contacts) num_checked += entry.contact.points.size();
  }
  EXPECT_GT(num_checked, 8);
}

TEST(Report, WritesNonFiniteNumbersAsNull) {
  LayoutRun run = run_boxes();
  run.check.smallest_gap = kInfinity;
  edit_object(run.scene, run.scene.ids()[1], [](Object& o) { o.least_friction = kInfinity; });
  const Json report = Json::parse(report_json(run, {}));
  EXPECT_TRUE(report["check"]["smallest_gap"].is_null());
  EXPECT_TRUE(report["objects"][1]["least_friction"].is_null());
}

std::string without_times(const std::string& report) {
  Json json = Json::parse(report);
  for (Json& operation : json["operations"]) operation.erase("milliseconds");
  return json.dump();
}

TEST(Report, DoesNotDependOnThreads) {
  const std::string expected = without_times(report_json(run_boxes(1), {}));
  for (const int num_threads : {2, 8})
    EXPECT_EQ(without_times(report_json(run_boxes(num_threads), {})), expected);
}

TEST(Report, NamesInterpenetratingPairs) {
  LayoutRun run = run_boxes();
  run.check.crossings.push_back({"a", "b", 7});
  run.check.contained.push_back({"b", "slab", 1});
  run.check.not_at_rest.push_back("b");
  const Json check = Json::parse(report_json(run, {}))["check"];
  EXPECT_EQ(check["pairs"][0],
            Json::parse(R"({"a": "a", "b": "b", "kind": "crossing", "count": 7, "depth": 0.0,
                            "point": [0.0, 0.0, 0.0]})"));
  EXPECT_EQ(check["pairs"][1]["kind"], "contained");
  EXPECT_EQ(check["all_at_rest"], false);
  EXPECT_EQ(check["not_at_rest"], Json::array({"b"}));
}

TEST(Report, JoinsPaths) {
  EXPECT_EQ(joined_path("", "a/../b.obj"), "a/../b.obj");
  EXPECT_EQ(joined_path("..", "models/b.obj"), "../models/b.obj");
  EXPECT_EQ(joined_path("x", "../b.obj"), "b.obj");
  EXPECT_EQ(joined_path("x", "/m/b.obj"), "/m/b.obj");
}

}  // namespace
}  // namespace trivet
