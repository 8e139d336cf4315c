// Parts of flat faces, thinned where others touch their backs.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/float32.h"
#include "core/convex/hull_tree.h"
#include "core/exact/interpenetration.h"
#include "core/scene/transaction.h"
#include "ops/files/layout/boxes.h"
#include "ops/simulation/simulation.h"
#include "support/effort.h"
#include "support/random_shapes.h"
#include "support/temporary_folder.h"

namespace trivet {
namespace {

using namespace trivet::test;

ObjectId add_mesh(Scene& scene, const std::string& name, const std::vector<Triangle>& triangles,
                  const Pose& pose) {
  Model model = box_model(1, 1, 1);
  model.mesh = weld(triangles);
  model.face_material.assign(triangles.size(), 0);
  Object object;
  object.name = name;
  object.model = std::make_shared<const Model>(model);
  object.shape = make_shape(model.mesh);
  object.pose = pose, object.placed = true, object.state = ObjectState::Stable;
  return scene.add(std::move(object));
}

Scene without_floor() {
  Scene scene;
  scene.floor = false;
  return scene;
}

/// A square sheet of two triangles at z = 0, seen from below.
std::vector<Triangle> sheet(double half) {
  std::vector<Triangle> out;
  add_quad(out, Vec3(-half, -half, 0), Vec3(-half, half, 0), Vec3(half, half, 0),
           Vec3(half, -half, 0));
  return out;
}

/// A sliver along x whose corner in the middle is off by less than float32 tells.
std::vector<Triangle> needle(double half) {
  return {{Vec3(-half, 0, 0), Vec3(half, 0, 0), Vec3(0, 1e-9, 0)}};
}

double deepest(const Scene& scene) {
  double out = 0;
  for (const PartOverlap& o : simulation_of(scene, "s", {}).overlaps) out = std::max(out, o.depth);
  return out;
}

/// Wider than the thinnest part of a metre.
constexpr double kNarrowGap = 3e-6;

TEST(FlatParts, LeaveRoomAtTheBack) {
  Scene scene = without_floor();
  add_mesh(scene, "sheet", sheet(0.5), {});
  add_mesh(scene, "on its back", box_triangles(Vec3::Constant(0.05)),
           {{}, Vec3(0, 0, 0.05 + kNarrowGap)});
  EXPECT_EQ(deepest(scene), 0);
  const TemporaryFolder folder;
  EXPECT_NO_THROW(export_simulation(scene, folder.file("s.xml")));
}

TEST(FlatParts, LeaveRoomBetweenTwo) {
  Scene scene = without_floor();
  add_mesh(scene, "sheet", sheet(0.5), {});
  const std::vector<Triangle> box = box_triangles(Vec3::Constant(0.05));
  add_mesh(scene, "on its back", box, {{}, Vec3(0, 0, 0.05 + kNarrowGap)});
  add_mesh(scene, "in front", box, {{}, Vec3(0, 0, -0.05 - kNarrowGap)});
  EXPECT_EQ(deepest(scene), 0);
}

TEST(FlatParts, LeaveRoomAboveTheFloor) {
  Scene scene;
  std::vector<Triangle> seen_from_above = sheet(0.5);
  for (Triangle& t : seen_from_above) std::swap(t[1], t[2]);
  add_mesh(scene, "sheet", seen_from_above, {{}, Vec3(0, 0, kNarrowGap)});
  EXPECT_EQ(deepest(scene), 0);
}

// A needle has no normal to speak of: it is thickened to all sides.
TEST(FlatParts, LeaveRoomBesideNeedles) {
  for (const Vec3& side : {Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(0, -1, 0), Vec3(0, 0, -1)}) {
    Scene scene = without_floor();
    add_mesh(scene, "needle", needle(0.5), {});
    add_mesh(scene, "beside", box_triangles(Vec3::Constant(0.05)),
             {{}, (0.05 + kNarrowGap) * side});
    EXPECT_LT(deepest(scene), 3e-7) << side.transpose();  // the fit ends at rounding
  }
}

TEST(FlatParts, AreThinOnlyWhereTheyMustBe) {
  Scene scene = without_floor();
  add_mesh(scene, "sheet", sheet(0.5), {});
  add_mesh(scene, "in front", box_triangles(Vec3::Constant(0.05)),
           {{}, Vec3(0, 0, -0.05 - kNarrowGap)});
  const SimulationExport done = simulation_of(scene, "s", {});
  ASSERT_EQ(done.scene.models[0].parts.size(), 1u);
  EXPECT_NEAR(volume_of(done.scene.models[0].parts[0]), 0.01 * std::sqrt(2), 1e-6)
      << "as thick as a shell";
}

TEST(FlatParts, GetThinnerToALimit) {
  const Mesh mesh = weld(sheet(0.5));
  const Adjacency adjacency = make_adjacency(mesh);
  HullTree tree(mesh, adjacency, 0.01);
  EXPECT_FALSE(tree.thin(0)) << "has a backing yet";
  while (tree.node(0).backing > 0) ASSERT_TRUE(tree.refine(0));
  const double size = std::sqrt(2);
  EXPECT_NEAR(tree.node(0).flat, kFlatPartThickness * size, 1e-9);
  for (double last = tree.node(0).flat; tree.thin(0); last = tree.node(0).flat) {
    EXPECT_LT(tree.node(0).flat, last);
    EXPECT_NEAR(volume_of(tree.node(0).part), tree.node(0).flat, 2e-7);
  }
  EXPECT_LT(tree.node(0).flat, 2e-6 * size);
  EXPECT_GT(tree.node(0).flat, 1e-6 * size);
  EXPECT_FALSE(tree.thin(0));
  ASSERT_TRUE(tree.refine(0));
  EXPECT_NEAR(tree.node(1).backing, 0.01, 0) << "halves have a thickness again";
}

// The end of a wire of a rack, 15 cm from the origin: float32 gives it a thickness in one unit, and
// takes it away in another, where MuJoCo refuses it.
TEST(FlatParts, StayThickInOtherUnits) {
  const std::vector<Vec3> end{{-0.151483268, -0.205344155, 0.0614722446},
                              {-0.153483301, -0.20334442, 0.0615058914},
                              {-0.155483276, -0.205344155, 0.0614722446},
                              {-0.153483242, -0.207343891, 0.0614385977}};
  for (const double unit : {1.0, 0.01, 0.0254, 0.3, 7.0}) {
    std::vector<Vec3> points = end;
    for (Vec3& p : points) p /= unit;
    ConvexPart part;
    EXPECT_TRUE(solid_hull(points, part, kFlatPartThickness / 64)) << unit;
    for (Vec3& v : part.vertices) v = as_float32(Vec3(v * unit));
    ConvexPart in_metres;
    EXPECT_FALSE(solid_hull(part.vertices, in_metres)) << unit;
  }
}

/// Concave meshes, open and closed, some of them inside out.
std::vector<Triangle> concave(int kind, Random& random) {
  const auto seed = static_cast<unsigned>(random.integer(1, 1000));
  std::vector<Triangle> out = kind == 0   ? terrain(4, 0.5, 0.2, seed)
                              : kind == 1 ? bumpy_sphere(5, 8, 0.4, seed)
                              : kind == 2 ? soup(12, 3, random)
                                          : sheet(random.uniform(0.3, 1));
  if (random.integer(0, 1))
    for (Triangle& t : out) std::swap(t[1], t[2]);
  return out;
}

bool apart(const Scene& scene, ObjectId a, ObjectId b) {
  const auto placed_shape = [&](ObjectId id) {
    const Object& object = scene.at(id);
    return PlacedShape{object.shape.get(), nullptr,
                       placed(object.pose.rotation, object.pose.translation)};
  };
  return count_crossings(placed_shape(a), placed_shape(b), 1) == 0;
}

/// Brings b along a line towards a, to within `gap` of the first place where their faces cross.
bool bring_near(Scene& scene, ObjectId a, ObjectId b, const Vec3& way, double gap) {
  const auto is_free = [&](double along) {
    edit_object(scene, b, [&](Object& o) { o.pose.translation = along * way; });
    return apart(scene, a, b);
  };
  double free = 6, crossing = 6;
  while (crossing > 0 && is_free(crossing)) free = crossing, crossing -= 0.05;
  if (crossing <= 0) return false;
  while (free - crossing > gap)
    (is_free((free + crossing) / 2) ? free : crossing) = (free + crossing) / 2;
  return is_free(free);
}

TEST(FlatParts, OverlapByRoundingIfTrianglesDoNotCross) {
  Random random(17);
  int num_near = 0;
  const int num_trials = with_effort(60);
  for (int trial = 0; trial < num_trials; ++trial) {
    Scene scene = without_floor();
    const ObjectId a = add_mesh(scene, "a", concave(random.integer(0, 3), random), {});
    const ObjectId b =
        add_mesh(scene, "b", concave(random.integer(0, 3), random), {random.rotation(), {}});
    if (!bring_near(scene, a, b, random.direction(), 1e-5)) continue;
    ++num_near;
    // The thinnest parts of both, and the rounding of their corners.
    const double sizes = scene.at(a).shape->box.diagonal() + scene.at(b).shape->box.diagonal();
    for (const PartOverlap& o : simulation_of(scene, "s", {}).overlaps)
      EXPECT_LT(o.depth, 2e-6 * sizes) << "trial " << trial << ", allowed " << o.allowed;
  }
  EXPECT_GT(num_near, num_trials / 2);
}

}  // namespace
}  // namespace trivet
