// First contact of a moving body with the floor, from its tree. Private.
#pragma once

#include <vector>

#include "core/contact/first_contact.h"

namespace trivet {

/// Decides vertices alone: no other point can be first. Refers to its query and to the best contact
/// known.
class FloorTraversal {
 public:
  FloorTraversal(const FirstContactQuery& query, Index moving, FirstContact& best);

  /// Decides all vertices that may come down until then, or before the best contact known; what may
  /// come later waits for the next search, with a later end.
  void search(double until);

 private:
  struct Waiting {
    double bound;
    Index node;
  };

  double bound(Index node) const;
  void visit(Waiting next);

  const FirstContactQuery& m_query;
  Index m_moving;
  FirstContact& m_best;
  PlacedBvh m_tree;
  double m_margin, m_until = 0;
  std::vector<Waiting> m_waiting, m_woken;
};

}  // namespace trivet
