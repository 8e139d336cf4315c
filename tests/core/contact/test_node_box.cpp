// Boxes of placed trees: by formula, and they hold the faces of their nodes.
#include <gtest/gtest.h>

#include <algorithm>

#include "support/random_queries.h"

namespace trivet {
namespace {

void expect_near(const Vec3& found, const Vec3& expected, double size) {
  EXPECT_LE((found - expected).cwiseAbs().maxCoeff(), 1e-14 * size);
}

// The box as matrices say it.
void expect_box(const PlacedBvh& tree, Index node) {
  const Aabb b = tree.bvh.nodes[node].box();
  const Vec3 half = b.half_extent(), centre = tree.linear * b.centre() + tree.translation;
  const PlacedBvh::Box found = tree.box(node);
  const double size = centre.norm() + tree.scale * (half.norm() + b.centre().norm());
  expect_near(found.centre, centre, size);
  expect_near(found.half, tree.linear.cwiseAbs() * half, size);
  expect_near(found.own_half, tree.scale * half, size);
  EXPECT_NEAR(found.radius, tree.scale * half.norm(), 1e-14 * size);
}

// @return whether all corners of the leaf's faces are in its box.
bool holds_faces(const PlacedBvh& tree, Index node, const Mesh& mesh) {
  const BvhNode& leaf = tree.bvh.nodes[node];
  const PlacedBvh::Box box = tree.box(node);
  const double rounding = 1e-14 * (box.centre.cwiseAbs() + box.half).maxCoeff();
  for (Index i = 0; i < leaf.num_faces; ++i)
    for (const Index v : mesh.triangles[tree.bvh.faces[leaf.second_child + i]]) {
      const Vec3 d = tree.linear * mesh.vertices[v] + tree.translation - box.centre;
      if ((d.cwiseAbs() - box.half).maxCoeff() > rounding || d.norm() > box.radius + rounding)
        return false;
    }
  return true;
}

void expect_boxes(const PlacedBvh& tree, const Mesh& mesh) {
  for (Index node = 0; node < static_cast<Index>(tree.bvh.nodes.size()); ++node) {
    expect_box(tree, node);
    EXPECT_TRUE(!tree.bvh.nodes[node].is_leaf() || holds_faces(tree, node, mesh)) << node;
  }
}

TEST(NodeBox, IsThatOfTheMatricesAndHoldsItsFaces) {
  constexpr unsigned kSeed = 17;
  const test::MeshPool pool(kSeed, 16);
  for (int i = 0; i < 60; ++i) {
    const test::RandomQuery q = test::random_query(pool, kSeed, i);
    const Body moving = q.moving[0].body(), fixed = q.fixed[0].body();
    const UnitFrame frame(fixed);
    expect_boxes(PlacedBvh(moving), moving.shape->mesh);
    expect_boxes(frame.tree(moving), moving.shape->mesh);
    expect_boxes(frame.own_tree(fixed), fixed.shape->mesh);
  }
}

}  // namespace
}  // namespace trivet
