#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "ops/files/report/model_info.h"
#include "ops/layout/boxes.h"

namespace trivet {
namespace {

Topology topology_of(const Mesh& mesh) { return topology(make_adjacency(mesh)); }

TEST(ModelInfo, CallsBoxClosedOrientedAndManifold) {
  const Topology t = topology_of(box_model(1, 1, 1).mesh);
  EXPECT_TRUE(t.closed && t.oriented && t.manifold);
  EXPECT_EQ(t.num_edges, 18);
  EXPECT_EQ(t.boundary_edges + t.non_manifold_edges + t.flipped_edges, 0);
}

TEST(ModelInfo, CallsBoxWithMissingFaceOpen) {
  Mesh mesh = box_model(1, 1, 1).mesh;
  mesh.triangles.pop_back();
  const Topology t = topology_of(mesh);
  EXPECT_FALSE(t.closed);
  EXPECT_TRUE(t.oriented && t.manifold);
  EXPECT_EQ(t.boundary_edges, 3);
}

TEST(ModelInfo, DetectsFlippedFace) {
  Mesh mesh = box_model(1, 1, 1).mesh;
  std::swap(mesh.triangles[0][0], mesh.triangles[0][1]);
  const Topology t = topology_of(mesh);
  EXPECT_TRUE(t.closed && t.manifold);
  EXPECT_FALSE(t.oriented);
  EXPECT_EQ(t.flipped_edges, 3);
}

TEST(ModelInfo, CallsFinNonManifold) {
  Mesh mesh = box_model(1, 1, 1).mesh;
  const Index3 first = mesh.triangles[0];
  mesh.vertices.emplace_back(5, 5, 5);
  mesh.triangles.push_back({first[0], first[1], static_cast<Index>(mesh.vertices.size() - 1)});
  const Topology t = topology_of(mesh);
  EXPECT_FALSE(t.closed || t.manifold);
  EXPECT_EQ(t.non_manifold_edges, 1);
  EXPECT_EQ(t.boundary_edges, 2);
}

TEST(ModelInfo, GuessesTheUnitBySize) {
  const auto unit = [](double half) {
    return std::string(likely_unit(box_model(half, 1e-3, 1e-3).mesh.box()));
  };
  EXPECT_EQ(unit(0.05), "m");
  EXPECT_EQ(unit(1.5), "m");
  EXPECT_EQ(unit(117.5), "cm");
  EXPECT_EQ(unit(600), "mm");
  Model model = box_model(117.5, 50, 37);
  const auto shape = make_shape(model.mesh);
  EXPECT_NE(model_info_text(model, *shape).find("likely cm"), std::string::npos);
  EXPECT_EQ(nlohmann::json::parse(model_info_json(model, *shape))["likely_unit"], "cm");
  model.metres_per_unit = 0.001;
  EXPECT_TRUE(nlohmann::json::parse(model_info_json(model, *shape))["likely_unit"].is_null());
}

TEST(ModelInfo, PrintsSameAsTextAndJson) {
  Model model = box_model(0.5, 1, 1.5);
  model.path = "box.obj";
  model.notes.push_back("lines left out: 3");
  const auto shape = make_shape(model.mesh);
  const auto json = nlohmann::json::parse(model_info_json(model, *shape));
  EXPECT_EQ(json["triangles"], 12);
  EXPECT_EQ(json["vertices"], 8);
  EXPECT_EQ(json["components"], 1);
  EXPECT_EQ(json["size"], nlohmann::json({1.0, 2.0, 3.0}));
  EXPECT_EQ(json["mass_rule"], "volume");
  EXPECT_NEAR(json["volume"], 6, 1e-12);
  EXPECT_TRUE(json["metres_per_unit"].is_null());
  const std::string text = model_info_text(model, *shape);
  for (const char* part : {"box.obj", "triangles   12, vertices 8, components 1", "1 2 3",
                           "closed      yes", "by volume", "lines left out: 3"})
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
}

}  // namespace
}  // namespace trivet
