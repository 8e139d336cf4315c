// Firmness of things that stand alone, where an arrangement asks for it.
#pragma once

#include <optional>
#include <string>

#include "core/base/sentence.h"
#include "ops/arrange/world.h"

namespace trivet {

/// Why the thing, or what carries it, directly or by others, stands less well than it is to;
/// nullopt: all do. The margin is the less of two: of the object's own weight, and of that with all
/// that lies on it, where their common centre of mass is.
std::optional<Sentence> unsteady(const World& world, const ThingModel& thing);

}  // namespace trivet
