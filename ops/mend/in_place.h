// Heaps: objects that hold each other up, freed and settled where they are. Private.
#pragma once

#include "ops/mend/intent.h"
#include "ops/mend/mend.h"

namespace trivet {

/// True if so many objects lie tilted, on the floor, on several others or on tilted ones, that they
/// hold each other up: there is no order in which each finds all that carries it.
bool is_heap(const Intent& meant, const std::vector<ObjectId>& moving);

/// First all objects are parted, bottom up; then each that does not rest is let go from where it
/// is, with all others there, in several rounds. What is not at rest then is given up.
/// @param order  what is below before what is above.
SettledScene mend_in_place(Scene& scene, const MendOptions& options, const Deadline& deadline,
                           const Intent& meant, const std::vector<ObjectId>& order);

}  // namespace trivet
