// Nodes of a tree in the frames of two bodies, one of which moves. Private.
#pragma once

#include <Eigen/Geometry>

#include "core/contact/body.h"
#include "core/motion/motion.h"

namespace trivet {

/// A node's box and slab as both bodies see them at time 0. The frames share their origin; in the
/// frame of its own body a node stands still, in that of the other body it moves.
struct PlacedNode {
  struct View {
    Vec3 centre, half;
    Vec3 normal;  // of the slab, not longer than 1
  };
  View own, other;
  double lower, upper;  // of the slab, about the centre
  double radius;        // of the box's sphere
  /// Of a turn, in the other body's frame: from the axis to the centre, and where the centre goes.
  Vec3 radial, tangent;
  double height, ring;  // of the centre along the axis, and from it

  PlacedNode(const class NodePlacer& placer, Index node);
};

/// Places the nodes of one body's tree.
class NodePlacer {
 public:
  /// @param other_from_own  rotation. @param own_origin  of the tree, in the body's own frame.
  /// @param motion  of the body relative to the other one, in the other one's frame.
  NodePlacer(const Body& body, const Mat3& other_from_own, const Vec3& own_origin,
             const Motion& motion)
      : m_bvh(body.shape->bvh()),
        m_scale(body.scale()),
        m_turn(other_from_own),
        m_abs_turn(other_from_own.cwiseAbs()),
        m_origin(own_origin),
        m_motion(motion) {}

  const Bvh& bvh() const { return m_bvh; }

 private:
  friend struct PlacedNode;
  const Bvh& m_bvh;
  double m_scale;
  Mat3 m_turn, m_abs_turn;
  Vec3 m_origin;
  Motion m_motion;
};

}  // namespace trivet
