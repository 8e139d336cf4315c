// Slabs of a BVH's nodes. Private.
#pragma once

#include "core/index/bvh.h"

namespace trivet {

/// @param bvh  with its boxes. @return one per node. Cost O(n): those of small subtrees are the
/// tightest along their normal, those of others hold their children's slabs and boxes.
std::vector<BvhSlab> make_slabs(const Mesh& mesh, const Bvh& bvh);

}  // namespace trivet
