// Start pose of a PUT to the point under the mouse.
#pragma once

#include "apps/edit/tools/picking.h"
#include "ops/operations/perform.h"

namespace trivet::edit {

/// Pose from which a PUT drops the object where the mouse points, in its current rotation: the
/// underside `height` metres above all below it. Under an overhang, a shelf's board, just above the
/// point, or above the low objects beside it; at a wall or an underside there, beside or below it.
/// @param moving  objects that move along, not obstacles. @param near  just above the point in any
///   case.
Pose put_start(const SceneSnapshot& scene, const Object& object,
               const std::vector<ObjectId>& moving, const Picked& at, double height, bool near);

/// Goals of drags are rounded to less than 1/this of a pixel.
inline constexpr double kGoalsPerPx = 4;

/// Rounded to the power of ten below `step`, for numbers with few digits.
double rounded(double value, double step);

}  // namespace trivet::edit
