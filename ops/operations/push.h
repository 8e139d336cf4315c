// PUSH/PULL [Shinya 1995, 4.1, Fig. 4]: along the surface on which the object lies. See
// push_events.h for its states.
#pragma once

#include "ops/operations/move_options.h"

namespace trivet {

/// Along the surface on which the object lies, or any other that it touches. "push"
struct PushOperation : JointMoveOptions {
  Vec2 direction = Vec2::UnitX();  // seen from above, of any length but zero
  double distance = 0;             // metres along `direction`, seen from above
  std::optional<Vec2> to;          // instead: target of the object's position, seen from above
  double step_up = 0.01;           // metres; higher steps stop it
  double step_down = 0.01;         // metres; from higher edges it is pulled back
  bool slide = true;               // along walls; otherwise they stop it
  bool settle = true;              // release it at the end; otherwise it is held
  std::vector<Vec2> via = {};      // waypoints, as `to`
  Vec3 normal = Vec3::UnitZ();     // of the surface, towards the object, of any length but zero:
                                   // "above" is there; see push_axes() for the plane's two axes
};

template <>
const OperationTable& table<PushOperation>();
MovePlan plan(const Scene& scene, ObjectId id, const PushOperation& o, OperationRun& run);

}  // namespace trivet
