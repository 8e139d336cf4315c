// Faces of a leaf of a BVH, in the world.
#pragma once

#include <algorithm>
#include <span>
#include <utility>

#include "core/contact/body.h"

namespace trivet {

inline Aabb box_of(const Triangle& t) {
  return {t[0].cwiseMin(t[1]).cwiseMin(t[2]), t[0].cwiseMax(t[1]).cwiseMax(t[2])};
}

/// In the world.
struct LeafFaces {
  size_t num = 0;
  std::array<Index, kMaxLeafFaces> face;
  std::array<Triangle, kMaxLeafFaces> corners;

  LeafFaces(const Body& body, const BvhNode& leaf) : num(static_cast<size_t>(leaf.num_faces)) {
    for (size_t i = 0; i < num; ++i) {
      face[i] = body.shape->bvh().faces[static_cast<size_t>(leaf.second_child) + i];
      corners[i] = body.triangle(face[i]);
    }
  }

  std::span<const Triangle> all() const { return {corners.data(), num}; }
  /// The least and the largest n . (p - origin) of their points p.
  std::pair<double, double> along(const Vec3& n, const Vec3& origin) const {
    double low = kInfinity, high = -kInfinity;
    for (const Triangle& t : all())
      for (const Vec3& p : t) {
        const double height = n.dot(p - origin);
        low = std::min(low, height);
        high = std::max(high, height);
      }
    return {low, high};
  }
};

}  // namespace trivet
