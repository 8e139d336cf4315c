// First contact of one body with another, from their trees, in parts of the motion. Private.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <tuple>
#include <utility>
#include <vector>

#include "core/contact/approach.h"
#include "core/contact/decide.h"
#include "core/contact/leaf_box.h"
#include "core/contact/slab_motion.h"

namespace trivet {

/// One moving against one fixed body, in the frame of the fixed body (unit scale, its boxes are
/// axis-aligned there). Refers to its query and to the best contact known.
class PairTraversal {
 public:
  PairTraversal(const FirstContactQuery& query, Index moving, Index fixed, FirstContact& best);

  double apart_until() const { return m_apart_until; }

  /// Decides all pairs that may meet until then, or before the best contact known.
  void search(double until);

 private:
  /// A pair of nodes that may meet, though not before `bound`.
  struct Waiting {
    double bound;
    Index a, b;
    bool are_leaves;  // and their boxes meet: only faces decide
  };

  void wait(const Waiting& pair);
  void resume(const Waiting& pair);
  double bound(const PlacedBvh::Box& a, const PlacedBvh::Box& b) const;
  double translation_bound(const PlacedBvh::Box& a, const PlacedBvh::Box& b) const;
  double rotation_bound(const PlacedBvh::Box& a, const PlacedBvh::Box& b) const;
  double own_axes_bound(const PlacedBvh::Box& a, const PlacedBvh::Box& b) const;
  bool turning_box_is_clear(const Approach& x) const;
  bool misses_ring(const PlacedBvh::Box& a, const PlacedBvh::Box& b, double height,
                   const Vec3& radial) const;
  bool leaf_clear(const LeafBox& leaf, bool leaf_moves, const PlacedBvh::Box& box) const;

  // Later contacts do not matter.
  double horizon() const { return std::min(m_best.time, m_part.motion.limit); }
  bool hopeless(double bound) const { return bound > horizon(); }

  struct Next {
    double bound;        // beyond the horizon: they are apart until there at least
    double apart_until;  // whatever the horizon
    double gap;          // of the boxes' spheres, at time 0
    Index a, b;
    PlacedBvh::Box box_a, box_b;

    bool before(const Next& other) const {
      return std::tie(bound, gap) < std::tie(other.bound, other.gap);
    }
  };

  Next next(Index a, Index b, const PlacedBvh::Box& box_a, const PlacedBvh::Box& box_b, bool open_a,
            const LeafBox* leaf) const;
  void visit(Index ia, Index ib, const PlacedBvh::Box& box_a, const PlacedBvh::Box& box_b,
             const LeafBox* leaf);
  void try_leaves(Index ia, Index ib);
  double decide(const LeafFaces& a, size_t i, const LeafFaces& b, size_t j);
  double speed_of(const Triangle& moving) const;
  double faces_apart_until(const Aabb& moving, const Aabb& fixed, double speed) const;

  const FirstContactQuery& m_query;
  FirstContactQuery m_part;  // the same up to the end of this part
  Index m_moving, m_fixed;
  FirstContact& m_best;
  UnitFrame m_frame;
  PlacedBvh m_a, m_b;
  Motion m_motion;  // in this frame, about the origin
  Vec3 m_axis, m_centre;
  Mat3 m_rotation;                                 // of the moving body
  std::array<Vec3, 3> m_own_axis, m_own_axis_abs;  // of the moving body
  std::array<double, 3> m_own_axis_speed;          // of a translation, along them
  double m_margin, m_world_margin;
  SlabMotion m_slabs;
  double m_apart_until;         // both bodies
  Vec3 m_plane = Vec3::Zero();  // normal of one that separated faces: neighbours often, too
  std::vector<Waiting> m_waiting, m_woken;
};

}  // namespace trivet
