// Nodes of a tree in the frames of two bodies, one of which moves. Private.
#pragma once

#include <Eigen/Geometry>

#include "core/base/lanes.h"
#include "core/contact/body.h"
#include "core/motion/motion.h"

namespace trivet {

/// The two bodies of a pair; of lanes, the frame of either.
inline constexpr int kFixed = 0, kMoving = 1;

/// A node's box and slab as both bodies see them at time 0. The frames share their origin; in the
/// frame of its own body a node stands still, in that of the other body it moves.
struct PlacedNode {
  Vec3Lanes centre, half;
  Vec3Lanes normal;     // of the slab, not longer than 1
  double lower, upper;  // of the slab, about the centre
  double radius;        // of the box's sphere
  /// For a turn, in the other body's frame: from the axis to the centre, and where the centre goes.
  Vec3 radial, tangent;
  double height, ring;  // of the centre along the axis, and from it

  PlacedNode(const class NodePlacer& placer, Index node);

  Vec3 centre_in(int frame) const { return lane(centre, frame); }
};

/// Places the nodes of one body's tree.
class NodePlacer {
 public:
  /// @param side  which of the two bodies it is. @param other_from_own  rotation. @param own_origin
  ///   of the tree, in the body's own frame. @param motion  of the body relative to the other one,
  ///   in the other one's frame.
  NodePlacer(const Body& body, int side, const Mat3& other_from_own, const Vec3& own_origin,
             const Motion& motion)
      : m_bvh(body.shape->bvh()),
        m_side(side),
        m_scale(body.scale()),
        m_turn(other_from_own),
        m_abs_turn(other_from_own.cwiseAbs()),
        m_origin(own_origin),
        m_motion(motion) {}

  const Bvh& bvh() const { return m_bvh; }

 private:
  friend struct PlacedNode;
  Vec3Lanes in_both(const Vec3& own, const Vec3& other) const;

  const Bvh& m_bvh;
  int m_side;
  double m_scale;
  Mat3 m_turn, m_abs_turn;
  Vec3 m_origin;
  Motion m_motion;
};

/// A moving and a fixed body at time 0: frames of unit scale along the axes of each, both about the
/// origin of the fixed one.
struct PairFrames {
  UnitFrame fixed;
  Mat3 fixed_from_moving;
  Vec3 origin_of_moving;  // in the fixed body's frame

  PairFrames(const Body& moving, const Body& fixed_body)
      : fixed(fixed_body),
        fixed_from_moving(fixed.unit_from_world * moving.world_from_object.linear / moving.scale()),
        origin_of_moving(fixed.point(moving.world_from_object.translation)) {}

  /// @param of_body  its motion relative to the other one, in the frame of the other one.
  NodePlacer moving_nodes(const Body& moving, const Motion& of_body) const {
    return {moving, kMoving, fixed_from_moving, fixed_from_moving.transpose() * origin_of_moving,
            of_body};
  }
  NodePlacer fixed_nodes(const Body& body, const Motion& of_body) const {
    return {body, kFixed, fixed_from_moving.transpose(), Vec3::Zero(), of_body};
  }
};

}  // namespace trivet
