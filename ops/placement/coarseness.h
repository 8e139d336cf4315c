// Largest scene for its smallest object.
#pragma once

#include "core/base/tunables.h"

namespace trivet {

/// Default clearance, of the smallest object's diagonal, beyond which a scene is refused: there
/// kBalanceTolerance is a third of that object, and all its faces soon are in contact with all that
/// are near. Larger takes minutes for nothing; smaller refuses a cup of 10 cm on a floor of 1 km.
inline constexpr double kCoarsestClearance = 1.0 / 64;

/// Largest distance of two objects of a scene, metres.
/// @param smallest_diagonal  of the smallest object.
/// @param clearance  that was asked for; 0: none was.
inline double largest_distance(double smallest_diagonal, double clearance) {
  const double accepted = kCoarsestClearance * smallest_diagonal;
  if (clearance > 0 && clearance <= accepted) return clearance / kSmallestClearance;
  const bool follows = accepted < kRelativeClearance * kClearanceReach;
  return accepted / (follows ? kRelativeClearance : kSmallestClearance);
}

}  // namespace trivet
