// A pile of objects.
#pragma once

#include "ops/operations/stage.h"

namespace trivet::test {

/// Fig. 6: a table with two objects on it, one of which carries a third; and a box beside it.
struct Pile : Stage {
  Pile() {
    put("table", box_triangles(Vec3(0.5, 0.5, 0.25)), {0, 0, 1});
    put("a", box_triangles(Vec3(0.1, 0.1, 0.1)), {-0.2, 0, 1});
    put("b", box_triangles(Vec3(0.1, 0.1, 0.1)), {0.2, 0, 1});
    put("c", box_triangles(Vec3(0.05, 0.05, 0.05)), {0.2, 0.05, 1});
    put("beside", box_triangles(Vec3(0.1, 0.1, 0.1)), {1, 0, 1});
  }
};

}  // namespace trivet::test
