// How well things stand alone, where an arrangement asks for it.
#pragma once

#include <optional>
#include <string>

#include "ops/arrange/world.h"

namespace trivet {

/// Why the thing, or what carries it, stands less well than it is to; nullopt: all do.
std::optional<std::string> unsteady(const World& world, const ThingModel& thing);

}  // namespace trivet
