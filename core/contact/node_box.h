// The boxes of a placed tree, inlined. Private.
#pragma once

#include "core/contact/body.h"

namespace trivet {

/// PlacedBvh::box(). Of an inline function that several libraries call, the linker keeps one copy,
/// and those of units without trivet_inline_in_units() call functions for every vector: boxes took
/// three times as long.
inline PlacedBvh::Box placed_box(const PlacedBvh& tree, Index node) {
  const BvhNode& n = tree.bvh.nodes[node];
  Vec3 centre, half, own_half;
  for (int k = 0; k < 3; ++k) {
    const double lower = n.lower[k], upper = n.upper[k];
    centre[k] = 0.5 * (lower + upper);
    half[k] = 0.5 * (upper - lower);
    own_half[k] = tree.scale * half[k];
  }
  const double radius = tree.scale * half.norm();
  if (tree.own_frame) {
    for (int k = 0; k < 3; ++k) centre[k] *= tree.scale;
    return {centre, own_half, radius, own_half};
  }
  return {tree.linear * centre + tree.translation, tree.abs_linear * half, radius, own_half};
}

}  // namespace trivet
