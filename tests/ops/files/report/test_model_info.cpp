#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/io/read_model.h"
#include "ops/files/layout/boxes.h"
#include "ops/files/report/model_info.h"

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

Mesh moved(Mesh mesh, const Vec3& by) {
  for (Vec3& v : mesh.vertices) v += by;
  return mesh;
}

// As a model with y up: (x, y, z) to (x, z, -y).
Mesh with_y_up(Mesh mesh) {
  for (Vec3& v : mesh.vertices) v = Vec3(v.x(), v.z(), -v.y());
  return mesh;
}

TEST(ModelInfo, GuessesTheUpAxisByTheFootAndTheOrigin) {
  const Mesh box = box_model(1, 1.5, 2).mesh;
  EXPECT_EQ(likely_up(box), std::nullopt) << "it may stand on any side";
  const Mesh on_floor = moved(box, {0, 0, 2});
  EXPECT_EQ(likely_up(on_floor), UpAxis::Z);
  EXPECT_EQ(likely_up(with_y_up(on_floor)), UpAxis::Y);
  Mesh pyramid;
  pyramid.vertices = {{-1, -1, 5}, {1, -1, 5}, {1, 1, 5}, {-1, 1, 5}, {0, 0, 7}};
  pyramid.triangles = {{0, 2, 1}, {0, 3, 2}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
  EXPECT_EQ(likely_up(pyramid), UpAxis::Z);
  EXPECT_EQ(likely_up(with_y_up(pyramid)), UpAxis::Y);
  EXPECT_EQ(likely_up(Mesh()), std::nullopt);
  Mesh point;
  point.vertices = {{1, 2, 3}};
  EXPECT_EQ(likely_up(point), std::nullopt);
}

constexpr std::uintmax_t kLargestReadBytes = 60000;  // for speed

// Models whose axis is known, in formats that do not say.
TEST(ModelInfo, GuessesTheUpAxisOfMostRealModels) {
  const std::filesystem::path folder = std::filesystem::path(TRIVET_SHARED_DIR) / "data";
  std::ifstream table(folder / "models.csv");
  if (!table) GTEST_SKIP() << "no " << folder;
  int right = 0, wrong = 0, open = 0;
  std::string line;
  while (std::getline(table, line)) {
    const std::string file = line.substr(0, line.find(','));
    const bool is_y = line.find(",y,") != std::string::npos;
    const std::filesystem::path path = folder / "models" / file;
    std::error_code missing;
    if (path.extension() != ".obj" || file_size(path, missing) > kLargestReadBytes) continue;
    const auto up = likely_up(read_model(path.string()).mesh);
    ++(!up ? open : (*up == UpAxis::Y) == is_y ? right : wrong);
  }
  EXPECT_GE(right, 11);
  EXPECT_LE(wrong, 2);
  EXPECT_LE(open, 5);
  std::printf("up axes: %d right, %d wrong, %d not guessed\n", right, wrong, open);
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
