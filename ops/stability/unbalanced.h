// A proof that forces of contacts do not balance a part, without a linear program. Private.
#pragma once

#include "ops/stability/contact_forces.h"

namespace trivet {

/// True if the motion of a larger part that does not stand proves that some of these bodies lack a
/// hundredth of their weight, whichever touches join: no contact hinders it, and gravity drives it.
/// False: contact_forces() knows.
/// @param larger  holds more bodies than `part`. @param forces_of_larger  its contact_forces().
bool clearly_unbalanced(const FreeBodies& part, double clearance, const FreeBodies& larger,
                        const PartForces& forces_of_larger);

}  // namespace trivet
