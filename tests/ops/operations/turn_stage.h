// A box on the floor, for TURN.
#pragma once

#include "ops/operations/stage.h"

namespace trivet::test {

/// A box of half extents 0.2, 0.1, 0.3 on the floor.
struct BoxOnFloor : Stage {
  BoxOnFloor() { put("box", box_triangles(Vec3(0.2, 0.1, 0.3)), {0, 0, 1}); }
};

inline TurnOperation turn(TurnOperation::About about, double angle_deg) {
  TurnOperation o;
  o.object = "box";
  o.about = about;
  o.angle_deg = angle_deg;
  return o;
}

}  // namespace trivet::test
