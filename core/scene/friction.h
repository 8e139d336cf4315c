// Friction of contacts, from the materials of both sides.
#pragma once

#include "core/scene/scene.h"

namespace trivet {

/// Material of the partner of a contact: an object's or the floor's. Asserts that it is alive.
const PhysicsMaterial& material_of(const Scene& scene, const Support& support);

/// Coulomb's coefficient of a placed object against what it touches. See pair_friction().
double friction_between(const Scene& scene, ObjectId object, const Support& with);

}  // namespace trivet
