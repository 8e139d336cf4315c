// Private. Convex parts that leave room for the other objects.
#pragma once

#include <functional>
#include <vector>

#include "core/convex/hull_tree.h"
#include "core/convex/surface_probe.h"
#include "core/motion/pose.h"

namespace trivet {

/// A body of a scene for simulators whose parts are the leaves of a tree.
struct FittedBody {
  size_t tree = 0;
  Affine world_from_tree;
  double scale = 1;  // metres per unit of the tree
  bool fixed = false;
};

/// Refines the trees until no parts of two bodies, or of a free one and the floor at z = 0, overlap
/// by more than `limit`(body, body; of the floor twice the same). What is not near other bodies is
/// left as it is. A tree gets at most kMaxFittedParts leaves: what overlaps then, stays.
/// Deterministic.   Cost: pairs of parts whose boxes overlap, in a few rounds.
void fit_parts(std::vector<HullTree>& trees, const std::vector<FittedBody>& bodies, bool floor,
               const std::function<double(size_t, size_t)>& limit);

/// Refines a tree until none of its parts stands out of the surface by more than `limit` (units of
/// the tree), so that mugs and bowls are hollow. @return false if kMaxFittedParts leaves are too
/// few.
bool follow_surface(HullTree& tree, const SurfaceProbe& surface, double limit);

inline constexpr size_t kMaxFittedParts = 1024;

}  // namespace trivet
