// Contacts, rest and links of objects as they lie: what put(), stand() and check share.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/contact/body.h"
#include "core/scene/scene.h"
#include "ops/settle/settle.h"

namespace trivet {

/// The other placed objects, as bodies, with their ids.
struct Surroundings {
  std::vector<ObjectId> ids;
  std::vector<Body> bodies;

  Surroundings(const Scene& scene, ObjectId except);
  Surroundings(const Scene& scene, std::span<const ObjectId> except);
  /// "the floor" or the quoted name.
  std::string name(const Scene& scene, Index fixed) const;
};

/// Whether an object would be at rest at `pose`; see is_at_rest().
bool rests_at(const Scene& scene, const Object& object, const Pose& pose,
              const Surroundings& others, double clearance);

/// What an object at `pose` touches, within kContactTolerance clearances.
std::vector<ContactsWith> touching(const Scene& scene, const Object& object, const Pose& pose,
                                   const Surroundings& others, double clearance);

/// Contacts of an object at `pose` as links.
std::vector<Link> links_of(const Object& object, const Pose& pose, const Surroundings& others,
                           const std::vector<ContactsWith>& contacts, double clearance);

/// How well the contacts hold an object: margin and friction.
struct RestRating {
  double stability_margin = 0, least_friction = 0;
};
RestRating rate_rest(const Object& object, const Pose& pose,
                     const std::vector<ContactsWith>& contacts, double clearance);

/// Gives the object its pose and state, rates its rest and links it with what it touches.
void commit(Scene& scene, ObjectId id, const Pose& pose, ObjectState state,
            const Surroundings& others, const std::vector<ContactsWith>& contacts,
            double clearance);

}  // namespace trivet
