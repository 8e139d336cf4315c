#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "core/index/shape.h"
#include "core/io/mesh_model.h"
#include "core/mesh/made_meshes.h"
#include "core/mesh/weld_arrays.h"

namespace trivet {
namespace {

using namespace trivet::testing;

std::string complaint(const std::vector<Vec3>& vertices, const std::vector<Index3>& triangles) {
  try {
    weld(vertices, triangles);
  } catch (const Error& e) {
    EXPECT_EQ(e.kind(), Error::Kind::BadInput);
    return e.what();
  }
  return "";
}

const std::vector<Vec3> kSquare{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};

TEST(WeldArrays, MergesEqualVerticesAndMapsThem) {
  std::vector<Vec3> vertices = kSquare;
  vertices.emplace_back(7, 7, 7);     // 4: unused
  vertices.emplace_back(1, -0.0, 0);  // 5: as 1
  vertices.emplace_back(1, 1, -0.0);  // 6: as 2
  const WeldedMesh welded = weld(vertices, std::vector<Index3>{{3, 0, 1}, {5, 6, 3}});
  EXPECT_EQ(welded.mesh.triangles, (std::vector<Index3>{{0, 1, 2}, {2, 3, 0}}));
  EXPECT_EQ(welded.new_id, (std::vector<Index>{1, 2, -1, 0, -1, 2, 3}));
  EXPECT_EQ(welded.mesh.vertices,
            (std::vector<Vec3>{kSquare[3], kSquare[0], kSquare[1], kSquare[2]}));
}

TEST(WeldArrays, IsWeldOfTheTriangles) {
  const Triangles cube = make_cube();
  std::vector<Vec3> vertices;
  std::vector<Index3> triangles;
  for (const Triangle& t : cube) {
    const auto first = static_cast<Index>(vertices.size());
    triangles.push_back({first, first + 1, first + 2});
    vertices.insert(vertices.end(), t.begin(), t.end());
  }
  const WeldedMesh welded = weld(vertices, triangles);
  const Mesh expected = weld(cube);
  EXPECT_EQ(welded.mesh.vertices, expected.vertices);
  EXPECT_EQ(welded.mesh.triangles, expected.triangles);
  for (size_t v = 0; v < vertices.size(); ++v)
    EXPECT_EQ(welded.mesh.vertices[welded.new_id[v]], vertices[v]);
}

TEST(WeldArrays, RefusesWhatIsNotFiniteAndNamesTheRow) {
  for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL})
    for (size_t v = 0; v < kSquare.size(); ++v) {
      std::vector<Vec3> vertices = kSquare;
      vertices[v].y() = bad;
      // Also where no triangle uses it.
      const std::string what = complaint(vertices, {{0, 1, 2}});
      EXPECT_NE(what.find("vertex " + std::to_string(v) + " is not finite"), std::string::npos)
          << what;
    }
}

TEST(WeldArrays, RefusesIdsOutOfRangeAndNamesTheRow) {
  for (const Index bad :
       {-1, 4, std::numeric_limits<Index>::max(), std::numeric_limits<Index>::min()})
    for (int corner = 0; corner < 3; ++corner) {
      std::vector<Index3> triangles{{0, 1, 2}, {0, 2, 3}};
      triangles[1][corner] = bad;
      const std::string what = complaint(kSquare, triangles);
      EXPECT_NE(what.find("triangle 1 has vertex " + std::to_string(bad)), std::string::npos)
          << what;
      EXPECT_NE(what.find("accepted: 0 to 3"), std::string::npos) << what;
    }
  EXPECT_NE(complaint({}, {{0, 0, 0}}), "");
}

TEST(WeldArrays, RefusesAMeshWithoutTriangles) {
  EXPECT_NE(complaint(kSquare, {}), "");
  EXPECT_NE(complaint({}, {}), "");
  EXPECT_THROW(model_of_mesh({}), Error);
}

TEST(WeldArrays, KeepsDegenerateTriangles) {
  const std::vector<Index3> triangles{{0, 1, 2}, {1, 1, 2}, {3, 3, 3}};
  const WeldedMesh welded = weld(kSquare, triangles);
  EXPECT_EQ(welded.mesh.triangles, triangles);
  const auto shape = make_shape(model_of_mesh(welded.mesh).mesh);
  EXPECT_EQ(shape->mesh.triangles.size(), 3u);
  EXPECT_TRUE(std::isfinite(shape->mass.centre.norm()));
}

TEST(WeldArrays, GivesAModel) {
  const Model model = model_of_mesh(weld(kSquare, std::vector<Index3>{{0, 1, 2}, {0, 2, 3}}).mesh);
  EXPECT_TRUE(model.path.empty());
  EXPECT_EQ(model.materials.size(), 1u);
  EXPECT_EQ(model.face_material, (std::vector<Index>{0, 0}));
}

}  // namespace
}  // namespace trivet
