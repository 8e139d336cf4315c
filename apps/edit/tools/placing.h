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

/// PUTs that bring the object to rest where the mouse points, the better ones first: from close to
/// that point, between what stands there; then as put_start(), with the tries of `put`.
/// @param object  in the rotation in which it is put. @param put  with its name and options.
/// @param lift  metres above that point.
std::vector<Operation> put_choices(const SceneSnapshot& scene, const Object& object,
                                   const std::vector<ObjectId>& moving, const Picked& at,
                                   PutOperation put, double drop_height, double lift = 0);

/// Tries of a PUT whose ghost follows the mouse: its next place is another try.
inline constexpr int kTriesInHand = 2;

/// The place of an object that is turned where it is: below its centre of mass, at its underside.
Picked place_of(const Object& object);

/// True if a face is too steep to put something on.
bool is_wall(const Picked& at);

/// Goals of drags are rounded to less than 1/this of a pixel.
inline constexpr double kGoalsPerPx = 4;

/// Rounded to the power of ten below `step`, for numbers with few digits.
double rounded(double value, double step);

}  // namespace trivet::edit
