// Things in a container, and things that only lie on its rim.
#pragma once

#include "core/contact/body.h"
#include "core/scene/object.h"

namespace trivet {

/// True if the container has walls around the lowest point of a thing: level rays from just above
/// it meet the container in more than half of 16 directions. A compartment may be open to one side.
bool is_inside(const Body& thing, const Body& container);
bool is_inside(const Object& thing, const Object& container);

/// True if a thing could be inside at its middle, seen from above.
bool is_container(const Object& object);

}  // namespace trivet
