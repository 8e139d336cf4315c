// Contacts, rest and links of objects as they lie: what put(), stand() and check share.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/contact/body.h"
#include "core/scene/scene.h"
#include "ops/settle/settle.h"

namespace trivet {

/// The other placed objects, as bodies, with their ids, and the floor.
struct Surroundings {
  std::vector<ObjectId> ids;
  std::vector<Body> bodies;
  bool floor = true;

  Surroundings(const Scene& scene, ObjectId except);
  Surroundings(const Scene& scene, std::span<const ObjectId> except);
  /// All but these; no id: the floor.
  void leave_out(std::span<const std::optional<ObjectId>> left_out);
  /// "the floor" or the quoted name.
  std::string name(const Scene& scene, Index fixed) const;
};

/// What may hold an object where the scene has it: all others but those that it passes through.
Surroundings holders(const Scene& scene, ObjectId id);

/// Whether an object would be at rest at `pose`; see is_at_rest().
bool rests_at(const Object& object, const Pose& pose, const Surroundings& others, double clearance);

/// What an object at `pose` touches, within kContactTolerance clearances.
std::vector<ContactsWith> touching(const Object& object, const Pose& pose,
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
/// Of what contacts do not hold: no friction is enough, and none has to be looked for.
RestRating rate_unheld(const Object& object, const Pose& pose,
                       const std::vector<ContactsWith>& contacts, double clearance);

/// Gives the object its pose and state, rates its rest and links it with what it touches.
void commit(Scene& scene, ObjectId id, const Pose& pose, ObjectState state,
            const Surroundings& others, const std::vector<ContactsWith>& contacts,
            double clearance);

}  // namespace trivet
