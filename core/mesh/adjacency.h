// Winged-edge adjacency [Baumgart 1975], generalised to edges with any number of faces.
#pragma once

#include <span>
#include <vector>

#include "core/mesh/mesh.h"

namespace trivet {

/// One face at an edge.
struct Wing {
  Index face;
  bool forward;  // the face runs through the edge from its first to its second vertex
};

/// Rows of different lengths in one array.
template <class T>
struct Rows {
  std::vector<Index> offsets{0};  // #rows + 1
  std::vector<T> items;

  std::span<const T> operator[](Index row) const {
    return {items.data() + offsets[row], static_cast<size_t>(offsets[row + 1] - offsets[row])};
  }
  Index size() const { return static_cast<Index>(offsets.size()) - 1; }
};

/// Faces connected through edges.
struct Component {
  Index num_faces = 0;
  Index sample_vertex = 0;
  Aabb box;              // object frame
  bool even = true;      // every edge is used an even number of times: it has an inside by parity
  bool balanced = true;  // every edge is used as often in either direction: it has a signed volume
  bool manifold = true;  // every edge is used just once in either direction
  // For mass: -1 if triangles are wound the other way than the part's inside demands, which nesting
  // tells: of parts inside out, and of cavities wound as solids (core/mesh/solid_faces.h).
  int winding = 1;
  int depth = 0;  // closed components around this one; odd: a cavity
};

/// Incidence of vertices, edges and faces, both ways. Edges are numbered in the order in which
/// faces use them; a face with two equal corners has -1 for the edge between them.
struct Adjacency {
  std::vector<std::array<Index, 2>> edge_vertices;  // #E, smaller vertex id first
  std::vector<Index3> face_edges;                   // #F, edge k runs from corner k to corner k + 1
  Rows<Wing> edge_faces;                            // #E rows
  Rows<Index> vertex_faces;                         // #V rows
  Rows<Index> vertex_edges;                         // #V rows
  std::vector<Index> face_component;                // #F
  std::vector<Component> components;
};

Adjacency make_adjacency(const Mesh& mesh);

}  // namespace trivet
