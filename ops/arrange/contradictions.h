// Wishes that cannot be met wherever things stand, told before anything is placed.
#pragma once

#include <optional>

#include "ops/arrange/conflict.h"

namespace trivet {

/// Levels that supports do not have, and distances that others forbid: outlines are at most so far
/// apart as a chain of relations says, with the sizes of what is between (triangle inequality), and
/// a relation, or a distance to keep, asks for more. Bounds alone: what is named cannot be met;
/// nullopt says nothing. Each chain by [Dijkstra 1959], up to the distances that are asked for.
std::optional<Conflict> find_contradiction(const World& world);

}  // namespace trivet
