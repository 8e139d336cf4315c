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

TEST(NodeGaps, AreAtMostThoseOfTheFaces) {
  const test::MeshPool pool(kPlacedSeed, 16);
  test::Random random(kPlacedSeed);
  int num_by_slabs = 0, num_by_boxes = 0;
  for (int i = 0; i < 400; ++i) {
    const test::RandomQuery q = test::random_query(pool, kPlacedSeed, i);
    const PlacedPair pair{q.moving[0].body(), q.fixed[0].body()};
    const std::vector<Index> of_moving = leaves(pair.moving_nodes.bvh()),
                             of_fixed = leaves(pair.fixed_nodes.bvh());
    for (int k = 0; k < 50; ++k) {
      const Index a = of_moving[random.integer(0, static_cast<int>(of_moving.size()) - 1)];
      const Index b = of_fixed[random.integer(0, static_cast<int>(of_fixed.size()) - 1)];
      const PlacedNode moving(pair.moving_nodes, a), fixed(pair.fixed_nodes, b);
      const SlabGaps gaps(moving, fixed);
      std::vector<Vec3> points_a = vertices_of_leaf(pair.moving, pair.moving_nodes.bvh().nodes[a]);
      std::vector<Vec3> points_b = vertices_of_leaf(pair.fixed, pair.fixed_nodes.bvh().nodes[b]);
      for (const int still : {kFixed, kMoving}) {
        std::vector<Vec3> here_a, here_b;
        for (const Vec3& p : points_a) here_a.push_back(pair.in(still, p));
        for (const Vec3& p : points_b) here_b.push_back(pair.in(still, p));
        const double gap = std::max(gaps.above[still], gaps.below[still]);
        EXPECT_LE(gap, distance_along(lane(gaps.normal, still), here_a, here_b) + pair.rounding);
        num_by_slabs += gap > 0;
        EXPECT_EQ(lane(gaps.normal, still),
                  lane(still == kFixed ? fixed.normal : moving.normal, still));
      }
      if (boxes_apart(moving, fixed, 0)) {
        ++num_by_boxes;
        double gap = -kInfinity;
        for (const Mat3& axes : {Mat3(pair.frames.fixed.unit_from_world.transpose()),
                                 Mat3(pair.moving.world_from_object.linear / pair.moving.scale())})
          for (int axis = 0; axis < 3; ++axis)
            gap = std::max(gap, distance_along(axes.col(axis), points_a, points_b));
        EXPECT_GT(gap, -pair.rounding);
      }
    }
  }
  EXPECT_GT(num_by_slabs, 5000);
  EXPECT_GT(num_by_boxes, 5000);
}

}  // namespace
}  // namespace trivet
