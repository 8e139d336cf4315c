// Candidate pairs of nearby faces of two placed shapes, from their BVHs.
#pragma once

#include "core/exact/interpenetration.h"
#include "core/exact/separating_axes.h"

namespace trivet {

/// Frame of the boxes of a placed shape, which must have faces.
BoxFrame box_frame(const PlacedShape& placed);

Triangle world_triangle(const PlacedShape& placed, Index face);

/// The box of a face, in its object's frame.
inline Aabb face_box(const PlacedShape& placed, Index face) {
  Aabb out;
  for (const Vec3& p : placed.shape->mesh.triangle(face)) out.extend(p);
  return out;
}

/// Calls visit(face of a, face of b) -> bool for all pairs at most `distance` (metres) apart, and
/// for some farther ones, until it returns false.
template <class Visit>
void visit_near_faces(const PlacedShape& a, const PlacedShape& b, double distance,
                      const Visit& visit) {
  const Bvh &tree_a = a.shape->bvh(), &tree_b = b.shape->bvh();
  if (tree_a.nodes.empty() || tree_b.nodes.empty()) return;
  BoxFrame frame_a = box_frame(a);
  // A larger slack keeps boxes together that are up to the distance apart.
  frame_a.slack += distance;
  const SeparatingAxes axes(frame_a, box_frame(b));
  visit_near_leaves(tree_a, tree_b, axes, [&](const BvhNode& x, const BvhNode& y) {
    for (Index i = x.second_child; i < x.second_child + x.num_faces; ++i) {
      // Leaves may be near although most of their faces are not.
      const Aabb box = face_box(a, tree_a.faces[i]);
      for (Index j = y.second_child; j < y.second_child + y.num_faces; ++j)
        if (!axes.separate(box, face_box(b, tree_b.faces[j])) &&
            !visit(tree_a.faces[i], tree_b.faces[j]))
          return false;
    }
    return true;
  });
}

}  // namespace trivet
