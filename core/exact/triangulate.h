// Polygons as triangles.
#pragma once

#include <span>
#include <vector>

#include "core/base/types.h"

namespace trivet {

/// Triangles between a polygon's own corners, wound as the polygon: one less than two fewer corners
/// would have, n - 2. Concave, non-planar and touching polygons are cut without overlap, by ears
/// [Meisters 1975] in the projection along an axis, with exact predicates; triangles without area
/// remain only where corners lie on a line.
/// @param corners   #n x 3; n is 3 at least.
/// @param triangles  receives numbers of corners.
/// @return false: the polygon crosses itself in every projection, and the triangles are a fan.
/// Cost O(n r), of r corners that are not convex; O(n^2 r) at worst.
bool triangulate(std::span<const Vec3> corners, std::vector<Index3>& triangles);

}  // namespace trivet
