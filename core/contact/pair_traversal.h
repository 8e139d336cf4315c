// First contact of one body with another, from their trees, in parts of the motion. Private.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "core/contact/decide.h"
#include "core/contact/leaf_faces.h"
#include "core/contact/node_gaps.h"
#include "core/contact/node_motion.h"
#include "core/contact/recent_nodes.h"

namespace trivet {

/// Faces of a leaf with what is asked about them in most pairs.
struct LeafInMotion : LeafFaces {
  std::array<Aabb, kMaxLeafFaces> boxes;
  std::array<double, kMaxLeafFaces> speeds;  // no point goes farther until the time t than t times

  LeafInMotion(const Body& body, const BvhNode& leaf, const Motion& motion);
};

/// Shared by the traversals of one thread: nodes and leaves that were met last.
struct TraversalMemory {
  struct OfBody {
    RecentNodes<PlacedNode, 256> nodes;
    RecentNodes<LeafInMotion, 64> faces;
  };
  OfBody moving, fixed;
};

/// Motions of either body relative to the other one, in the frame of that one.
struct PairMotions {
  Motion of_moving, of_fixed;

  PairMotions(const PairFrames& frames, const Motion& motion);
};

/// One moving against one fixed body, in the frame of the fixed body (unit scale, its boxes are
/// axis-aligned there). Refers to its query and to the best contact known.
class PairTraversal {
 public:
  PairTraversal(const FirstContactQuery& query, Index moving, Index fixed, TraversalMemory& memory,
                SeparatingPlanes& planes, FirstContact& best);

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

  // Later contacts do not matter.
  double horizon() const { return std::min(m_best.time, m_part.motion.limit); }
  bool hopeless(double bound) const { return bound > horizon(); }

  struct Next {
    double bound;  // beyond the horizon: they are apart until there at least
    Index a, b;
  };

  const PlacedNode& node_a(Index a) { return m_memory.moving.nodes.get(m_search, a, m_a, a); }
  const PlacedNode& node_b(Index b) { return m_memory.fixed.nodes.get(m_search, b, m_b, b); }
  const LeafInMotion& faces_a(Index a) {
    return m_memory.moving.faces.get(m_search, a, m_query.moving[m_moving], m_a.bvh().nodes[a],
                                     m_query.motion);
  }
  const LeafInMotion& faces_b(Index b) {
    return m_memory.fixed.faces.get(m_search, b, m_query.fixed[m_fixed], m_b.bvh().nodes[b],
                                    m_query.motion);
  }
  Next next(Index a, Index b);
  double apart_by_last_plane(Index a, Index b);
  double gap(const Next& pair);
  bool goes_first(const Next& x, const Next& y);
  void visit(Index ia, Index ib);
  void try_leaves(Index ia, Index ib);
  double decide(const LeafFaces& a, size_t i, const LeafFaces& b, size_t j);
  double faces_apart_until(const Aabb& moving, const Aabb& fixed, double speed) const;

  const FirstContactQuery& m_query;
  FirstContactQuery m_part;  // the same up to the end of this part
  Index m_moving, m_fixed;
  std::uint64_t m_search = new_search();
  TraversalMemory& m_memory;
  SeparatingPlanes& m_planes;
  FirstContact& m_best;
  PairFrames m_frames;
  PairMotions m_motions;
  double m_margin, m_world_margin;
  NodePlacer m_a, m_b;
  NodeMotion m_nodes;
  double m_apart_until;  // both bodies
  PlaneNormal m_plane;   // of one that separated faces: neighbours often, too
  std::vector<Waiting> m_waiting, m_woken;
};

}  // namespace trivet
