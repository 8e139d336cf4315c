// By how much two convex parts overlap where they are placed.
#pragma once

#include "core/convex/convex_parts.h"

namespace trivet {

/// A part in the world: world = linear x vertex + translation.
struct PlacedPart {
  std::vector<Vec3> vertices;  // world
  Aabb box;

  PlacedPart(const ConvexPart& part, const Affine& world_from_part);
};

/// A distance by which one of two convex parts can be moved to touch the other no more: the least,
/// or up to about a hundredth more; 0: they are apart, or touch to within rounding.
/// Gilbert, Johnson and Keerthi's distance and the expanding polytope of van den Bergen, by libccd,
/// give the direction; the extents of the parts along it the distance.
double penetration_depth(const PlacedPart& a, const PlacedPart& b);

}  // namespace trivet
