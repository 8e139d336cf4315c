// Friction of contacts, from the materials of both sides or by a rule for the pair; and pairs that
// do not collide.
#pragma once

#include "core/scene/scene.h"

namespace trivet {

/// Material of the partner of a contact: an object's or the floor's. Asserts that it is alive.
const PhysicsMaterial& material_of(const Scene& scene, const Support& support);

/// The friction of an object depends on these.
struct Surface {
  double friction = kDefaultFriction;  // of its material
  PairKind kind = 0;
};
inline Surface surface_of(const Object& object) {
  return {object.material.friction, object.pair_kind};
}

/// Coulomb's coefficient of a placed object against what it touches: a rule's for the pair, else
/// pair_friction().
double friction_between(const Scene& scene, const Surface& surface, const Support& with);
double friction_between(const Scene& scene, ObjectId object, const Support& with);

/// True if a rule lets the two, or an object and the floor, pass through each other.
bool may_pass(const Scene& scene, PairKind a, PairKind b);
inline bool may_pass(const Scene& scene, const Object& a, const Object& b) {
  return may_pass(scene, a.pair_kind, b.pair_kind);
}
inline bool may_pass_floor(const Scene& scene, const Object& object) {
  return may_pass(scene, object.pair_kind, scene.floor_kind);
}

}  // namespace trivet
