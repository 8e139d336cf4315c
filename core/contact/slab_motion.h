// Until when two nodes are apart, by their slabs. Private.
#pragma once

#include "core/contact/node_slab.h"
#include "core/motion/motion.h"

namespace trivet {

struct SlabMotion {
  Motion motion;      // in the frame of the slabs and boxes
  double margin = 0;  // farther apart than this nothing stops

  /// @param a, box_a  of the moving body. @param until  the nodes are apart until then.
  /// @return a later time, if their slabs show one; infinity: apart up to the horizon.
  double clear_until(const NodeSlab& a, const NodeSlab& b, const PlacedBvh::Box& box_a,
                     const PlacedBvh::Box& box_b, double until, double horizon) const;

 private:
  double sliding_until(const NodeSlab& a, const NodeSlab& b, const PlacedBvh::Box& box_a,
                       const PlacedBvh::Box& box_b, double until) const;
  bool turns_clear(const NodeSlab& a, NodeSlab b, const PlacedBvh::Box& box_a,
                   const PlacedBvh::Box& box_b, double until, double horizon) const;
  bool stays_beside(const Vec3& n, const Vec3& p, const Vec3& q, const SlabRange& of_p,
                    const SlabRange& of_q, double radius, double sense, double rest) const;
  Vec3 turned_back(const Vec3& v, double s) const;
};

}  // namespace trivet
