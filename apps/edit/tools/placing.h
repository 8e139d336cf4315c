// Where an object is let go so that it comes down where the mouse points.
#pragma once

#include "apps/edit/tools/picking.h"
#include "ops/operations/perform.h"

namespace trivet::edit {

/// The pose from which a PUT lets the object fall onto `point`: its centre of mass over it, as it
/// is turned now.
/// @param height  metres; of its underside above the highest box below it or, with `near`, above
///   the point. @param moving  what moves along, and is no obstacle.
Pose put_start(const SceneSnapshot& scene, const Object& object,
               const std::vector<ObjectId>& moving, const Vec3& point, double height, bool near);

/// Rounded to the power of ten next below `step`, so that it is written with few digits.
double rounded(double value, double step);

}  // namespace trivet::edit
