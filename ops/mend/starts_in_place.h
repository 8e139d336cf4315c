// Places of an object of a heap: parted from what it is in, and starts around that. Private.
#pragma once

#include <vector>

#include "ops/mend/intent.h"

namespace trivet {

inline constexpr double kAirOfParted = 2e-5;  // metres between an object and what it is parted from

/// `pose` out of each object that it passes through there, by the shortest way: up from what
/// carries it, sideways from others.
Pose parted(const Scene& scene, const ObjectIntent& meant, Pose pose);

/// The free pose, the same level if that was meant, then above it, beside it, and turned about
/// level axes. @param tolerance  metres: lifts and rings are parts of it.
std::vector<Pose> starts_in_place(const Scene& scene, const ObjectIntent& meant, const Pose& free,
                                  double tolerance);

}  // namespace trivet
