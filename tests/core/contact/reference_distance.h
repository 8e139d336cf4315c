// Independent computation of the distance of two triangles, and pairs to test it on.
#pragma once

#include "core/base/types.h"
#include "support/random_shapes.h"

namespace trivet::test {

/// Minimises |x - y|^2 over both triangles by trying all 7 x 7 pairs of a vertex, edge or inside:
/// the least-squares solution of each, in long double, clamped to the feature. Every try is the
/// distance of two points of the triangles, so the result is never too small except for rounding;
/// and the closest points lie inside some pair of features, where they are that pair's solution.
long double reference_distance(const Triangle& a, const Triangle& b);

/// Largest coordinate of both.
double extent(const Triangle& a, const Triangle& b);

/// Error allowed in a distance, relative to extent(): rounding tilts the normal of a needle, and
/// anything thinner than 1e-8 counts as edges.
double distance_tolerance(const Triangle& a, const Triangle& b);

/// Cycles through the kinds of soup(); some pairs are parallel, coplanar, or share a corner or an
/// edge.
std::array<Triangle, 2> random_pair(int index, Random& random);

}  // namespace trivet::test
