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

}  // namespace trivet
