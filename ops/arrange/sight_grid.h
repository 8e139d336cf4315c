// Private. Grids of rays by which relations of sight are judged.
#pragma once

#include <vector>

#include "core/index/ray.h"

namespace trivet {

/// One of the 8 corners.
Vec3 corner_of(const Aabb& box, int i);

/// From the eye to the centres of a grid of 8 x 8 on the rectangle that holds the box as it is
/// seen, as far as that lies within 76 degrees of the box's centre. One ray to the centre where the
/// eye is in the box, or nearly; none where it is that centre.
std::vector<Ray> rays_to(const Vec3& eye, const Aabb& box);

/// Down to the centres of a grid of 8 x 8 on the box, from a micrometre over it.
std::vector<Ray> rays_down_to(const Aabb& box);

}  // namespace trivet
