// Faces grouped into a binary tree, without boxes. Private.
#pragma once

#include "core/index/bvh.h"

namespace trivet {

/// Children of nodes with more faces are made by several threads.
inline constexpr size_t kManyFaces = 4'096;

/// Box for grouping alone: the mesh's centre is 0, its largest extent 1 to either side, so that
/// huge, tiny or distant coordinates do not spoil the arithmetic of float32.
struct FaceBox {
  Eigen::Array4f lower, upper;  // the fourth is 0
};
std::vector<FaceBox> face_boxes(const Mesh& mesh);

/// Nodes but for their boxes, and face slots: by the surface-area heuristic, in bins [Wald 2007],
/// with median splits where that would go deeper than kMaxBvhDepth. The first child is that at the
/// start of the axis of the split. The same whatever the number of threads.
Bvh make_face_tree(const std::vector<FaceBox>& boxes);

}  // namespace trivet
