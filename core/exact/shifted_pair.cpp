#include "core/exact/shifted_pair.h"

#include <algorithm>

#include "core/exact/near_faces.h"
#include "core/exact/predicates.h"

namespace trivet {
namespace {

constexpr size_t kMostBoxes = 1024;  // of a tree: some 100 kB

}  // namespace

ShiftedPair::Boxes::Boxes(size_t num_nodes) : m_slots(std::min(num_nodes, kMostBoxes)) {}

template <class Make>
const SeparatingAxes::AlongAxes& ShiftedPair::Boxes::get(Index node, const Make& make) {
  Slot& slot = m_slots[static_cast<size_t>(node) % m_slots.size()];
  if (slot.node != node) slot = {node, make()};
  return slot.box;
}

ShiftedPair::ShiftedPair(const PlacedShape& a, const PlacedShape& b)
    : m_a(a),
      m_b(b),
      m_boxes_a(a.shape->bvh().nodes.size()),
      m_boxes_b(b.shape->bvh().nodes.size()) {}

bool ShiftedPair::cross(const Vec3& by) {
  if (!m_a.shape->has_faces() || !m_b.shape->has_faces()) return false;
  // Both bodies stay as they are; only the test's placement moves.
  PlacedShape a = m_a;
  a.world_from_object.translation += by;
  if (m_last &&
      triangles_intersect(world_triangle(a, m_last->face_a), world_triangle(m_b, m_last->face_b)))
    return true;
  const Bvh &tree_a = a.shape->bvh(), &tree_b = m_b.shape->bvh();
  const SeparatingAxes axes(box_frame(a), box_frame(m_b));
  // Axes have the same directions whatever the shift.
  const auto apart = [&](Index i, Index j) {
    return axes.separate(m_boxes_a.get(i, [&] { return axes.of_a(tree_a.nodes[i].box()); }),
                         m_boxes_b.get(j, [&] { return axes.of_b(tree_b.nodes[j].box()); }));
  };
  bool found = false;
  visit_near_leaves(tree_a, tree_b, axes, apart, [&](const BvhNode& x, const BvhNode& y) {
    for (Index i = x.second_child; i < x.second_child + x.num_faces; ++i) {
      const Triangle triangle_a = world_triangle(a, tree_a.faces[i]);
      for (Index j = y.second_child; j < y.second_child + y.num_faces && !found; ++j) {
        found = triangles_intersect(triangle_a, world_triangle(m_b, tree_b.faces[j]));
        if (found) m_last = CrossingPair{tree_a.faces[i], tree_b.faces[j]};
      }
    }
    return !found;
  });
  return found;
}

}  // namespace trivet
