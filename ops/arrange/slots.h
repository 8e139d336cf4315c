// Patterns: where each of several things goes side by side on one surface, in closed form.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/sentence.h"
#include "ops/arrange/world.h"

namespace trivet {

struct Slot {
  size_t thing = 0;  // index
  Pose start;        // of a PUT
};

struct Slots {
  std::vector<Slot> slots;  // in the order of their PUTs
  Sentence why_not;         // empty unless they do not fit, with the lengths
  double missing = 0;       // metres, then; 0: no length is missing
};

/// Things of a pattern turn their fronts to where the support's is, plus their first own yaw. The
/// room ends at the surface's edges, seen along the support's right and front from the middle, or
/// at walls of the support that rays meet before.
/// @param seed  of shuffled patterns.
Slots slots_of(const World& world, const Pattern& pattern, std::uint64_t seed);

/// The things of a pattern, in its order.
std::vector<size_t> things_of(const World& world, const Pattern& pattern);

}  // namespace trivet
