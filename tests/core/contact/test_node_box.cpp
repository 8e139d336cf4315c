// Boxes and slabs of placed trees: by formula; they hold the faces of their nodes; gaps between
// them are at most those between the faces.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/contact/node_gaps.h"
#include "support/random_queries.h"

namespace trivet {
namespace {

constexpr unsigned kPlacedSeed = 17;

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
  EXPECT_NEAR(found.radius, tree.scale * half.norm(), 1e-14 * size);
}

// World.
std::vector<Vec3> vertices_of_leaf(const Body& body, const BvhNode& leaf) {
  std::vector<Vec3> out;
  for (Index i = 0; i < leaf.num_faces; ++i)
    for (const Vec3& v : body.triangle(body.shape->bvh().faces[leaf.second_child + i]))
      out.push_back(v);
  return out;
}

std::vector<Index> leaves(const Bvh& bvh) {
  std::vector<Index> out;
  for (Index node = 0; node < static_cast<Index>(bvh.nodes.size()); ++node)
    if (bvh.nodes[node].is_leaf()) out.push_back(node);
  return out;
}

TEST(NodeBox, IsThatOfTheMatricesAndHoldsItsFaces) {
  const test::MeshPool pool(kPlacedSeed, 16);
  for (int i = 0; i < 60; ++i) {
    const Body body = test::random_query(pool, kPlacedSeed, i).moving[0].body();
    const PlacedBvh tree(body);
    for (Index node = 0; node < static_cast<Index>(tree.bvh.nodes.size()); ++node) {
      expect_box(tree, node);
      if (!tree.bvh.nodes[node].is_leaf()) continue;
      const PlacedBvh::Box box = tree.box(node);
      const double rounding = 1e-14 * (box.centre.cwiseAbs() + box.half).maxCoeff();
      for (const Vec3& v : vertices_of_leaf(body, tree.bvh.nodes[node])) {
        const Vec3 d = v - box.centre;
        EXPECT_LE((d.cwiseAbs() - box.half).maxCoeff(), rounding) << node;
        EXPECT_LE(d.norm(), box.radius + rounding) << node;
      }
    }
  }
}

/// Two bodies and their nodes in the frames of both.
struct PlacedPair {
  Body moving, fixed;
  PairFrames frames{moving, fixed};
  Motion motion = Motion::translation(Vec3::UnitX(), 1);
  NodePlacer moving_nodes = frames.moving_nodes(moving, motion);
  NodePlacer fixed_nodes = frames.fixed_nodes(fixed, motion);
  double rounding =
      1e-13 * (frames.origin_of_moving.norm() + moving.world_box.half_extent().norm() +
               fixed.world_box.half_extent().norm());

  Vec3 in(int frame, const Vec3& world) const {
    const Vec3 p = frames.fixed.point(world);
    return frame == kFixed ? p : Vec3(frames.fixed_from_moving.transpose() * p);
  }
};

void expect_holds(const PlacedPair& pair, const PlacedNode& node, int own,
                  const std::vector<Vec3>& vertices) {
  for (const Vec3& v : vertices) {
    for (const int frame : {kFixed, kMoving}) {
      const Vec3 d = pair.in(frame, v) - node.centre_in(frame);
      EXPECT_LE((d.cwiseAbs() - lane(node.half, frame)).maxCoeff(), pair.rounding);
      EXPECT_LE(d.norm(), node.radius + pair.rounding);
    }
    const double along = lane(node.normal, own).dot(pair.in(own, v) - node.centre_in(own));
    EXPECT_GE(along, node.lower - pair.rounding);
    EXPECT_LE(along, node.upper + pair.rounding);
  }
}

TEST(PlacedNode, HoldsItsFacesInBothFrames) {
  const test::MeshPool pool(kPlacedSeed, 16);
  for (int i = 0; i < 60; ++i) {
    const test::RandomQuery q = test::random_query(pool, kPlacedSeed, i);
    const PlacedPair pair{q.moving[0].body(), q.fixed[0].body()};
    for (const Index a : leaves(pair.moving_nodes.bvh()))
      expect_holds(pair, {pair.moving_nodes, a}, kMoving,
                   vertices_of_leaf(pair.moving, pair.moving_nodes.bvh().nodes[a]));
    for (const Index b : leaves(pair.fixed_nodes.bvh()))
      expect_holds(pair, {pair.fixed_nodes, b}, kFixed,
                   vertices_of_leaf(pair.fixed, pair.fixed_nodes.bvh().nodes[b]));
  }
}

// The distance between the shadows of two sets of points on a line.
double distance_along(const Vec3& n, const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  const auto range = [&](const std::vector<Vec3>& points) {
    double low = kInfinity, high = -kInfinity;
    for (const Vec3& p : points) low = std::min(low, n.dot(p)), high = std::max(high, n.dot(p));
    return std::pair(low, high);
  };
  const auto [low_a, high_a] = range(a);
  const auto [low_b, high_b] = range(b);
  return std::max(low_a - high_b, low_b - high_a);
}

/// A leaf of each body, and the corners of their faces, world.
struct LeafPair {
  const PlacedPair& pair;
  Index a, b;
  PlacedNode moving{pair.moving_nodes, a}, fixed{pair.fixed_nodes, b};
  std::vector<Vec3> of_moving = vertices_of_leaf(pair.moving, pair.moving_nodes.bvh().nodes[a]);
  std::vector<Vec3> of_fixed = vertices_of_leaf(pair.fixed, pair.fixed_nodes.bvh().nodes[b]);

  // @param n  in the frame `frame`
  double distance_in(int frame, const Vec3& n) const {
    const auto seen = [&](std::vector<Vec3> points) {
      for (Vec3& p : points) p = pair.in(frame, p);
      return points;
    };
    return distance_along(n, seen(of_moving), seen(of_fixed));
  }
};

// @return the number of slabs, of two, that tell the leaves apart
int expect_slab_gaps(const LeafPair& leaves) {
  const SlabGaps gaps(leaves.moving, leaves.fixed);
  int num_apart = 0;
  for (const int still : {kFixed, kMoving}) {
    const double gap = std::max(gaps.above[still], gaps.below[still]);
    const Vec3 normal = lane(gaps.normal, still);
    EXPECT_LE(gap, leaves.distance_in(still, normal) + leaves.pair.rounding);
    EXPECT_EQ(normal, lane(still == kFixed ? leaves.fixed.normal : leaves.moving.normal, still));
    num_apart += gap > 0;
  }
  return num_apart;
}

// @return whether boxes tell the leaves apart
bool expect_box_gaps(const LeafPair& leaves) {
  if (!boxes_apart(leaves.moving, leaves.fixed, 0)) return false;
  double gap = -kInfinity;
  for (const int frame : {kFixed, kMoving})
    for (int axis = 0; axis < 3; ++axis)
      gap = std::max(gap, leaves.distance_in(frame, Vec3::Unit(axis)));
  EXPECT_GT(gap, -leaves.pair.rounding);
  return true;
}

TEST(NodeGaps, AreAtMostThoseOfTheFaces) {
  const test::MeshPool pool(kPlacedSeed, 16);
  test::Random random(kPlacedSeed);
  const auto any_of = [&](const std::vector<Index>& nodes) {
    return nodes[random.integer(0, static_cast<int>(nodes.size()) - 1)];
  };
  int num_by_slabs = 0, num_by_boxes = 0;
  for (int i = 0; i < 400; ++i) {
    const test::RandomQuery q = test::random_query(pool, kPlacedSeed, i);
    const PlacedPair pair{q.moving[0].body(), q.fixed[0].body()};
    const std::vector<Index> of_moving = leaves(pair.moving_nodes.bvh());
    const std::vector<Index> of_fixed = leaves(pair.fixed_nodes.bvh());
    for (int k = 0; k < 50; ++k) {
      const Index a = any_of(of_moving), b = any_of(of_fixed);
      const LeafPair pair_of_leaves{pair, a, b};
      num_by_slabs += expect_slab_gaps(pair_of_leaves);
      num_by_boxes += expect_box_gaps(pair_of_leaves);
    }
  }
  EXPECT_GT(num_by_slabs, 5000);
  EXPECT_GT(num_by_boxes, 5000);
}

}  // namespace
}  // namespace trivet
