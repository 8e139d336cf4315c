// Things in a container, and things that only lie on its rim.
#pragma once

#include "core/scene/object.h"

namespace trivet {

/// True if the container has walls around the lowest point of a thing: level rays from just above
/// it meet the container in more than half of 16 directions. A compartment may be open to one side.
bool is_inside(const Object& thing, const Object& container);

}  // namespace trivet
