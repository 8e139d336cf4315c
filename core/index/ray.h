// Ray casting, for picking.
#pragma once

#include <optional>

#include "core/base/types.h"
#include "core/index/shape.h"

namespace trivet {

struct Ray {
  Vec3 origin = Vec3::Zero(), direction = Vec3::UnitX();  // of any length but zero

  Vec3 at(double time) const { return origin + time * direction; }
};

struct RayHit {
  double time = kInfinity;  // >= 0; the point is ray.at(time)
  Index face = 0;
};

/// First face hit by a ray, from either side; of several at one time the one with the smallest id.
/// Edges are closed: a ray through an edge or a vertex of two faces does not slip between them.
/// @param until  later hits do not count. Cost O(log n) boxes, found by Embree; its scene of the
/// shape is built for the first ray. Thread-safe.
std::optional<RayHit> first_hit(const Shape& shape, const Affine& world_from_object, const Ray& ray,
                                double until = kInfinity);

/// The same over all faces, without Embree: ground truth for tests.
std::optional<RayHit> first_hit_brute_force(const Shape& shape, const Affine& world_from_object,
                                            const Ray& ray, double until = kInfinity);

}  // namespace trivet
