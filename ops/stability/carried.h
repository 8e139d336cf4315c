// Whom the whole has an object carry, where no contact from below shows it.
#pragma once

#include <algorithm>
#include <vector>

#include "ops/stability/stability.h"

namespace trivet {

/// True if its links say that what is more than the tolerance of contacts away carries it.
inline bool is_carried_across_gap(const Object& object) {
  return std::any_of(object.contacts.begin(), object.contacts.end(),
                     [](const ObjectContact& entry) { return entry.across_gap && entry.carries; });
}

/// Carried by the forces that balance an object's part of the scene; see stability_of_part(). None
/// where the scene's links alone prove that the part stands, as they name all carriers then; where
/// it is not known to stand; or where it has more than kMostAskedForCarriers objects.
std::vector<CarriedBy> carried_by_part(const Scene& scene, ObjectId object,
                                       const StabilityOptions& options = {});
inline constexpr size_t kMostAskedForCarriers = 120;  // a third of a second

}  // namespace trivet
