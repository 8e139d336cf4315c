// Objects that may be held by others that they do not touch.
//
// An object whose centre of mass is inside the support polygon of its contacts rests whatever else
// is near. Any other also rests on contacts that are open by up to kCarryingTolerance clearances,
// and on what obstructs the motions that would lower it: nothing farther away than its own size.
#pragma once

#include "ops/settle/rest.h"

namespace trivet {

/// Objects outside a group that may lean on a member of it, where the scene has it: to be rated
/// again when it leaves. In the order of the scene.
std::vector<ObjectId> leaning_on(const Scene& scene, const Object& object,
                                 const Neighbourhood& outside);

}  // namespace trivet
