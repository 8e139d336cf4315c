// Start pose of a PUT to the point under the mouse.
#pragma once

#include "apps/edit/tools/picking.h"
#include "ops/operations/perform.h"

namespace trivet::edit {

/// Pose from which a PUT drops the object onto `point`: centre of mass above it, current rotation.
/// @param height  metres; of its underside above the highest box below it or, with `near`, above
///   the point. @param moving  objects that move along, not obstacles.
Pose put_start(const SceneSnapshot& scene, const Object& object,
               const std::vector<ObjectId>& moving, const Vec3& point, double height, bool near);

/// Goals of drags are rounded to less than 1/this of a pixel.
inline constexpr double kGoalsPerPx = 4;

/// Rounded to the power of ten below `step`, for numbers with few digits.
double rounded(double value, double step);

}  // namespace trivet::edit
