// Stability of a scene in words: objects that topple and their direction, and marginal ones.
#pragma once

#include <string>

#include "core/scene/scene.h"
#include "ops/base/outcome.h"
#include "ops/stability/stability.h"

namespace trivet {

/// "tips towards (1.00, 0.00)", "slides towards (0.71, 0.00, -0.71)", "sinks", of an object that
/// topples; world, unit vectors. Tips: its ends go farther by turning than its centre goes.
std::string way_text(const Object& object, const VirtualMotion& motion);

/// The smallest coefficient of friction of an object's contacts, by the materials; infinity: it has
/// none.
double least_pair_friction(const Scene& scene, ObjectId object);

/// "from start 3, 52 mm away and turned by 137.5 degrees".
std::string start_text(const StartTried& tried);
/// "\"a\" by 1.2 mm and 0.3 degrees, \"b\" by ...", of objects that an operation moved.
std::string gave_way_text(const std::vector<GaveWay>& objects);

/// A line for the scene, and one for each object that topples or is marginal.
std::string verdict_text(const Scene& scene, const Stability& stability);

}  // namespace trivet
