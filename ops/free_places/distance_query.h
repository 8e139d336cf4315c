// Distance query: whether two bodies are nearer to each other than a distance.
#pragma once

#include "core/contact/body.h"

namespace trivet {

/// Surfaces; exact up to the rounding of closest_points(). By pairs of boxes of their trees, up to
/// the first pair of faces that is near enough. The answer does not depend on the trees.
bool nearer_than(double distance, const Body& a, const Body& b);

}  // namespace trivet
