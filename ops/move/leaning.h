// Which objects may be held by others that they do not touch.
//
// An object whose centre of mass is inside the hull of what it touches rests whatever else is near.
// Any other rests on contacts that are open by up to kBalanceTolerance clearances, too, and on what
// is in the way of the motions that would lower it: nothing farther away than its own size.
#pragma once

#include "ops/rest.h"

namespace trivet {

bool stands_on_its_own(const Object& object);

/// Those of `others` that may lean on an object, where the scene has it: to be rated again when it
/// leaves. By slot of `others`.
std::vector<ObjectId> leaning_on(const Scene& scene, const Object& object,
                                 const Surroundings& others);

/// Whether an object, where the scene has it, may lean on one of `others` or the floor.
bool leans_on_any(const Scene& scene, const Object& object, const Surroundings& others);

}  // namespace trivet
