// Pairs that may meet while vertices stay in boxes around them: found once for many steps.
#pragma once

#include "core/flex/near_pairs.h"

namespace trivet::flex {

class NearList {
 public:
  /// @param outside, own  distances from obstacles and from itself within which pairs count,
  /// metres.
  /// @param slack  metres by which boxes are larger than asked for, at least.
  NearList(Surroundings& surroundings, double outside, double own, double slack);

  /// All pairs that may come within the distances while each vertex stays in its box, and perhaps
  /// more, in the order of Surroundings::find(). @param boxes  around the vertices, at `x`.
  /// @return null if there are too many.
  const std::vector<NearPair>* within(const Points& x, std::span<const Aabb> boxes);

 private:
  bool holds(std::span<const Aabb> boxes) const;
  bool gather(const Points& x, std::span<const Aabb> boxes);

  Surroundings& m_surroundings;
  double m_outside, m_own, m_slack;
  std::vector<Aabb> m_boxes;
  std::vector<NearPair> m_pairs;
};

}  // namespace trivet::flex
