// Triangle mesh without any precondition: open or closed, manifold or not, with slivers and
// duplicates.
#pragma once

#include <string>
#include <vector>

#include "core/base/types.h"

namespace trivet {

/// Welded triangles in the object frame. Vertices with equal coordinates are one vertex; every
/// triangle of the file is kept, degenerate ones included.
struct Mesh {
  std::vector<Vec3> vertices;     // #V, object frame, finite
  std::vector<Index3> triangles;  // #F, vertex ids, counter-clockwise seen from outside

  Triangle triangle(Index f) const {
    const Index3& t = triangles[f];
    return {vertices[t[0]], vertices[t[1]], vertices[t[2]]};
  }
  Aabb box() const;
};

/// Merges corners with equal coordinates (-0 equals 0). Triangles keep their order and number;
/// vertices are numbered in the order in which the triangles use them.
/// @throws Error (BadInput) when a corner is not finite.
Mesh weld(const std::vector<Triangle>& triangles);

}  // namespace trivet
