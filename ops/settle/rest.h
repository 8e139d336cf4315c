// Rest of objects as they lie: whether they are held, and how well.
#pragma once

#include <vector>

#include "core/scene/friction.h"
#include "ops/base/options.h"
#include "ops/placement/contacts.h"
#include "ops/settle/equilibrium.h"

namespace trivet {

/// Rules by which rest is judged.
struct RestRules {
  double clearance = 0;  // metres, > 0
  bool perfect_friction = true;
};

RestRules rest_rules(const SettleOptions& options, double clearance);

/// For an object where the scene has it. Its links were within their tolerance when they were made:
/// they stay contacts where the scene, and with it the clearance, has become smaller since, by
/// kMostShrunk at most.
RestRules rules_by_links(const Object& object, const RestRules& rules);
inline constexpr double kMostShrunk = 2;

/// True if an object would be at rest at `pose`; see is_at_rest().
bool rests_at(const Object& object, const Pose& pose, const Neighbourhood& others,
              const RestRules& rules);

/// State of a free object at `pose`, by this alone: Stable where it rests; Wedged where it touches
/// something, does not rest, and no motion lowers it by more than the contacts' tolerance;
/// otherwise Unsupported: it would move, or nothing touches it.
ObjectState state_at(const Object& object, const Pose& pose, const Neighbourhood& others,
                     const RestRules& rules);

/// Neighbours that may hold an object where the scene has it: all but those that it passes through.
Neighbourhood holders(const Scene& scene, ObjectId id);

/// Contacts of an object of this surface, each with the friction of the pair; those at one place
/// are one.
std::vector<FrictionContact> friction_contacts(const Scene& scene, const Surface& surface,
                                               const std::vector<ContactsWith>& contacts,
                                               double distance);

/// Metres from `centre`, where the weight of an object acts, to where these contacts no longer
/// carry it; see Object::stability_margin.
double tipping_margin(const Scene& scene, const Object& object, const Vec3& centre,
                      const std::vector<ContactsWith>& contacts, const RestRules& rules);

/// Margin to tipping and least friction; see Object.
struct RestRating {
  double stability_margin = 0, least_friction = 0;
};
/// With finite friction an object that its contacts do not hold at its material's may be held by
/// them together with those within kCarryingTolerance clearances, as in settling: then these give
/// the least friction.
RestRating rate_rest(const Scene& scene, ObjectId id, const Pose& pose,
                     const std::vector<ContactsWith>& contacts, const RestRules& rules);
/// Rating of an object that contacts do not hold: no friction is enough, and none is looked for.
RestRating rate_unheld(const Scene& scene, const Object& object, const Pose& pose,
                       const std::vector<ContactsWith>& contacts, const RestRules& rules);

/// Rating of a placed object in its state and pose, by the scene's links: a function of shapes,
/// poses and materials alone, whatever led there. What is fixed has none: 0.
RestRating rating_by_links(const Scene& scene, ObjectId id, const RestRules& rules);

}  // namespace trivet
