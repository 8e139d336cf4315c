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

ForeignBody ball(double radius) {
  ForeignBody body;
  ForeignCollider collider;
  collider.ball_radius = radius;
  collider.mesh = std::make_shared<const Mesh>(ball_mesh(radius));
  body.colliders.push_back(std::move(collider));
  return body;
}

size_t num_faces(const ForeignBody& body) { return body.colliders[0].mesh->triangles.size(); }

// Rings of two triangles a side between two poles.
size_t faces_of_sides(int n) { return static_cast<size_t>(n) * static_cast<size_t>(n - 2); }

double volume(const Mesh& mesh) {
  double six = 0;
  for (Index f = 0; f < static_cast<Index>(mesh.triangles.size()); ++f) {
    const Triangle t = mesh.triangle(f);
    six += t[0].dot(t[1].cross(t[2]));
  }
  return six / 6;
}

// Greatest distance of a face from the unit sphere on which its corners lie.
double depth_of(const Triangle& t) {
  const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]).normalized();
  return 1 - std::abs(normal.dot(t[0]));
}

TEST(RoundShapes, AreNoFartherBelowTheSurfaceThanStated) {
  for (const auto& [sides, most] : {std::pair(kMostBallSides, 7e-5), {kFewestBallSides, 6.1e-4}}) {
    const Mesh mesh = ball_mesh(1, sides);
    for (const Vec3& v : mesh.vertices) ASSERT_NEAR(v.norm(), 1, 1e-14);
    double deepest = 0;
    for (Index f = 0; f < static_cast<Index>(mesh.triangles.size()); ++f)
      deepest = std::max(deepest, depth_of(mesh.triangle(f)));
    EXPECT_LT(deepest, most);
    EXPECT_GT(deepest, 0.9 * most);
  }
}

void expect_closed(const Mesh& mesh) {
  std::set<std::pair<Index, Index>> edges;
  for (const Index3& t : mesh.triangles)
    for (size_t k = 0; k < 3; ++k) EXPECT_TRUE(edges.emplace(t[k], t[(k + 1) % 3]).second);
  for (const auto& [a, b] : edges) EXPECT_EQ(edges.count({b, a}), 1u);
}

TEST(RoundShapes, AreClosedAndReachAsFarAsTheirRadii) {
  const std::pair<Mesh, Vec3> shapes[] = {{ball_mesh(2), Vec3(2, 2, 2)},
                                          {ellipsoid_mesh({1, 2, 3}), Vec3(1, 2, 3)},
                                          {capsule_mesh(2, 1), Vec3(2, 2, 3)},
                                          {cylinder_mesh(2, 1), Vec3(2, 2, 1)}};
  for (const auto& [mesh, upper] : shapes) {
    // Heights are exact, points of circles up to rounding.
    EXPECT_EQ(mesh.box().upper.z(), upper.z());
    EXPECT_EQ(mesh.box().lower.z(), -upper.z());
    EXPECT_LT((mesh.box().upper - upper).norm(), 1e-15);
    EXPECT_LT((mesh.box().lower + upper).norm(), 1e-15);
    expect_closed(mesh);
  }
}

TEST(RoundShapes, LookOutwards) {
  EXPECT_NEAR(volume(ellipsoid_mesh({1, 2, 3})), 8 * M_PI, 0.03);
  EXPECT_NEAR(volume(capsule_mesh(1, 2)), (4.0 / 3 + 4) * M_PI, 0.02);
  EXPECT_NEAR(volume(cylinder_mesh(1, 2)), 4 * M_PI, 0.01);
}

TEST(Balls, AreFinerTheFewerThereAre) {
  for (const auto& [num_balls, sides] : {std::pair(1, 376), {28, 376}, {100, 200}, {400, 128}}) {
    ForeignScene scene;
    for (int i = 0; i < num_balls; ++i) scene.bodies.push_back(ball(1 + i));
    refine_balls(scene);
    for (const ForeignBody& body : scene.bodies)
      ASSERT_EQ(num_faces(body), faces_of_sides(sides)) << num_balls;
  }
}

TEST(Balls, ShareAMeshWhereAlike) {
  ForeignScene scene;
  for (const double radius : {1.0, 2.0, 1.0}) scene.bodies.push_back(ball(radius));
  refine_balls(scene);
  const auto mesh = [&](size_t i) { return scene.bodies[i].colliders[0].mesh; };
  EXPECT_EQ(mesh(0), mesh(2));
  EXPECT_NE(mesh(0), mesh(1));
}

TEST(Balls, AloneAreMadeFiner) {
  ForeignScene scene;
  scene.bodies = {ball(1)};
  const auto given = std::make_shared<const Mesh>(ellipsoid_mesh({1, 1, 2}));
  scene.bodies[0].colliders.push_back({"egg", {}, given, {}, 0});
  refine_balls(scene);
  EXPECT_EQ(scene.bodies[0].colliders[1].mesh, given);
  EXPECT_GT(num_faces(scene.bodies[0]), given->triangles.size());
}

}  // namespace
}  // namespace trivet
