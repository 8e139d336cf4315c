// Penetration depth of two placed convex parts.
#pragma once

#include "core/convex/parts.h"

namespace trivet {

/// A part in the world: world = linear x vertex + translation.
struct PlacedPart {
  std::vector<Vec3> vertices;     // world
  std::vector<Index3> triangles;  // of these
  Aabb box;

  PlacedPart(const ConvexPart& part, const Affine& world_from_part);
};

/// Length of a translation that separates two convex parts: the least, or up to about a hundredth
/// more; 0 if they are apart, or touch to within rounding. The direction comes from the distance
/// algorithm of [Gilbert 1988] and the expanding polytope of [van den Bergen 2001], by libccd; the
/// length from the extents of the parts along it. Of parts with few faces, which are often slivers,
/// all normals of faces and of pairs of edges are tried.
double penetration_depth(const PlacedPart& a, const PlacedPart& b);

}  // namespace trivet
