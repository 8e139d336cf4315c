// Gives an object its mass.
#pragma once

#include "core/mesh/given_mass.h"

namespace trivet {

struct Object;

/// Gives the object this mass: from now on its shape has this centre and inertia. The mass must be
/// accepted; up axis and scale of the object must be what they stay.
void give_mass(const GivenMass& mass, Object& object);

}  // namespace trivet
