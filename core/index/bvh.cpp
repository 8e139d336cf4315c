#include "core/index/bvh.h"

#include <algorithm>

#include "core/base/outward.h"
#include "core/index/face_tree.h"
#include "core/index/slabs.h"

namespace trivet {
namespace {

/// Boxes of all nodes, children before parents.
void set_boxes(const Mesh& mesh, Bvh& bvh) {
  // Children come after their parents, so that one pass from the end sees them first.
  for (size_t id = bvh.nodes.size(); id-- > 0;) {
    BvhNode& node = bvh.nodes[id];
    if (node.is_leaf()) {
      Aabb box;
      for (Index i = 0; i < node.num_faces; ++i)
        for (const Vec3& p : mesh.triangle(bvh.faces[node.second_child + i])) box.extend(p);
      // Boxes are rounded outwards to float32: half the memory, and nothing missed.
      for (int axis = 0; axis < 3; ++axis) {
        node.lower[axis] = float_below(box.lower[axis]);
        node.upper[axis] = float_above(box.upper[axis]);
      }
    } else {
      const BvhNode& first = bvh.nodes[id + 1];
      const BvhNode& second = bvh.nodes[node.second_child];
      for (int axis = 0; axis < 3; ++axis) {
        node.lower[axis] = std::min(first.lower[axis], second.lower[axis]);
        node.upper[axis] = std::max(first.upper[axis], second.upper[axis]);
      }
    }
  }
}

}  // namespace

Bvh build_bvh(const Mesh& mesh) {
  Bvh bvh;
  if (mesh.triangles.empty()) return bvh;
  bvh = make_face_tree(face_boxes(mesh));
  set_boxes(mesh, bvh);
  bvh.slabs = make_slabs(mesh, bvh);
  return bvh;
}

}  // namespace trivet
