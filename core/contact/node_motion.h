// Until when two nodes are apart. Private.
#pragma once

#include "core/contact/approach.h"
#include "core/contact/placed_node.h"

namespace trivet {

/// Bounds of a pair of nodes, from boxes along the axes of both bodies and from slabs.
class NodeMotion {
 public:
  /// @param of_moving, of_fixed  motions of each body relative to the other one, in the frame of
  ///   the other one: NodePlacer's. @param margin  farther apart than this nothing stops.
  NodeMotion(const Motion& of_moving, const Motion& of_fixed, double margin);

  /// @return a time until which they are apart: infinity, always. Of a turn, 0 or a time after the
  ///   horizon.
  double apart_until(const PlacedNode& moving, const PlacedNode& fixed, double horizon) const;

 private:
  struct Side {  // one body stands still, the other one moves
    Vec3 direction;
    Vec3 inverse_speed;  // along each axis, of either sign
  };
  double sliding_until(const PlacedNode& moving, const PlacedNode& fixed, double horizon) const;
  double turning_until(const PlacedNode& moving, const PlacedNode& fixed, double horizon) const;
  double boxes_slide(const PlacedNode& mover, const PlacedNode& still, const Side& side,
                     double& leave) const;
  double slab_slides(const PlacedNode& mover, const PlacedNode& still, const Side& side) const;
  double boxes_turn(const PlacedNode& mover, const PlacedNode& still, double horizon) const;
  double slab_turns(const PlacedNode& mover, const PlacedNode& still, double horizon) const;

  Motion::Kind m_kind;
  double m_margin;
  Side m_of_moving, m_of_fixed;
};

}  // namespace trivet
