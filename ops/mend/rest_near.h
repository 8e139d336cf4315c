// One object's nearest rest, among others that stand still. Private.
#pragma once

#include <functional>
#include <optional>

#include "ops/placement/neighbourhood.h"

namespace trivet {

/// The pose near the given one at which contacts can hold the object as it lies, leaning or between
/// others: parted from what it is in, then moved until these are closed. Nothing: no contacts
/// within the tolerance would hold it.
/// @param given  not placed; it is not placed afterwards, either. @param tolerance, clearance
/// metres. @param is_over  see GapsToClose.
std::optional<Pose> rest_near(Scene& scene, const Placement& given, double tolerance,
                              double clearance, const std::function<bool()>& is_over);

/// The same; if there is none, that of poses a little before and behind, along the motion by which
/// it falls. Noise may have taken it to a slope that is a little too steep, or across an edge.
std::optional<Pose> rest_near_or_beside(Scene& scene, const Placement& given, double tolerance,
                                        double clearance, const std::function<bool()>& is_over);

}  // namespace trivet
