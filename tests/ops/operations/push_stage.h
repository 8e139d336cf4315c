// A box on a table, for PUSH.
#pragma once

#include "ops/operations/stage.h"

namespace trivet::test {

/// A box of half extents 0.1 on a table whose top is at z = 0.5.
struct Table : Stage {
  explicit Table(bool slab = false) {
    fix("table", box_triangles(Vec3(1, 1, 0.25)), {0, 0, 0.25 + 1e-5});
    if (slab) fix("slab", box_triangles(Vec3(0.2, 0.5, 0.01)), {-0.7, 0, top() + 0.01 + 1e-5});
    put("box", box_triangles(Vec3(0.1, 0.1, 0.1)), {-0.5, 0, 1});
  }
  double top() const { return 0.5 + 1e-5; }
};

inline PushOperation push(double x, double y, double distance) {
  PushOperation o;
  o.object = "box";
  o.direction = Vec2(x, y);
  o.distance = distance;
  return o;
}

}  // namespace trivet::test
