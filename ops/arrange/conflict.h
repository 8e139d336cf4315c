// Conflicts: why there is no place for a thing, as the smallest set of constraints that leaves
// none.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/sentence.h"
#include "ops/arrange/placer.h"

namespace trivet {

struct Conflict {
  std::string thing;                      // or the pattern
  std::vector<Sentence> constraints;      // the smallest set found; empty: PUT refused everywhere
  std::vector<std::string> objects = {};  // that the constraints name, each once; not `thing`
  std::vector<size_t> relations = {};     // indices of those among the constraints
  bool as_they_stand = false;             // names things that could stand elsewhere
  bool is_certain = false;                // wherever things stand: no search would find a place
  /// Metres by which relations miss each other, by outlines alone: if each gave way by half of it,
  /// or a single one by all, they would leave a place.
  std::optional<double> missing;
  /// Index of the one of `relations` that has to give way by the least for a place; nullopt: rays
  /// judge them all, or there are none.
  std::optional<size_t> cheapest = {};
  Sentence text = {};
};

/// Sets of 1, 2 and 3 relations by their half planes, over all rotations; then, on the places of
/// the height maps, sets of 1, 2 and 3 of all constraints, then what is left when none can be
/// deleted.
/// @param refused  what PUT said first where places were tried; may be empty.
Conflict find_conflict(World& world, size_t thing, const Sentence& refused);

}  // namespace trivet
