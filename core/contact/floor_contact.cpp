#include <algorithm>

#include "core/contact/approach.h"
#include "core/contact/decide.h"
#include "core/contact/floor_traversal.h"

namespace trivet {

FloorTraversal::FloorTraversal(const FirstContactQuery& query, Index moving, FirstContact& best)
    : m_query(query),
      m_moving(moving),
      m_best(best),
      m_tree(query.moving[moving]),
      m_margin(query.clearance.largest_stop() * 1.002 +
               1e-14 * m_tree.translation.cwiseAbs().maxCoeff()) {
  m_waiting.push_back({0, 0});
}

void FloorTraversal::search(double until) {
  // Nodes that were put off for later are looked at again, now that the search goes farther.
  m_until = until;
  std::swap(m_waiting, m_woken);
  m_waiting.clear();
  for (const Waiting& next : m_woken) visit(next);
}

double FloorTraversal::bound(Index node) const {
  const PlacedBvh::Box box = m_tree.box(node);
  const Motion& motion = m_query.motion;
  // The box's own extent is added to the height of its centre: the lowest point may be any corner.
  const double gap = box.centre.z() - box.half.z() - m_margin;
  const HeightFunction centre =
      height_of_moving_point(0, Vec3::UnitZ(), box.centre - motion.centre, motion);
  return box_until({gap, box.half.z(), box.radius, centre}, motion.kind);
}

void FloorTraversal::visit(Waiting next) {
  // A node that comes down after the best contact is dropped; one that comes down after this part
  // waits.
  if (next.bound > std::min(m_best.time, m_query.motion.limit)) return;
  if (next.bound > m_until) return m_waiting.push_back(next);
  const BvhNode& n = m_tree.bvh.nodes[next.node];
  if (n.is_leaf()) {
    // Faces share vertices, so a vertex may be decided several times; the result is the same.
    for (Index i = 0; i < n.num_faces; ++i)
      for (const Index vertex :
           m_query.moving[m_moving].shape->mesh.triangles[m_tree.bvh.faces[n.second_child + i]])
        decide_floor_vertex(m_query, m_moving, vertex, m_best);
    return;
  }
  // The child that may come down first is searched first, and what it finds bounds the other.
  m_best.work.node_pairs += 2;
  Waiting first{bound(next.node + 1), next.node + 1}, second{bound(n.second_child), n.second_child};
  if (second.bound < first.bound) std::swap(first, second);
  visit(first);
  visit(second);
}

void decide_floor(const FirstContactQuery& query, Index moving, FirstContact& best) {
  FloorTraversal(query, moving, best).search(query.motion.limit);
}

void decide_floor_without_tree(const FirstContactQuery& query, Index moving, FirstContact& best) {
  const Body& body = query.moving[moving];
  const double margin =
      query.clearance.largest_stop() * 1.002 + 1e-14 * body.world_box.max_abs_coordinate();
  for (Index v = 0; v < static_cast<Index>(body.shape->mesh.vertices.size()); ++v) {
    // The margin covers the largest distance at which anything stops, and rounding.
    const Vec3 p = body.vertex(v);
    const HeightFunction height = height_of_moving_point(p.z() - margin, Vec3::UnitZ(),
                                                         p - query.motion.centre, query.motion);
    const double horizon = std::min(best.time, query.motion.limit);
    // The cheap test without a root leaves over the few vertices that may come down first.
    if (!positive_until(height, query.motion.kind, horizon))
      decide_floor_vertex(query, moving, v, best);
  }
}

}  // namespace trivet
