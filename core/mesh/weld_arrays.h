// Meshes from arrays, as programs have them.
#pragma once

#include <span>
#include <vector>

#include "core/mesh/mesh.h"

namespace trivet {

/// A mesh from arrays.
struct WeldedMesh {
  Mesh mesh;
  std::vector<Index> new_id;  // #V of the given vertices: theirs in `mesh`; -1: in no triangle
};

/// Merges vertices with equal coordinates, as weld() of the triangles, and leaves out those that no
/// triangle uses. Triangles keep their order and number, degenerate ones included.
/// @param vertices   #V x 3, any unit.
/// @param triangles  #F x 3, vertex ids, counter-clockwise seen from outside.
/// @throws Error (BadInput) naming the row: a coordinate that is not finite, an id out of range;
/// and
///   when there is no triangle, or more of something than Index can count.   Cost O(#V + #F).
WeldedMesh weld(std::span<const Vec3> vertices, std::span<const Index3> triangles);

}  // namespace trivet
