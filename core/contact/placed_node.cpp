#include "core/contact/placed_node.h"

namespace trivet {

Vec3Lanes NodePlacer::in_both(const Vec3& own, const Vec3& other) const {
  return m_side == kFixed ? lanes(own, other) : lanes(other, own);
}

PlacedNode::PlacedNode(const NodePlacer& p, Index node) {
  const BvhNode& n = p.m_bvh.nodes[node];
  const BvhSlab& slab = p.m_bvh.slabs[node];
  // Nodes are stored as float in the object's frame; they are scaled and brought to both bodies'
  // frames.
  Vec3 own_centre, own_half, own_normal;
  for (int k = 0; k < 3; ++k) {
    const double low = n.lower[k], high = n.upper[k];
    own_centre[k] = p.m_scale * (0.5 * (low + high)) + p.m_origin[k];
    own_half[k] = p.m_scale * (0.5 * (high - low));
    own_normal[k] = slab.normal[k];
  }
  // A turned box is no box: the other frame gets the box around it.
  const Vec3 other_centre = p.m_turn * own_centre;
  centre = p.in_both(own_centre, other_centre);
  half = p.in_both(own_half, p.m_abs_turn * own_half);
  normal = p.in_both(own_normal, p.m_turn * own_normal);
  lower = p.m_scale * slab.lower;
  upper = p.m_scale * slab.upper;
  radius = own_half.norm();
  // A turn needs the circle of the centre, too: its height along the axis, radius and direction.
  if (p.m_motion.kind == Motion::Kind::Translation) return;
  const Vec3 r = other_centre - p.m_motion.centre;
  height = p.m_motion.axis.dot(r);
  radial = r - height * p.m_motion.axis;
  tangent = p.m_motion.axis.cross(r);
  ring = radial.norm();
}

}  // namespace trivet
