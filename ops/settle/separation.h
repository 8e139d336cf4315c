// Gaps that are too small, opened by the shortest way.
#pragma once

#include <vector>

#include "core/contact/contact.h"

namespace trivet {

/// The least translation d with normal . d >= clearance - gap for all contacts [Hildreth 1957].
Vec3 smallest_separating_motion(const std::vector<ContactPoint>& points, double clearance);

}  // namespace trivet
