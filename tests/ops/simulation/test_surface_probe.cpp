// Parts that stand out of surfaces, and slivers that overlap.
#include <gtest/gtest.h>

#include <array>

#include "core/convex/hull_overlap.h"
#include "core/convex/surface_probe.h"
#include "ops/files/layout/boxes.h"
#include "ops/simulation/fitted_parts.h"
#include "ops/simulation/simulation.h"

namespace trivet {
namespace {

ConvexPart hull_part_of(const Mesh& mesh) {
  ConvexPart part;
  solid_hull(mesh.vertices, part);
  return part;
}

/// A box without lid, of one surface: 0.22 m wide, 0.1 m high, walls of 1 cm.
Model square_cup() {
  const std::array<double, 4> halves{0.11, 0.11, 0.1, 0.1}, heights{0, 0.1, 0.1, 0.01};
  const auto at = [&](size_t ring, size_t k) {
    const double h = halves[ring];
    const std::array<Vec2, 4> corners{Vec2(-h, -h), Vec2(h, -h), Vec2(h, h), Vec2(-h, h)};
    return Vec3(corners[k % 4].x(), corners[k % 4].y(), heights[ring]);
  };
  std::vector<Triangle> triangles;
  const auto add_quad = [&](const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    triangles.push_back({a, b, c}), triangles.push_back({a, c, d});
  };
  for (size_t ring = 0; ring < 3; ++ring)
    for (size_t k = 0; k < 4; ++k)
      add_quad(at(ring, k), at(ring, k + 1), at(ring + 1, k + 1), at(ring + 1, k));
  add_quad(at(0, 3), at(0, 2), at(0, 1), at(0, 0));
  add_quad(at(3, 0), at(3, 1), at(3, 2), at(3, 3));
  Model out = box_model(1, 1, 1);
  out.mesh = weld(triangles);
  out.face_material.assign(triangles.size(), 0);
  return out;
}

TEST(SquaredDistance, EqualsKnownOnes) {
  const Triangle t{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
  EXPECT_DOUBLE_EQ(squared_distance(Vec3(0.2, 0.2, 3), t), 9);  // over the inside
  EXPECT_DOUBLE_EQ(squared_distance(Vec3(0.5, -2, 0), t), 4);   // beside an edge
  EXPECT_DOUBLE_EQ(squared_distance(Vec3(-3, -4, 0), t), 25);   // at a corner
  EXPECT_DOUBLE_EQ(squared_distance(Vec3(1, 1, 0), t), 0.5);    // beyond the long edge
  EXPECT_DOUBLE_EQ(squared_distance(Vec3(0.2, 0.2, 0), t), 0);
  const Triangle flat{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0)};  // is its edges
  EXPECT_DOUBLE_EQ(squared_distance(Vec3(1.5, 2, 0), flat), 4);
}

TEST(SurfaceProbe, FindsNothingOnConvexSolid) {
  const Mesh mesh = box_model(0.5, 0.25, 0.125).mesh;
  const SurfaceProbe surface(mesh, make_adjacency(mesh));
  EXPECT_LT(surface.farthest(hull_part_of(mesh)).distance, 1e-12);
  // A smaller part is inside of a closed solid, which is no error.
  const Mesh inner = box_model(0.125, 0.125, 0.0625).mesh;
  EXPECT_EQ(surface.farthest(hull_part_of(inner)).distance, 0);
}

// The middle of the hull's lid is 9 cm from the bottom, and 10 cm from the walls.
TEST(SurfaceProbe, FindsMiddleOfLid) {
  const Mesh mesh = square_cup().mesh;
  const Aabb box = mesh.box();
  const SurfaceProbe surface(mesh, make_adjacency(mesh));
  const StandsOut farthest = surface.farthest(hull_part_of(mesh));
  const double sampled = box.diagonal() / 12;
  EXPECT_NEAR(farthest.distance, 0.09, 1e-6);
  EXPECT_NEAR(farthest.at.z(), box.upper.z(), 1e-6);
  EXPECT_LT(farthest.at.head<2>().cwiseAbs().maxCoeff(), sampled);
  // A point that is known and farther stays.
  const StandsOut known{1, Vec3(7, 0, 0)};
  EXPECT_EQ(surface.farthest(hull_part_of(mesh), known).at, known.at);
}

TEST(SurfaceProbe, CountsBothSidesOfOpenMesh) {
  const Mesh mesh = weld({{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}});
  const SurfaceProbe surface(mesh, make_adjacency(mesh));
  ConvexPart part;
  const std::vector<Vec3> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.2, 0.2, -0.3}};
  solid_hull(points, part);
  const StandsOut farthest = surface.farthest(part);
  EXPECT_LE(farthest.distance, 0.3);
  EXPECT_GE(farthest.distance, 0.2);
  EXPECT_LT(farthest.at.z(), -0.2);
}

TEST(MaxError, HollowsWhatStandsOut) {
  Scene scene;
  const auto add = [&](const char* name, const Model& model) {
    Object object;
    object.name = name;
    object.model = std::make_shared<const Model>(model);
    object.shape = make_shape(model.mesh);
    object.pose.translation = Vec3(0, 0, 1), object.placed = true;
    object.state = ObjectState::Stable;
    scene.add(std::move(object));
  };
  add("cup", square_cup());
  SimulationOptions options;
  options.measured = true;
  const SimulationExport filled = simulation_of(scene, "s", options);
  ASSERT_EQ(filled.stands_out.size(), 1u);
  EXPECT_GT(filled.stands_out[0].distance, 0.05);
  options.max_error = 0.002;
  const SimulationExport hollow = simulation_of(scene, "s", options);
  EXPECT_LE(hollow.stands_out.at(0).distance, options.max_error);
  EXPECT_GT(hollow.scene.models[0].parts.size(), filled.scene.models[0].parts.size());
  EXPECT_LE(hollow.scene.models[0].parts.size(), kMaxFittedParts);
  EXPECT_TRUE(hollow.notes.empty()) << in_english(hollow.notes)[0];
}

// Two thin prisms of a heap of real models: the expanding polytope found 0.31 mm, and by the
// normals of their edges 0.049 mm separate them.
TEST(Overlap, OfSliversIsTheLeastOne) {
  const std::vector<Vec3> a{{0.152605, -0.043091, 0.525141}, {0.156634, -0.041344, 0.527754},
                            {0.161634, -0.078189, 0.506268}, {0.152606, -0.043088, 0.525138},
                            {0.156636, -0.041341, 0.527751}, {0.161635, -0.078187, 0.506265}};
  const std::vector<Vec3> b{{0.363821, -0.045430, 0.553261},  {-0.197344, -0.053888, 0.472440},
                            {-0.197320, -0.054672, 0.472357}, {0.363829, -0.045424, 0.553205},
                            {-0.197336, -0.053882, 0.472384}, {-0.197312, -0.054666, 0.472301}};
  ConvexPart of_a, of_b;
  solid_hull(a, of_a), solid_hull(b, of_b);
  const double depth = penetration_depth(PlacedPart(of_a, {}), PlacedPart(of_b, {}));
  EXPECT_GT(depth, 3e-5);
  EXPECT_LT(depth, 7e-5);
}

}  // namespace
}  // namespace trivet
