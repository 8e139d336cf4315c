// The parts of operations, for what does them at once and for what follows a hand.
#pragma once

#include "ops/move/attempt.h"
#include "ops/move/turn_axis.h"

namespace trivet {

/// Turns until collision or the angle is reached, as motions of at most a quarter turn;
/// result.turned_deg says how far.
/// @param axis  unit. @param free  through everything.
void rotate_group(Attempt& attempt, const Vec3& centre, const Vec3& axis, double angle_deg,
                  bool free);

/// Straight on, to where the object shall be `offset` from where it stands in the scene, or to
/// collision.
void translate_group(Attempt& attempt, const Vec3& offset, bool free);

/// Away from what the contacts are with, unit. Nothing: there are none; it is refused.
std::optional<Vec3> pick_up_direction(Attempt& attempt, const PickUpOperation& o);

/// Nothing: there is no such contact; it is refused.
std::optional<TurnAxis> axis_or_refusal(Attempt& attempt, const TurnOperation& o);

/// Lets go if that is asked for, and commits.
OperationResult finish_turn(Attempt& attempt, const TurnOperation& o);
OperationResult finish_move(Attempt& attempt, bool free, bool settle);

}  // namespace trivet
