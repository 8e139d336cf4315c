// Zones on their scene: where they are, and who is in them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/sentence.h"
#include "ops/arrange/world.h"

namespace trivet {

inline constexpr double kZoneSlack = 1e-5;  // metres that something may be inside

/// A box of its own, at the zone's place in its object's frame, smaller by the slack all around.
Object object_of(const Zone& zone);

/// Zones of an object in this pose of it.
std::vector<Body> zones_of(const World& world, const std::string& object, const Pose& pose);

/// Names what is in a zone that must be free, by the exact test: of the thing as it stands, its
/// own zones with all others, and those of others with it. nullopt: all zones are free.
std::optional<Sentence> taken_zone(const World& world, const ThingModel& thing);

}  // namespace trivet
