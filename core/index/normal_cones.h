// Directions in which the features of a shape may touch others, by faces and by nodes of its BVH.
#pragma once

#include <array>
#include <vector>

#include "core/index/shape.h"

namespace trivet {

/// All directions within an angle of an axis, object frame. Rounded outwards, to float.
struct NormalCone {
  std::array<float, 3> axis{};
  float cos = -1, sin = 0;  // of the angle; a cosine above 1: no direction at all

  static NormalCone none() { return {{}, 2, 0}; }
  bool is_none() const { return cos > 1; }
};

/// Spatialized normal cones [Johnson 2001], of what contact_points() finds. A vertex or an edge
/// touches along no direction beside which a neighbour rises by more than kConeSlope: there the
/// surface goes on, and is nearer. The sets of such directions are bounded exactly, not by the
/// normals of faces, as neighbours of a vertex need not be convex.
///
/// A flat surface has nothing that rises beside its features on either side, and what is behind
/// them touches them, too: through the body. So there are two cones, of either side of the surface.
///
/// They hold for a body whose coordinates are below kFarOfCones times its box's diagonal, and for
/// feet outside faces by kSlackOfCones times that at most: all rounding is allowed for so far.
struct NormalCones {
  /// A face, or all faces of a node of the BVH.
  struct Part {
    NormalCone outwards, inwards;  // of vertices and edges
    NormalCone normals;            // of faces
  };
  std::vector<Part> faces, nodes;
  /// Vertices, and edges with their ends, have no normals.
  std::vector<Part> vertices, edges;
};

inline constexpr double kFarOfCones = 1e4, kSlackOfCones = 1e-4;

/// Made when first asked for, and kept with the shape. Cost O(n log n). Thread-safe.
const NormalCones& normal_cones_of(const Shape& shape);
bool has_normal_cones(const Shape& shape);

}  // namespace trivet
