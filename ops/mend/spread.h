// Objects side by side moved apart together. Private.
#pragma once

#include <optional>
#include <vector>

#include "ops/arrange/shape_facts.h"
#include "ops/placement/neighbourhood.h"

namespace trivet {

struct Spread {
  std::vector<Vec3> shifts;  // horizontal, metres
  bool free = false;         // all are free then
  double farthest = 0;       // metres
};

/// The shortest shifts by which these objects are free of each other and of what is in the scene:
/// a row spreads about its middle and away from walls. Pairs that are more than `most` in each
/// other at first, or are parted sooner upwards, stay so.
///
/// Pairs whose outlines from above are apart, or are the soonest parted way, are to stay on their
/// sides of a line; others leave each other by their exact depths, again and again. The least
/// shifts for all of these are gone in steps, so that nothing gets through a wall.
/// @param members  none of them in the scene.
Spread spread_out(const Scene& scene, const std::vector<Placement>& members, double most,
                  ShapeFacts& facts);

/// The turn about z after which a rectangle, seen from above, is parallel to another; nothing if
/// either is none to some percent, or more degrees than `most_deg` are between them.
std::optional<Rotation> turn_to_parallel(const std::vector<Vec2>& outline,
                                         const std::vector<Vec2>& other, double most_deg);

}  // namespace trivet
