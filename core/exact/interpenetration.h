// Exact test of whether two placed meshes cross or contain each other.
#pragma once

#include <functional>
#include <optional>

#include "core/base/types.h"
#include "core/index/shape.h"

namespace trivet {

/// Two faces that have a point in common.
struct CrossingPair {
  Index face_a, face_b;
};

/// World positions of a shape's vertices, one per vertex of its mesh.
using Positions = std::vector<Vec3>;

/// Transforms all vertices: the doubles of world_from_object.apply(vertex).
Positions world_positions(const Shape& shape, const Affine& world_from_object);

/// Shape in the world: its topology and BVH, and the positions of its vertices. `world_from_object`
/// maps the boxes of the BVH; it must agree with the positions to within `slack`.
struct PlacedShape {
  const Shape* shape;
  const Positions* positions;  // null: computed when needed
  Affine world_from_object;
  double slack = 0;  // metres; largest distance of a position from world_from_object x vertex
  /// Used when `positions` is null: maps a vertex (object frame) to the world; empty:
  /// world_from_object.apply().
  std::function<Vec3(const Vec3&)> placement = {};

  Vec3 position(Index vertex) const {
    if (positions) return (*positions)[vertex];
    const Vec3& v = shape->mesh.vertices[vertex];
    return placement ? placement(v) : world_from_object.apply(v);
  }
};

/// Counts intersecting pairs of faces, up to `limit`; touching counts. `first`, if given, receives
/// the pair with the smallest (face_a, face_b) among those found. Candidates come from the shapes'
/// BVHs, decisions from triangles_intersect().
std::int64_t count_crossings(const PlacedShape& a, const PlacedShape& b,
                             std::int64_t limit = std::numeric_limits<std::int64_t>::max(),
                             std::optional<CrossingPair>* first = nullptr);

/// Counts the components of `inner` inside a closed component of `outer`: by the winding number of
/// all balanced components together, and by parity for other components with even edges. Meaningful
/// only if the surfaces do not cross.
int count_components_inside(const PlacedShape& inner, const PlacedShape& outer);

}  // namespace trivet
