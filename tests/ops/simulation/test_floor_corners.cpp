// Objects on the floor stand on all their corners, and stay there in MuJoCo.
#include <gtest/gtest.h>

#include <cstdio>

#include "core/io/simulators/floor_corners.h"
#include "ops/files/layout/boxes.h"
#include "ops/simulation/simulate.h"
#include "ops/simulation/simulation.h"
#include "support/effort.h"
#include "support/solids.h"
#include "support/temporary_folder.h"

namespace trivet {
namespace {

using namespace trivet::test;

constexpr double kGap = 1e-6;

Model model_of(const Triangles& triangles) {
  Model model;
  model.format = "made";
  model.mesh = weld(triangles);
  return model;
}

SimulationModel parts_of(const Model& model) {
  SimulationModel out;
  out.parts.resize(1);
  solid_hull(model.mesh.vertices, out.parts[0]);
  return out;
}

Pose lying(double x, double height, double turn) {
  return {Rotation{std::cos(turn / 2), 0, 0, std::sin(turn / 2)}, Vec3(x, 0, height + kGap)};
}

TEST(FloorCorners, AreThoseOfSupportPolygon) {
  const SimulationModel box = parts_of(box_model(0.1, 0.03, 0.02));
  for (int k = 0; k < 50; ++k) {
    const std::vector<Vec3> corners = floor_corners(box, lying(0.3, 0.02, 0.13 * k));
    ASSERT_EQ(corners.size(), 4u) << k;
    for (const Vec3& corner : corners) EXPECT_NEAR(corner.z(), kGap, 1e-9);
  }
  const SimulationModel octagon = parts_of(model_of(cylinder(0.07, 0.04, 8)));
  for (int k = 0; k < 50; ++k) {
    const size_t count = floor_corners(octagon, lying(0, 0.02, 0.13 * k)).size();
    EXPECT_GE(count, 6u) << k;
    EXPECT_LE(count, 8u) << k;
  }
  EXPECT_LE(floor_corners(parts_of(model_of(cylinder(0.07, 0.04, 100))), lying(0, 0.02, 0)).size(),
            16u);
}

TEST(FloorCorners, AreNotOfWhatIsAboveFloor) {
  EXPECT_TRUE(floor_corners(parts_of(box_model(0.1, 0.1, 0.1)), lying(0, 0.2, 0)).empty());
  EXPECT_TRUE(floor_corners({}, {}).empty());
}

/// A body of one box, 0.2 x 0.06 x 0.06, turned about its long axis, x, so that it touches the
/// floor.
Pose rolled(double angle) {
  const double half = 0.03 * (std::abs(std::cos(angle)) + std::abs(std::sin(angle)));
  return {Rotation{std::cos(angle / 2), std::sin(angle / 2), 0, 0}, Vec3(0.3, 0, half + kGap)};
}

TEST(FloorEdges, AreThoseOnWhichPartsStand) {
  const SimulationModel box = parts_of(box_model(0.1, 0.03, 0.03));
  const std::vector<Vec3> ends = floor_edge_ends(box, rolled(0.5), 2 * kGap);
  ASSERT_EQ(ends.size(), 2u);
  EXPECT_NEAR((ends[0] - ends[1]).norm(), 0.2, 1e-8);  // corners are rounded to float32
  for (const Vec3& end : ends) EXPECT_NEAR(end.z(), kGap, 1e-9);
  EXPECT_TRUE(floor_edge_ends(box, rolled(0), 2 * kGap).empty());  // a face
  EXPECT_TRUE(floor_edge_ends(box, rolled(0.5), kGap / 2).empty());
  EXPECT_TRUE(floor_edge_ends({}, {}, 1).empty());
}

TEST(FloorEdges, HaveTheirOuterEndsAlone) {
  SimulationModel bar = parts_of(box_model(0.1, 0.03, 0.03));
  const Vec3 a(-0.1, -0.03, -0.03), b(0.1, -0.03, -0.03);
  for (const double t : {0.25, 0.5, 0.75}) bar.parts[0].vertices.push_back(a + t * (b - a));
  EXPECT_EQ(floor_edge_ends(bar, rolled(-0.5), 2 * kGap).size(), 2u);
  bar.parts.push_back(bar.parts[0]);  // the same edge again
  EXPECT_EQ(floor_edge_ends(bar, rolled(-0.5), 2 * kGap).size(), 2u);
  bar.parts.resize(1);
  bar.parts[0].vertices = {a};
  EXPECT_TRUE(floor_edge_ends(bar, rolled(-0.5), 2 * kGap).empty());
  bar.parts[0].vertices = {a, a};
  EXPECT_TRUE(floor_edge_ends(bar, rolled(-0.5), 2 * kGap).empty());
}

// With the three contacts that MuJoCo finds itself they move by 1 to 13 mm in 5 s.
TEST(FloorCorners, KeepFlatSolidsFromCreepingInMuJoCo) {
  if (!can_simulate()) GTEST_SKIP() << no_simulator();
  const TemporaryFolder folder;
  Scene scene;
  const auto add = [&](const char* name, const Model& model, double x, double height) {
    Object object;
    object.name = name;
    object.model = std::make_shared<const Model>(model);
    object.shape = make_shape(model.mesh);
    object.pose = lying(x, height, 0.7 * x + 0.4);
    object.placed = true, object.state = ObjectState::Stable;
    scene.add(std::move(object));
  };
  add("bar", box_model(0.15, 0.015, 0.015), 0, 0.015);
  add("slab", box_model(0.125, 0.1, 0.01), 1, 0.01);
  add("octagon", model_of(cylinder(0.07, 0.04, 8)), 2, 0.02);
  add("coin", model_of(cylinder(0.07, 0.02, 100)), 3, 0.01);
  const SimulatedScene done = simulate(export_simulation(scene, folder.file("flat.xml")),
                                       test::with_effort(100) < 40 ? 1 : 5);
  ASSERT_EQ(done.objects.size(), 4u);
  for (const SimulatedObject& o : done.objects) {
    std::printf("%-10s moved %.3g mm\n", o.name.c_str(), 1000 * o.moved);
    EXPECT_LT(o.moved, 1e-4) << o.name;
  }
}

}  // namespace
}  // namespace trivet
