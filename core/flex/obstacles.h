// Triangles that do not move while something drapes over it.
#pragma once

#include "core/flex/body.h"
#include "core/flex/box_tree.h"

namespace trivet::flex {

/// Triangles in the world, each of an owner. Open, crossing and degenerate ones count as they are.
class Obstacles {
 public:
  /// @param friction  Coulomb's coefficient with what drapes; see Body.
  /// @return the owner's number.
  int add(const Points& vertices, std::span<const std::array<Index, 3>> triangles, double friction);
  /// To be called once, after the last add().
  void build();

  int num_owners() const { return static_cast<int>(m_friction.size()); }
  double friction(int owner) const { return m_friction[owner]; }
  const Points& vertices() const { return m_vertices; }
  const std::vector<std::array<int, 3>>& faces() const { return m_faces; }
  const std::vector<std::array<int, 2>>& edges() const { return m_edges; }
  int owner_of_vertex(int vertex) const { return m_owner[vertex]; }

  const BoxTree& vertex_tree() const { return m_vertex_tree; }
  const BoxTree& edge_tree() const { return m_edge_tree; }
  const BoxTree& face_tree() const { return m_face_tree; }

 private:
  Points m_vertices;
  std::vector<std::array<int, 3>> m_faces;
  std::vector<std::array<int, 2>> m_edges;
  std::vector<int> m_owner;  // of the vertices
  std::vector<double> m_friction;
  BoxTree m_vertex_tree, m_edge_tree, m_face_tree;
};

}  // namespace trivet::flex
