// Parts of operations, shared by perform() and by moves that follow a hand.
#pragma once

#include "ops/operations/move_plan.h"
#include "ops/operations/pick_up.h"
#include "ops/operations/turn_axis.h"

namespace trivet {

/// Turns until collision or the angle is reached, as motions of at most a quarter turn;
/// result.turned_deg says how far.
/// @param axis  unit. @param free  through everything.
void rotate_group(MovePlanner& planner, const Vec3& centre, const Vec3& axis, double angle_deg,
                  bool free);

/// Straight on until the object is `offset` from where it is in the scene, or to collision.
void translate_group(MovePlanner& planner, const Vec3& offset, bool free);

/// Unit direction away from the contacts; nullopt: there are none, and it is refused.
std::optional<Vec3> pick_up_direction(MovePlanner& planner, const PickUpOperation& o);

/// Axis of a TURN; nullopt: there is no such contact, and it is refused.
std::optional<TurnAxis> axis_or_refusal(MovePlanner& planner, const TurnOperation& o);

/// Releases the object if that is asked for, and verifies where it is.
MovePlan finish_turn(MovePlanner& planner, const TurnOperation& o);
MovePlan finish_move(MovePlanner& planner, bool free, bool settle);

}  // namespace trivet
