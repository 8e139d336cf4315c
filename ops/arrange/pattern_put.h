// PUTs of a pattern: all of its things, or none.
#pragma once

#include <optional>
#include <vector>

#include "ops/arrange/conflict.h"
#include "ops/arrange/slots.h"

namespace trivet {

struct PlacedSlot {
  size_t thing = 0;
  OperationResult result;
};

/// @param placed  receives a PUT for each thing; also those before the one that failed, which are
///   taken back.   @return why not; nullopt: all stand in their slots.
std::optional<Conflict> put_pattern(World& world, const Pattern& pattern, std::uint64_t seed,
                                    std::vector<PlacedSlot>& placed);

}  // namespace trivet
