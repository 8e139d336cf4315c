// Common features of all formats: names, parts, overlaps, friction, files.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "core/base/error.h"
#include "core/convex/hull_memo.h"
#include "core/convex/hull_overlap.h"
#include "core/convex/hull_tree.h"
#include "core/io/simulators/simulation_files.h"
#include "core/scene/materials.h"
#include "core/scene/transaction.h"
#include "ops/check/check.h"
#include "ops/files/layout/boxes.h"
#include "ops/simulation/part_cache.h"
#include "ops/simulation/simulated_scene.h"
#include "ops/simulation/simulation.h"
#include "support/solids.h"
#include "support/temporary_folder.h"

namespace trivet {
namespace {

using namespace trivet::test;

ObjectId add(Scene& scene, const std::string& name, const Model& model, const Pose& pose) {
  Object object;
  object.name = name;
  object.model = std::make_shared<const Model>(model);
  object.shape = make_shape(model.mesh);
  object.pose = pose, object.placed = true, object.state = ObjectState::Stable;
  return scene.add(std::move(object));
}

std::string content(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

ConvexPart part_of(const Model& model) {
  ConvexPart part;
  solid_hull(model.mesh.vertices, part);
  return part;
}

TEST(Names, AreValidAndUnique) {
  const NameRule xml = NameRule::Xml, identifier = NameRule::Identifier;
  EXPECT_EQ(valid_names({"a", "a b", "a_b", "2", "", "world"}, xml, {"world"}),
            (std::vector<std::string>{"a", "a_b_2", "a_b", "_2", "_", "world_2"}));
  EXPECT_EQ(valid_names({"x.y-z"}, xml, {})[0], "x.y-z");
  EXPECT_EQ(valid_names({"x.y-z"}, identifier, {})[0], "x_y_z");
  // Letters of all scripts stay in XML, as far as they are UTF-8 and printed.
  const std::string cup = "gr\xc3\xbcne \xe8\x8c\xb6\xe7\xa2\x97";
  EXPECT_EQ(valid_names({cup, "\xc3\xa4", "\xc2\x85", "a\xffz", "\xc3"}, xml, {}),
            (std::vector<std::string>{"gr\xc3\xbcne_\xe8\x8c\xb6\xe7\xa2\x97", "\xc3\xa4", "_",
                                      "a_z", "__2"}));
  EXPECT_EQ(valid_names({cup, "\xc3\xa4"}, identifier, {}),
            (std::vector<std::string>{"gr_ne___", "_"}));
}

// An L of two boxes: one component, not convex.
Model l_shape() {
  Model model = box_model(0.1, 0.1, 0.1);
  std::vector<Triangle> triangles;
  const auto add_quad = [&](const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    triangles.push_back({a, b, c}), triangles.push_back({a, c, d});
  };
  const Vec2 outline[] = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  const auto at = [&](int i, double z) { return Vec3(outline[i % 6].x(), outline[i % 6].y(), z); };
  for (int i = 0; i < 6; ++i) add_quad(at(i, 0), at(i + 1, 0), at(i + 1, 1), at(i, 1));
  for (const double z : {0.0, 1.0}) {
    add_quad(at(0, z), at(1, z), at(2, z), at(3, z));
    add_quad(at(0, z), at(3, z), at(4, z), at(5, z));
    if (z == 0)
      for (size_t i = triangles.size() - 4; i < triangles.size(); ++i)
        std::swap(triangles[i][1], triangles[i][2]);
  }
  model.mesh = weld(triangles);
  model.face_material.assign(triangles.size(), 0);
  return model;
}

TEST(ConvexParts, ContainMesh) {
  const Mesh mesh = l_shape().mesh;
  const Adjacency adjacency = make_adjacency(mesh);
  ASSERT_EQ(adjacency.components.size(), 1u);
  ASSERT_TRUE(adjacency.components[0].manifold);
  const ConvexParts hull = convex_parts(mesh, adjacency, PartRule::Hull);
  ASSERT_EQ(hull.parts.size(), 1u);
  EXPECT_NEAR(volume_of(hull.parts[0]), 3.5, 1e-6);
  EXPECT_NEAR(volume_of(convex_parts(mesh, adjacency, PartRule::Components).parts.at(0)), 3.5,
              1e-6);
  if (!can_decompose()) GTEST_SKIP() << "this build has no HACD (Debian: libbullet-extras-dev)";
  const ConvexParts pieces = convex_parts(mesh, adjacency, PartRule::Decomposition);
  EXPECT_GE(pieces.parts.size(), 2u);
  double volume = 0;
  for (const ConvexPart& part : pieces.parts) volume += volume_of(part);
  EXPECT_LT(volume, 3.3);  // the mesh has 3
}

TEST(ConvexParts, GiveFlatMeshesThickness) {
  Mesh mesh = weld({{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}});
  const ConvexParts flat = convex_parts(mesh, make_adjacency(mesh), PartRule::Components);
  ASSERT_EQ(flat.parts.size(), 1u);
  EXPECT_GT(volume_of(flat.parts[0]), 0);
  EXPECT_EQ(flat.notes.size(), 1u);
  mesh = weld({{Vec3(1, 2, 3), Vec3(1, 2, 3), Vec3(2, 2, 3)}});
  EXPECT_GT(volume_of(convex_parts(mesh, make_adjacency(mesh), PartRule::Hull).parts.at(0)), 0);
}

// A rectangle of which one corner is off the plane by the rounding of float32: its hull has a
// volume, and MuJoCo refuses it. Two micrometres are enough.
TEST(ConvexParts, GiveThicknessToWhatIsFlatButForRounding) {
  for (const double off : {0.0, 1e-11, 2e-6}) {
    const Vec3 a(-0.25, 0.25, 0.25), b(0.25, 0.25, 0.25), up(0, -1.0 / (1 << 22), 1.0 / 128);
    const std::vector<Vec3> points{a, b, a + up, b + up + Vec3(0, off, 0)};
    ConvexPart part;
    EXPECT_EQ(solid_hull(points, part), off < 1e-6) << off;
    EXPECT_GT(volume_of(part), 0);
  }
  ConvexPart part;
  EXPECT_TRUE(solid_hull(std::vector<Vec3>{{-0.280706316, 0.00208733324, 0.286297947},
                                           {0.286312342, 0.00208723336, 0.286297947},
                                           {-0.280706316, 0.00208713324, 0.293524504},
                                           {0.286312342, 0.00208703335, 0.293524504}},
                         part));
}

TEST(ConvexParts, ShrinkByClearance) {
  const ConvexPart box = part_of(box_model(0.3, 0.2, 0.1));
  Aabb bounds;
  for (const Vec3& v : shrunk(box, 0.01).vertices) bounds.extend(v);
  EXPECT_LE((bounds.upper - Vec3(0.29, 0.19, 0.09)).norm(), 1e-6);
  EXPECT_LE((bounds.lower + Vec3(0.29, 0.19, 0.09)).norm(), 1e-6);
  bounds = {};  // by at most half of the depth
  for (const Vec3& v : shrunk(box, 5).vertices) bounds.extend(v);
  EXPECT_LE((bounds.upper - Vec3(0.25, 0.15, 0.05)).norm(), 1e-6);
}

TEST(ConvexParts, ShrinkRandomHullsByClearance) {
  Random random(7);
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<Vec3> points(static_cast<size_t>(8 + trial));
    for (Vec3& point : points) point = random.in_cube(1);
    ConvexPart part;
    solid_hull(points, part);
    const double by = 1e-3;
    const ConvexPart inner = shrunk(part, by);
    for (const Index3& t : part.triangles) {
      const Vec3 a = part.vertices[t[0]];
      const Vec3 normal = (part.vertices[t[1]] - a).cross(part.vertices[t[2]] - a).normalized();
      if (!normal.allFinite()) continue;
      for (const Vec3& v : inner.vertices) ASSERT_LE(normal.dot(v - a), -by * 0.9) << trial;
    }
    EXPECT_GT(volume_of(inner), 0.95 * volume_of(part) - 0.05) << trial;
  }
}

TEST(Overlap, MatchesKnownBoxes) {
  const ConvexPart box = part_of(box_model(0.5, 0.5, 0.5));
  const auto depth = [&](const Vec3& at) {
    return penetration_depth(PlacedPart(box, {}), PlacedPart(box, {Mat3::Identity(), at}));
  };
  EXPECT_NEAR(depth(Vec3(0.9, 0.1, 0.2)), 0.1, 1e-5);
  EXPECT_NEAR(depth(Vec3(0.1, -0.99, 0)), 0.01, 1e-5);
  EXPECT_NEAR(depth(Vec3(0.1, 0.2, 0.999)), 1e-3, 1e-5);
  EXPECT_EQ(depth(Vec3(0, 0, 1 + 1e-6)), 0);
  EXPECT_EQ(depth(Vec3(1.1, 0, 0)), 0);
}

// Brute force: the least depth over all face normals and pairs of edges.
double brute_depth(const PlacedPart& a, const PlacedPart& b, const ConvexPart& of_a,
                   const ConvexPart& of_b) {
  double least = kInfinity;
  const auto try_direction = [&](const Vec3& d) {
    if (!(d.norm() > 1e-9)) return;
    const Vec3 n = d.normalized();
    double max_a = -kInfinity, min_b = kInfinity, min_a = kInfinity, max_b = -kInfinity;
    for (const Vec3& v : a.vertices)
      max_a = std::max(max_a, n.dot(v)), min_a = std::min(min_a, n.dot(v));
    for (const Vec3& v : b.vertices)
      max_b = std::max(max_b, n.dot(v)), min_b = std::min(min_b, n.dot(v));
    least = std::min({least, max_a - min_b, max_b - min_a});
  };
  const auto edges = [](const PlacedPart& p, const ConvexPart& of) {
    std::vector<Vec3> out;
    for (const Index3& t : of.triangles)
      for (int k = 0; k < 3; ++k) out.push_back(p.vertices[t[(k + 1) % 3]] - p.vertices[t[k]]);
    return out;
  };
  for (const auto& [part, of] : {std::pair(&a, &of_a), std::pair(&b, &of_b)})
    for (const Index3& t : of->triangles)
      try_direction((part->vertices[t[1]] - part->vertices[t[0]])
                        .cross(part->vertices[t[2]] - part->vertices[t[0]]));
  for (const Vec3& e : edges(a, of_a))
    for (const Vec3& f : edges(b, of_b)) try_direction(e.cross(f));
  return std::max(0.0, least);
}

TEST(Overlap, EqualsBruteForce) {
  Random random(11);
  int num_hits = 0;
  for (int trial = 0; trial < 300; ++trial) {
    ConvexPart parts[2];
    for (ConvexPart& part : parts) {
      std::vector<Vec3> points(10);
      for (Vec3& point : points) point = random.in_cube(0.5);
      solid_hull(points, part);
    }
    const PlacedPart a(parts[0], {}), b(parts[1], {Mat3::Identity(), random.in_cube(1.0)});
    const double expected = brute_depth(a, b, parts[0], parts[1]);
    const double depth = penetration_depth(a, b);
    EXPECT_GE(depth, expected - 1e-9) << trial;
    EXPECT_LE(depth, 1.01 * expected + 1e-9) << trial;
    num_hits += expected > 0;
  }
  EXPECT_GT(num_hits, 60);
  EXPECT_LT(num_hits, 290);
}

TEST(Simulation, ReportsOverlapsAndSeparatesByClearance) {
  Scene scene;
  scene.floor = false;
  // A small box in the notch of an L: it overlaps only the hull.
  add(scene, "l", l_shape(), {});
  add(scene, "in notch", box_model(0.2, 0.2, 0.2), {{}, Vec3(1.25, 1.25, 0.5)});
  SimulationOptions components;
  components.collision = CollisionRule::Components;
  const SimulationExport all = simulation_of(scene, "s", components);
  ASSERT_EQ(all.overlaps.size(), 1u);
  EXPECT_EQ(all.overlaps[0].a, "l");
  EXPECT_EQ(all.overlaps[0].b, "in notch");
  EXPECT_GT(all.overlaps[0].depth, 0.3);
  Scene boxes;
  add(boxes, "a", box_model(0.1, 0.1, 0.1), {{}, Vec3(0, 0, 0.1)});
  add(boxes, "b", box_model(0.1, 0.1, 0.1), {{}, Vec3(0, 0, 0.2999)});
  SimulationOptions options;
  ASSERT_EQ(simulation_of(boxes, "s", options).overlaps.size(), 1u);
  EXPECT_NEAR(simulation_of(boxes, "s", options).overlaps[0].depth, 1e-4, 1e-6);
  options.hull_clearance = 6e-5;
  EXPECT_EQ(simulation_of(boxes, "s", options).overlaps.size(), 0u);
}

TEST(Simulation, TakesFrictionAndDensityOfMaterials) {
  Scene scene;
  const ObjectId a = add(scene, "a", box_model(0.1, 0.1, 0.1), {{}, Vec3(0, 0, 0.1)});
  const ObjectId b = add(scene, "b", box_model(0.1, 0.1, 0.1), {{}, Vec3(0, 0, 0.30001)});
  scene.floor_material = *material_preset("ice");
  update_contacts(scene, 1e-4);
  edit_object(scene, a, [](Object& o) { o.material = *material_preset("steel"); });
  edit_object(scene, b, [](Object& o) { o.least_friction = 0.8; });
  const SimulationExport done = simulation_of(scene, "s", {});
  EXPECT_EQ(done.scene.floor_friction, 0.1);
  EXPECT_EQ(done.scene.bodies[0].friction, 0.4);
  EXPECT_EQ(done.scene.bodies[0].restitution, 0.6);
  EXPECT_NEAR(done.scene.bodies[0].mass, 7850 * 0.008, 1e-9);
  EXPECT_EQ(done.scene.bodies[1].friction, 0.5);
  ASSERT_EQ(done.notes.size(), 1u);
  EXPECT_EQ(in_english(done.notes[0]),
            "\"b\" needs friction 0.8, its contacts have 0.4: it will move");
  SimulationOptions options;
  options.friction = 0.9, options.density = 100;
  const SimulationExport other = simulation_of(scene, "s", options);
  EXPECT_EQ(other.scene.bodies[0].friction, 0.9);
  EXPECT_EQ(other.scene.floor_friction, 0.9);
  EXPECT_NEAR(other.scene.bodies[0].mass, 100 * 0.008, 1e-9);
  EXPECT_TRUE(other.notes.empty());
}

bool is_inside(const ConvexPart& part, const Vec3& p, double slack) {
  for (const Index3& t : part.triangles) {
    const Vec3& a = part.vertices[t[0]];
    const Vec3 n = (part.vertices[t[1]] - a).cross(part.vertices[t[2]] - a);
    if (n.norm() > 0 && n.normalized().dot(p - a) > slack) return false;
  }
  return true;
}

TEST(HullTree, LeavesContainSurfaceHoweverFine) {
  Random random(5);
  int num_split = 0;
  for (int trial = 0; trial < 20; ++trial) {
    const Mesh mesh = trial % 2 ? weld(bumpy_sphere(6, 10, 0.3, static_cast<unsigned>(trial)))
                                : weld(soup(40, 0, random));
    const Adjacency adjacency = make_adjacency(mesh);
    HullTree tree(mesh, adjacency, 0.01);
    for (int k = 0; k < 60; ++k) {
      std::vector<Index> leaves;
      for (Index i = 0; i < tree.num_nodes(); ++i)
        if (tree.node(i).is_leaf()) leaves.push_back(i);
      ASSERT_EQ(leaves.size(), tree.num_leaves());
      num_split += tree.refine(leaves[random.integer(0, static_cast<int>(leaves.size()) - 1)]);
    }
    const std::vector<ConvexPart> parts = tree.parts();
    ASSERT_EQ(parts.size(), tree.num_leaves());
    for (size_t f = 0; f < mesh.triangles.size(); ++f) {
      const Triangle t = mesh.triangle(static_cast<Index>(f));
      const Vec3 points[] = {t[0], t[1], t[2], (t[0] + t[1] + t[2]) / 3};
      EXPECT_TRUE(std::any_of(parts.begin(), parts.end(),
                              [&](const ConvexPart& part) {
                                return std::all_of(
                                    std::begin(points), std::end(points),
                                    [&](const Vec3& p) { return is_inside(part, p, 1e-5); });
                              }))
          << trial << " " << f;
    }
  }
  EXPECT_GT(num_split, 300);
}

std::vector<ConvexPart> refined_parts(const Mesh& mesh, const Adjacency& adjacency, HullMemo* memo,
                                      int num_refined) {
  HullTree tree(mesh, adjacency, 0.01, memo);
  for (Index i = 0; i < tree.num_nodes() && num_refined > 0; ++i)
    while (tree.node(i).is_leaf() && num_refined-- > 0 && tree.refine(i)) {
    }
  return tree.parts();
}

void expect_same_parts(const std::vector<ConvexPart>& a, const std::vector<ConvexPart>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].vertices, b[i].vertices);
    EXPECT_EQ(a[i].triangles, b[i].triangles);
  }
}

TEST(HullTree, GivesTheSameFromMemory) {
  const Mesh mesh = weld(bumpy_sphere(6, 10, 0.3, 3));
  const Adjacency adjacency = make_adjacency(mesh);
  HullMemo memo;
  for (const int num : {30, 5, 60, 60})  // each tree goes another way down
    expect_same_parts(refined_parts(mesh, adjacency, &memo, num),
                      refined_parts(mesh, adjacency, nullptr, num));
}

TEST(Simulation, FitsPartsAlikeAtEveryScale) {
  const auto parts_at = [](double scale) {
    Scene scene;
    const Model box = open_box(0.2, 0.2, 0.01);
    const ObjectId id = add(scene, "box", box, {{}, Vec3(0, 0, scale * 0.010001)});
    const ObjectId in =
        add(scene, "content", box_model(0.05, 0.05, 0.05), {{}, scale * Vec3(0.1, 0.1, 0.060002)});
    for (const ObjectId each : {id, in})
      edit_object(scene, each, [&](Object& o) { o.scale = scale; });
    const SimulationExport done = simulation_of(scene, "s", {});
    EXPECT_TRUE(done.overlaps.empty());
    return done.scene.models[0].parts;
  };
  const std::vector<ConvexPart> one = parts_at(1), large = parts_at(3);
  ASSERT_EQ(one.size(), large.size());
  EXPECT_GT(one.size(), 1u);
  for (size_t i = 0; i < one.size(); ++i) {
    ASSERT_EQ(one[i].vertices.size(), large[i].vertices.size());
    for (size_t v = 0; v < one[i].vertices.size(); ++v)
      EXPECT_NEAR((3 * one[i].vertices[v] - large[i].vertices[v]).norm(), 0, 1e-6);
  }
}

TEST(PartCache, ChangesNoExport) {
  Scene scene;
  const Model box = open_box(0.2, 0.2, 0.01);
  add(scene, "box", box, {{}, Vec3(0, 0, 0.010001)});
  add(scene, "content", box_model(0.05, 0.05, 0.05), {{}, Vec3(0.1, 0.1, 0.060002)});
  SimulationOptions options, plain;
  options.cache = std::make_shared<PartCache>();
  for (int round = 0; round < 2; ++round) {
    const SimulationExport with = simulation_of(scene, "s", options);
    const SimulationExport without = simulation_of(scene, "s", plain);
    ASSERT_EQ(with.scene.models.size(), without.scene.models.size());
    for (size_t i = 0; i < with.scene.models.size(); ++i)
      expect_same_parts(with.scene.models[i].parts, without.scene.models[i].parts);
    // The content moves: other parts of the box are in its way.
    edit_object(scene, *scene.find("content"), [](Object& o) { o.pose.translation.x() += 0.04; });
  }
  const auto first = options.cache->of(scene.at(*scene.find("box")));
  EXPECT_EQ(options.cache->of(scene.at(*scene.find("box"))), first);
  for (int i = 0; i < 100; ++i) {
    Object other = scene.at(*scene.find("content"));
    other.shape = make_shape(other.shape->mesh);
    options.cache->of(other);
  }
  EXPECT_NE(options.cache->of(scene.at(*scene.find("box"))), first) << "old ones are forgotten";
}

TEST(HullTree, KeepsConvexSolidsAndStopsAtTriangles) {
  const Mesh box = weld(box_triangles(Vec3(1, 2, 3)));
  const Adjacency of_box = make_adjacency(box);
  HullTree convex(box, of_box, 0.01);
  EXPECT_FALSE(convex.refine(0));
  const Mesh l = l_shape().mesh;
  const Adjacency of_l = make_adjacency(l);
  HullTree tree(l, of_l, 0.01);
  for (Index i = 0; i < tree.num_nodes(); ++i)
    while (tree.node(i).is_leaf() && tree.refine(i)) {
    }
  EXPECT_EQ(tree.num_leaves(), l.triangles.size());
}

// The small box inside is in the way of the hull of the whole, of which no part is too near then.
TEST(Simulation, FitsPartsOfContainersAroundContents) {
  Scene scene;
  Model box = open_box(0.2, 0.2, 0.01);
  const Adjacency adjacency = make_adjacency(box.mesh);
  add(scene, "box", box, {{}, Vec3(0, 0, 0.010001)});
  add(scene, "content", box_model(0.05, 0.05, 0.05), {{}, Vec3(0.1, 0.1, 0.060002)});
  add(scene, "l", l_shape(), {{}, Vec3(1, 1, 1e-6)});
  add(scene, "in notch", box_model(0.2, 0.2, 0.2), {{}, Vec3(2.2001, 2.2001, 0.5)});
  scene.floor = true;
  SimulationOptions options;
  options.collision = CollisionRule::Hull;
  const SimulationExport hulls = simulation_of(scene, "s", options);
  EXPECT_EQ(hulls.overlaps.size(), 2u);
  const TemporaryFolder folder;
  try {
    export_simulation(scene, folder.file("s.xml"), options);
    ADD_FAILURE() << "written with overlaps";
  } catch (const Error& e) {
    EXPECT_NE(std::string(e.what()).find("overlap by"), std::string::npos) << e.what();
    EXPECT_NE(std::string(e.what()).find("--collision fitted"), std::string::npos) << e.what();
  }
  EXPECT_FALSE(std::filesystem::exists(folder.file("s.xml")));
  const SimulationExport done = export_simulation(scene, folder.file("s.xml"));
  for (const PartOverlap& o : done.overlaps) EXPECT_LE(o.depth, o.allowed) << o.a << " " << o.b;
  options.max_overlap = 1;
  EXPECT_NO_THROW(export_simulation(scene, folder.file("s.xml"), options));
  EXPECT_LT(done.scene.models[0].parts.size(), 12u) << "what is convex stays whole";
  EXPECT_GE(done.scene.models[2].parts.size(), 2u);
  EXPECT_LT(done.scene.models[2].parts.size(), 12u);
}

TEST(Simulation, ComputesInertiaOfBox) {
  Scene scene;
  add(scene, "a", box_model(0.1, 0.2, 0.3), {});
  SimulationOptions options;
  options.density = 500;
  const SimulationBody body = simulation_of(scene, "s", options).scene.bodies[0];
  const double mass = 500 * 0.2 * 0.4 * 0.6;
  EXPECT_NEAR(body.mass, mass, 1e-12);
  const Vec3 expected = mass / 12 * Vec3(0.16 + 0.36, 0.04 + 0.36, 0.04 + 0.16);
  EXPECT_LE((body.inertia - Mat3(expected.asDiagonal())).norm(), 1e-12);
}

// A prism of a bow tie: one half is turned inside out, and the whole has less than no inertia.
Model bow_tie() {
  const double far = 0.45;
  const std::array<Vec2, 4> corners{Vec2(-1, -1), Vec2(-1, 1), Vec2(far, -far), Vec2(far, far)};
  std::vector<Triangle> triangles;
  const auto at = [&](size_t i, double z) {
    return Vec3(0.1 * corners[i % 4].x(), 0.1 * corners[i % 4].y(), z);
  };
  for (size_t i = 0; i < 4; ++i) {
    triangles.push_back({at(i, 0), at(i, 0.1), at(i + 1, 0.1)});
    triangles.push_back({at(i, 0), at(i + 1, 0.1), at(i + 1, 0)});
  }
  for (const auto& [a, b, c] : {std::array<size_t, 3>{0, 1, 2}, std::array<size_t, 3>{0, 2, 3}}) {
    triangles.push_back({at(a, 0), at(b, 0), at(c, 0)});
    triangles.push_back({at(a, 0.1), at(c, 0.1), at(b, 0.1)});
  }
  Model model = box_model(1, 1, 1);
  model.mesh = weld(triangles);
  model.face_material.assign(triangles.size(), 0);
  return model;
}

TEST(Simulation, WritesAnInertiaThatABodyCanHave) {
  Scene scene;
  const ObjectId id = add(scene, "a", bow_tie(), {});
  const Eigen::SelfAdjointEigenSolver<Mat3> given(scene.at(id).shape->mass.covariance);
  ASSERT_LT(given.eigenvalues()[0], 0) << "the case is none";
  const SimulationExport done = simulation_of(scene, "s", {});
  const Eigen::SelfAdjointEigenSolver<Mat3> written(done.scene.bodies[0].inertia);
  const Vec3& i = written.eigenvalues();
  EXPECT_GT(i[0], 0);
  EXPECT_GT(i[0] + i[1], i[2]);
  ASSERT_EQ(done.notes.size(), 1u);
  EXPECT_NE(in_english(done.notes[0]).find("inside out"), std::string::npos);
}

TEST(Simulation, TellsMujocoOfTheGapsAtRest) {
  const TemporaryFolder folder;
  const SimulationExport done = export_simulation(convex_objects().scene, folder.file("s.xml"));
  for (const SimulationBody& body : done.scene.bodies) {
    EXPECT_GT(body.gap, 0) << body.name;
    EXPECT_LT(body.gap, 1e-4) << body.name;
  }
  EXPECT_GT(done.scene.floor_gap, 0);
  const std::string text = content(folder.file("s.xml"));
  EXPECT_NE(text.find(" margin=\"" + number_text(done.scene.floor_gap / 2 + 5e-7) + "\""),
            std::string::npos);
  SimulationOptions options;
  options.files.mujoco = 2;
  export_simulation(convex_objects().scene, folder.file("old.xml"), options);
  EXPECT_EQ(content(folder.file("old.xml")).find("margin"), std::string::npos);
}

TEST(Simulation, SharesFilesOfModelsAndFolders) {
  const TemporaryFolder folder;
  Scene scene;
  const ObjectId first = add(scene, "a", box_model(0.1, 0.1, 0.1), {{}, Vec3(0, 0, 0.1)});
  Object copy = scene.at(first);
  copy.name = "b", copy.pose.translation.x() = 1;
  scene.add(copy);
  SimulationOptions options;
  options.files.mesh_folder = "shared";
  const SimulationExport one = export_simulation(scene, folder.file("one.sdf"), options);
  ASSERT_EQ(one.scene.models.size(), 1u);
  EXPECT_EQ(one.files.size(), 4u);  // scene, OBJ, MTL, hull
  const auto time = std::filesystem::last_write_time(one.files[1]);
  const SimulationExport two = export_simulation(scene, folder.file("two.sdf"), options);
  EXPECT_TRUE(std::equal(one.files.begin() + 1, one.files.end(), two.files.begin() + 1));
  EXPECT_EQ(std::filesystem::last_write_time(two.files[1]), time);  // not rewritten
  EXPECT_EQ(content(one.files[0]).substr(0, 20), content(two.files[0]).substr(0, 20));
}

TEST(Simulation, KeepsOldFileOnWriteError) {
  const TemporaryFolder folder;
  Scene scene;
  add(scene, "a", box_model(0.1, 0.1, 0.1), {{}, Vec3(0, 0, 0.1)});
  export_simulation(scene, folder.file("s.xml"));
  const std::string before = content(folder.file("s.xml"));
  std::ofstream(folder.file("in_the_way")) << "a file";
  SimulationOptions options;
  options.density = 1;
  options.files.mesh_folder = "in_the_way";
  EXPECT_THROW(export_simulation(scene, folder.file("s.xml"), options), Error);
  EXPECT_EQ(content(folder.file("s.xml")), before);
  EXPECT_THROW(export_simulation(scene, folder.file("s.abc")), Error);
  options.collision = CollisionRule::Mesh;
  EXPECT_THROW(export_simulation(scene, folder.file("s.xml"), options), Error);
}

}  // namespace
}  // namespace trivet
