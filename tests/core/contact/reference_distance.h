// The distance of two triangles by another way than the one under test, and pairs to try it on.
#pragma once

#include "core/base/types.h"
#include "support/random_shapes.h"

namespace trivet::test {

/// Minimises |x - y|^2 over both triangles by trying all 7 x 7 pairs of a vertex, edge or inside:
/// the least-squares solution of each, in long double, clamped to the feature. Every try is the
/// distance of two points that are in the triangles, so the result is never too small but for
/// rounding; and the closest points are in the inside of some pair of features, where they are that
/// pair's solution.
long double reference_distance(const Triangle& a, const Triangle& b);

/// Largest coordinate of both.
double extent(const Triangle& a, const Triangle& b);

/// What may be wrong in a distance, relative to extent(): rounding tilts the normal of a needle,
/// and what is thinner than 1e-8 counts as edges.
double distance_tolerance(const Triangle& a, const Triangle& b);

/// Of the kinds of soup() in turn; some are parallel, coplanar, or share a corner or an edge.
std::array<Triangle, 2> random_pair(int index, Random& random);

}  // namespace trivet::test
