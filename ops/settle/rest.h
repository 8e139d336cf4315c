// Rest of objects as they lie: whether they are held, and how well.
#pragma once

#include <vector>

#include "ops/placement/contacts.h"

namespace trivet {

/// Whether an object would be at rest at `pose`; see is_at_rest().
bool rests_at(const Object& object, const Pose& pose, const Neighbourhood& others,
              double clearance);

/// Neighbours that may hold an object where the scene has it: all but those that it passes through.
Neighbourhood holders(const Scene& scene, ObjectId id);

/// Margin to tipping and least friction; see Object.
struct RestRating {
  double stability_margin = 0, least_friction = 0;
};
RestRating rate_rest(const Object& object, const Pose& pose,
                     const std::vector<ContactsWith>& contacts, double clearance);
/// Rating of an object that contacts do not hold: no friction is enough, and none is looked for.
RestRating rate_unheld(const Object& object, const Pose& pose,
                       const std::vector<ContactsWith>& contacts, double clearance);

}  // namespace trivet
