// The slab of a node, and how far the node reaches along any direction. Private.
#pragma once

#include <algorithm>

#include "core/contact/body.h"

namespace trivet {

/// Of n . x, about the centre of the node's box.
struct SlabRange {
  double lower, upper;
};

/// A BvhSlab in another frame, metres.
struct NodeSlab {
  Vec3 normal;  // not longer than 1
  double lower, upper;

  /// @param rotation  to the frame from the tree's own.
  NodeSlab(const PlacedBvh& tree, Index node, const Mat3& rotation) {
    const BvhSlab& s = tree.bvh.slabs[node];
    normal = rotation * Vec3(s.normal[0], s.normal[1], s.normal[2]);
    lower = tree.scale * s.lower;
    upper = tree.scale * s.upper;
  }

  /// In the tree's own frame.
  NodeSlab(const PlacedBvh& tree, Index node) {
    const BvhSlab& s = tree.bvh.slabs[node];
    normal = Vec3(s.normal[0], s.normal[1], s.normal[2]);
    lower = tree.scale * s.lower;
    upper = tree.scale * s.upper;
  }

  /// Along the part of n in the slab's normal by the slab, along the rest by the node's box, of
  /// these half extents, or by its sphere.
  SlabRange along(const Vec3& n, const Vec3& half) const {
    const double c = n.dot(normal);
    return range(c, (n - c * normal).cwiseAbs().dot(half));
  }
  SlabRange along(const Vec3& n, double radius) const {
    const double c = n.dot(normal);
    return range(c, (n - c * normal).norm() * radius);
  }

 private:
  SlabRange range(double c, double beside) const {
    return {std::min(c * lower, c * upper) - beside, std::max(c * lower, c * upper) + beside};
  }
};

/// True if two nodes are farther apart than `reach`, by their slabs.
/// @param box_a, box_b  of the nodes, in the slabs' frame.
inline bool slabs_apart(const NodeSlab& a, const NodeSlab& b, const PlacedBvh::Box& box_a,
                        const PlacedBvh::Box& box_b, double reach) {
  const Vec3 d = box_a.centre - box_b.centre;
  for (const Vec3& n : {a.normal, b.normal}) {
    const SlabRange of_a = a.along(n, box_a.half), of_b = b.along(n, box_b.half);
    const double along = n.dot(d);
    if (along + of_a.lower - of_b.upper > reach || of_b.lower - of_a.upper - along > reach)
      return true;
  }
  return false;
}

}  // namespace trivet
