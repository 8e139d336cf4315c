// Until when two nodes are apart. Private.
#pragma once

#include "core/contact/approach.h"
#include "core/contact/placed_node.h"

namespace trivet {

/// Bounds of a pair of nodes, from boxes along the axes of both bodies and from slabs. Of
/// everything that counts both ways, by the moving body and by the fixed one as seen from it, each
/// has a lane.
class NodeMotion {
 public:
  /// @param of_moving, of_fixed  motions of each body relative to the other one, in the frame of
  ///   the other one: NodePlacer's. @param margin  farther apart than this nothing stops.
  NodeMotion(const Motion& of_moving, const Motion& of_fixed, double margin);

  /// @return a time until which they are apart: infinity, always. Of a turn, 0 or a time after the
  ///   horizon.
  double apart_until(const PlacedNode& moving, const PlacedNode& fixed, double horizon) const;

 private:
  double sliding_until(const PlacedNode& moving, const PlacedNode& fixed, double horizon) const;
  double turning_until(const PlacedNode& moving, const PlacedNode& fixed, double horizon) const;
  double slabs_slide(const PlacedNode& moving, const PlacedNode& fixed) const;
  double boxes_turn(const PlacedNode& moving, const PlacedNode& fixed, double horizon) const;
  double slabs_turn(const PlacedNode& moving, const PlacedNode& fixed, double horizon) const;

  Motion::Kind m_kind;
  double m_margin;
  Vec3Lanes m_direction;      // of the body that is not at home in a frame
  Vec3Lanes m_inverse_speed;  // along each axis, of either sign
};

}  // namespace trivet
