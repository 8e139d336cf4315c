// The friction that an object needs to stay where it is.
#pragma once

#include <vector>

#include "core/contact/contact.h"

namespace trivet {

/// Smallest friction coefficient with which contacts hold a weight, see friction_residual(), to 1
/// %: a number of a fixed grid, whatever the way to it.
/// @param centre  of mass, world. @param size  metres, of the object.
/// @param tolerance  of the residual.
/// @return 0 to kLargestFriction; infinity when even that does not do.
double least_friction(const std::vector<ContactPoint>& contacts, const Vec3& centre, double size,
                      double tolerance);

}  // namespace trivet
