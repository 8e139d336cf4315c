// Private. What of a mesh bounds solids: faces once, wound alike, by parts.
#pragma once

#include <cstdint>

#include "core/mesh/adjacency.h"

namespace trivet {

struct SolidFaces {
  // #F: +1 as wound, -1 turned round, 0 left out; empty: +1 for all.
  std::vector<std::int8_t> weights;
  std::vector<char> closed;  // #components: 1 if these faces bound a solid
  Index num_double = 0, num_flipped = 0;

  double weight(Index face) const { return weights.empty() ? 1 : weights[face]; }
};

/// Faces of the same three corners count once, the first one as it is wound, and so do flat patches
/// of the same outline, however they are cut into triangles. If each edge of a part then has two
/// faces, they are turned to run through it in opposite directions; most of a part's faces stay as
/// they are. Else pairs of such faces are left out as walls between solids that share corners, if
/// that closes the part. Parts that are balanced as they are stay as they are.
SolidFaces solid_faces(const Mesh& mesh, const Adjacency& adjacency);

/// Fills depth and winding of the components: closed parts within closed parts, in turn solids and
/// cavities. Samples of a part's faces decide, so that parts that pass through each other count
/// as side by side unless all samples are inside.
/// Cost O(F) and for parts within others that of rays through columns of faces.
void nest_components(const Mesh& mesh, const SolidFaces& solid, Adjacency& adjacency);

}  // namespace trivet
