#include "core/contact/placed_node.h"

namespace trivet {

PlacedNode::PlacedNode(const NodePlacer& p, Index node) {
  const BvhNode& n = p.m_bvh.nodes[node];
  const BvhSlab& slab = p.m_bvh.slabs[node];
  for (int k = 0; k < 3; ++k) {
    const double low = n.lower[k], high = n.upper[k];
    own.centre[k] = p.m_scale * (0.5 * (low + high)) + p.m_origin[k];
    own.half[k] = p.m_scale * (0.5 * (high - low));
    own.normal[k] = slab.normal[k];
  }
  other.centre = p.m_turn * own.centre;
  other.half = p.m_abs_turn * own.half;
  other.normal = p.m_turn * own.normal;
  lower = p.m_scale * slab.lower;
  upper = p.m_scale * slab.upper;
  radius = own.half.norm();
  if (p.m_motion.kind == Motion::Kind::Translation) return;
  const Vec3 r = other.centre - p.m_motion.centre;
  height = p.m_motion.axis.dot(r);
  radial = r - height * p.m_motion.axis;
  tangent = p.m_motion.axis.cross(r);
  ring = radial.norm();
}

}  // namespace trivet
