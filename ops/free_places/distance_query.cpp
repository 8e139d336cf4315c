#include "ops/free_places/distance_query.h"

#include <utility>
#include <vector>

#include "core/contact/triangle_distance.h"

namespace trivet {
namespace {

// A lower bound, low enough to be one after rounding.
double gap(const PlacedBvh::Box& a, const PlacedBvh::Box& b) {
  const Vec3 apart = (a.centre - b.centre).cwiseAbs() - a.half - b.half;
  const double rounding = 1e-14 * (a.centre.cwiseAbs() + b.centre.cwiseAbs()).maxCoeff();
  return apart.cwiseMax(0).norm() - rounding;
}

bool faces_nearer(double distance, const Body& a, const BvhNode& leaf_a, const Body& b,
                  const BvhNode& leaf_b) {
  for (Index i = 0; i < leaf_a.num_faces; ++i)
    for (Index j = 0; j < leaf_b.num_faces; ++j) {
      const Triangle s = a.triangle(a.shape->bvh().faces[leaf_a.second_child + i]);
      const Triangle t = b.triangle(b.shape->bvh().faces[leaf_b.second_child + j]);
      if (closest_points(s, t).distance < distance) return true;
    }
  return false;
}

}  // namespace

bool nearer_than(double distance, const Body& a, const Body& b) {
  const PlacedBvh tree_a(a), tree_b(b);
  // Pairs of nodes that are farther apart hold no nearer faces; the larger node is opened.
  if (tree_a.bvh.nodes.empty() || tree_b.bvh.nodes.empty()) return false;
  std::vector<std::pair<Index, Index>> open{{0, 0}};
  while (!open.empty()) {
    const auto [i, j] = open.back();
    open.pop_back();
    const PlacedBvh::Box box_a = tree_a.box(i), box_b = tree_b.box(j);
    if (gap(box_a, box_b) >= distance) continue;
    const BvhNode &node_a = tree_a.bvh.nodes[i], &node_b = tree_b.bvh.nodes[j];
    if (node_a.is_leaf() && node_b.is_leaf()) {
      if (faces_nearer(distance, a, node_a, b, node_b)) return true;
    } else if (node_b.is_leaf() || (!node_a.is_leaf() && box_a.radius > box_b.radius)) {
      open.emplace_back(node_a.second_child, j);
      open.emplace_back(i + 1, j);
    } else {
      open.emplace_back(i, node_b.second_child);
      open.emplace_back(i, j + 1);
    }
  }
  return false;
}

}  // namespace trivet
