// Spheres, ellipsoids and capsules as meshes, and how many sides they get.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <utility>

#include "core/io/foreign/primitives.h"
#include "core/io/foreign/scene.h"

namespace trivet {
namespace {

ForeignBody body_of(const RoundShape& shape, bool fixed = false) {
  ForeignBody body;
  body.fixed = fixed;
  ForeignCollider collider;
  collider.round = shape;
  collider.mesh = std::make_shared<const Mesh>(round_mesh(shape));
  body.colliders.push_back(std::move(collider));
  return body;
}

RoundShape ball(double radius) { return {Vec3::Constant(radius)}; }

size_t num_faces(const ForeignBody& body) { return body.colliders[0].mesh->triangles.size(); }

size_t faces_of_sides(int n) { return static_cast<size_t>(n) * static_cast<size_t>(n) / 2; }

double volume(const Mesh& mesh) {
  double six = 0;
  for (const Index3& t : mesh.triangles)
    six += mesh.vertices[static_cast<size_t>(t[0])].dot(
        mesh.vertices[static_cast<size_t>(t[1])].cross(mesh.vertices[static_cast<size_t>(t[2])]));
  return six / 6;
}

// Greatest distance of a face from the unit sphere on which its corners lie.
double depth_of(const Triangle& t) {
  const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]).normalized();
  return 1 - std::abs(normal.dot(t[0]));
}

TEST(RoundShapes, AreNoFartherBelowTheSurfaceThanStated) {
  for (const auto& [sides, most] : {std::pair(kMostBallSides, 1e-4), {kFewestBallSides, 6e-4}}) {
    const Mesh mesh = round_mesh(ball(1), sides);
    for (const Vec3& v : mesh.vertices) ASSERT_NEAR(v.norm(), 1, 1e-15);
    double deepest = 0;
    for (Index f = 0; f < static_cast<Index>(mesh.triangles.size()); ++f)
      deepest = std::max(deepest, depth_of(mesh.triangle(f)));
    EXPECT_LT(deepest, most);
    EXPECT_GT(deepest, 0.9 * most);
  }
}

TEST(RoundShapes, AreClosedAndTheirOutermostPointsExact) {
  RoundShape capsule = ball(2);
  capsule.half = 1;
  for (const RoundShape& shape : {ball(2), capsule}) {
    const Mesh mesh = round_mesh(shape);
    EXPECT_EQ(mesh.box().upper, Vec3(2, 2, 2 + shape.half));
    EXPECT_EQ(mesh.box().lower, Vec3(-2, -2, -2 - shape.half));
    std::set<std::pair<Index, Index>> edges;
    for (const Index3& t : mesh.triangles)
      for (size_t k = 0; k < 3; ++k) EXPECT_TRUE(edges.emplace(t[k], t[(k + 1) % 3]).second);
    for (const auto& [a, b] : edges) EXPECT_EQ(edges.count({b, a}), 1u);
  }
}

TEST(RoundShapes, LookOutwards) {
  RoundShape mirrored{Vec3(1, 2, 3)};
  mirrored.linear = Vec3(1, 1, -1).asDiagonal();
  EXPECT_NEAR(volume(round_mesh(mirrored)), 8 * M_PI, 0.03);
  RoundShape capsule = ball(1);
  capsule.half = 2;
  EXPECT_NEAR(volume(round_mesh(capsule)), (4.0 / 3 + 4) * M_PI, 0.02);
}

TEST(RoundShapes, AreFinerTheFewerBallsThereAre) {
  for (const auto& [num_balls, sides] : {std::pair(1, 376), {28, 376}, {100, 200}, {400, 164}}) {
    ForeignScene scene;
    for (int i = 0; i < num_balls; ++i) scene.bodies.push_back(body_of(ball(1 + i)));
    refine_round_shapes(scene);
    for (const ForeignBody& body : scene.bodies)
      ASSERT_EQ(num_faces(body), faces_of_sides(sides)) << num_balls;
  }
}

TEST(RoundShapes, ShareAMeshWhereAlike) {
  ForeignScene scene;
  for (const double radius : {1.0, 2.0, 1.0}) scene.bodies.push_back(body_of(ball(radius)));
  refine_round_shapes(scene);
  const auto mesh = [&](size_t i) { return scene.bodies[i].colliders[0].mesh; };
  EXPECT_EQ(mesh(0), mesh(2));
  EXPECT_NE(mesh(0), mesh(1));
}

TEST(RoundShapes, StayAsTheyAreInFixedCapsules) {
  RoundShape capsule = ball(1);
  capsule.half = 1;
  ForeignScene scene;
  scene.bodies = {body_of(capsule, true), body_of(ball(1), true), body_of(capsule)};
  const size_t before = num_faces(scene.bodies[0]);
  refine_round_shapes(scene);
  EXPECT_EQ(num_faces(scene.bodies[0]), before);
  EXPECT_GT(num_faces(scene.bodies[1]), before);
  EXPECT_GT(num_faces(scene.bodies[2]), before);
}

}  // namespace
}  // namespace trivet
