// A flexible object judged again where it is, from its positions and the friction that was stored.
#pragma once

#include "core/flex/flexible.h"
#include "core/flex/obstacles.h"

namespace trivet::flex {

/// The largest net force at a vertex by which it counts as at rest, of its weight.
inline constexpr double kRestingForce = 1e-2;

struct Judgement {
  bool crosses_itself = false, crosses_itself_in_float32 = false;
  bool is_clear = true;  // no obstacle is nearer than half its thickness
  bool is_held = true;   // its holders are where its pins are
  double net_force = 0;  // the largest at a vertex that no pin holds, of its weight; if it is clear
  bool is_at_rest() const { return is_clear && is_held && net_force < kRestingForce; }
};

Points moved(const Points& x, const Affine& by);

/// @param world_from_object  rigid.
Judgement judge(const Flexible& flexible, const Affine& world_from_object,
                const Obstacles& obstacles);

}  // namespace trivet::flex
