// Real models beside the project: triangle counts, and bits compared with the independent reader.
#include <Eigen/Geometry>
#include <algorithm>
#include <fstream>
#include <iostream>
#include <sstream>

#include "core/io/io_testing.h"
#include "core/io/read_model.h"

namespace trivet {
namespace {

namespace fs = std::filesystem;

// A line of a CSV file; quotes may hold commas.
std::vector<std::string> cells(const std::string& line) {
  std::vector<std::string> out(1);
  bool quoted = false;
  for (const char c : line)
    if (c == '"')
      quoted = !quoted;
    else if (c == ',' && !quoted)
      out.emplace_back();
    else
      out.back() += c;
  return out;
}

double area_of(const std::vector<Triangle>& triangles) {
  double area = 0;
  for (const Triangle& t : triangles) area += (t[1] - t[0]).cross(t[2] - t[0]).norm() / 2;
  return area;
}

// Polygons are cut in other ways than assimp's; own readers read doubles, and have parts in the
// order of their nodes. Where assimp has as many triangles, they have the same box; see
// tests/corpus.
void expect_like_reference(const Model& model) {
  const std::vector<Triangle> expected = testing::reference_triangles(model.path);
  if (expected.size() != model.mesh.triangles.size()) return;
  Aabb box;
  for (const Triangle& t : expected)
    for (const Vec3& p : t) box.extend(p);
  const Aabb found = model.mesh.box();
  const double step = 1e-6 * box.max_abs_coordinate();
  // assimp multiplies the unit of Collada into its nodes.
  const double unit = model.format == "dae" ? model.metres_per_unit.value_or(1) : 1;
  EXPECT_LE((unit * found.lower - box.lower).cwiseAbs().maxCoeff(), step) << model.path;
  EXPECT_LE((unit * found.upper - box.upper).cwiseAbs().maxCoeff(), step) << model.path;
  EXPECT_LE(unit * unit * area_of(testing::triangles_of(model.mesh)), 1.0001 * area_of(expected))
      << model.path;
}

void expect_same_as_reference(const Model& model) {
  if (model.format != "gltf2" && model.format != "3ds") {
    expect_like_reference(model);
  } else {
    EXPECT_TRUE(testing::same_triangles(testing::triangles_of(model.mesh),
                                        testing::reference_triangles(model.path)))
        << model.path;
  }
  EXPECT_EQ(model.face_material.size(), model.mesh.triangles.size());
  for (const Index m : model.face_material)
    ASSERT_LT(m, static_cast<Index>(model.materials.size())) << model.path;
  for (const auto& face : model.corner_normals)
    for (const Eigen::Vector3f& n : face) ASSERT_NEAR(n.norm(), 1.0f, 1e-5f) << model.path;
}

TEST(ModelSet, ReadsEveryModel) {
  const std::string list = testing::shared_path("data/models.csv");
  if (list.empty()) GTEST_SKIP() << "no ../shared/data/models.csv";
  std::ifstream in(list);
  std::string line;
  std::getline(in, line);
  const std::vector<std::string> header = cells(line);
  const auto column = [&](const char* name) {
    return std::find(header.begin(), header.end(), name) - header.begin();
  };
  const auto file = column("file"), triangles = column("triangles"), up = column("up_axis");
  int count = 0;
  for (; std::getline(in, line); ++count) {
    const std::vector<std::string> row = cells(line);
    const Model model = read_model(testing::shared_path("data/models/" + row[file]));
    EXPECT_EQ(std::to_string(model.mesh.triangles.size()), row[triangles]) << row[file];
    if (model.up_from_format) {
      EXPECT_EQ(model.up == UpAxis::Y ? "y" : "z", row[up]) << row[file];
    }
    expect_same_as_reference(model);
  }
  EXPECT_EQ(count, 80);
}

// assimp refuses these for their materials, names, texture coordinates, encoding and blanks; the
// shape is there.
bool is_read_only_here(const fs::path& file) {
  const std::string folder = file.parent_path().filename().string(),
                    name = file.filename().string();
  return folder == "wrongTypes" || folder == "issue_3269" || name == "cube_UTF16LE.dae" ||
         name == "library_animation_clips.dae";
}

// assimp's own test files for formats missing from the set above. Some are intentionally broken or
// without triangles.
TEST(ModelSet, ReadsAssimpTestModels) {
  const fs::path root = "/usr/share/assimp/models";
  if (!fs::exists(root)) GTEST_SKIP() << "assimp-testmodels is not installed";
  int read = 0, refused = 0;
  for (const char* folder : {"FBX", "Collada", "3DS", "glTF2", "OBJ", "PLY", "STL"})
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      const std::string extension = entry.path().extension().string();
      if (!entry.is_regular_file() || extension == ".mtl" || extension == ".bin") continue;
      SCOPED_TRACE(entry.path().string());
      try {
        const Model model = read_model(entry.path().string());
        if (!is_read_only_here(entry.path())) expect_same_as_reference(model);
        ++read;
      } catch (const Error& error) {
        testing::expect_parts(error.what(), {entry.path().string()});
        const std::string message = error.what();
        refused +=
            message.find("no importer") == message.npos && message.find("picture") == message.npos;
      }
    }
  std::cout << read << " read, " << refused << " refused\n";
  EXPECT_GT(read, 100);
  EXPECT_LT(refused, read / 2);
}

}  // namespace
}  // namespace trivet
