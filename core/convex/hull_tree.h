// Convex parts of a mesh that follow it as closely as is asked for, where it is asked for.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "core/convex/parts.h"

namespace trivet {

class HullMemo;

/// A hull for each component of a mesh (of more than kMaxParts: one for all), and below it hulls of
/// halves of its faces, down to single triangles, made when refine() asks for them. The leaves are
/// the parts: together their hulls contain the whole surface, and the more of them there are the
/// less they contain beside it. Parts thinner than a shell, such as those of a wall's one side, are
/// thickened behind their faces by what is missing, or by less where refine() says that there is no
/// room.
class HullTree {
 public:
  /// @param mesh  in the unit and frame of the parts; outlives this, like `adjacency`, of the same
  ///   faces. @param shell  metres (units of the mesh).
  /// @param memo  of trees of the same mesh and shell, or null; outlives this.
  HullTree(const Mesh& mesh, const Adjacency& adjacency, double shell, HullMemo* memo = nullptr);

  struct Node {
    ConvexPart part;
    Aabb box;
    std::vector<Index> faces;         // of a leaf
    std::array<Index, 2> children{};  // 0, 0: a leaf
    double backing = 0;               // thickness that it was given behind its faces; 0: none
    bool solid = false;               // a closed component that fills nearly all of its hull
    bool is_leaf() const { return children[0] == 0; }
  };
  const Node& node(Index i) const { return m_nodes[i]; }
  Index num_nodes() const { return static_cast<Index>(m_nodes.size()); }
  Index num_roots() const { return m_num_roots; }  // nodes 0, 1, ...
  size_t num_leaves() const { return m_num_leaves; }
  std::vector<ConvexPart> parts() const;  // of the leaves

  /// A closer fit of this leaf: with half of what is behind its faces, at last without, or as two.
  /// @return whether there is one; not of a single triangle, nor of a convex solid.
  bool refine(Index leaf);

 private:
  Node make_node(std::vector<Index> faces, double shell) const;
  Node known_node(std::vector<Index> faces, double shell) const;
  std::array<std::vector<Index>, 2> halves(const std::vector<Index>& faces) const;
  std::vector<Vec3> backed_corners(std::span<const Index> faces, double shell) const;
  double filled_part(Index root) const;

  const Mesh& m_mesh;
  const Adjacency& m_adjacency;
  const double m_shell;
  HullMemo* const m_memo;
  std::vector<Node> m_nodes;
  std::vector<bool> m_is_convex;  // of the roots
  Index m_num_roots = 0;
  size_t m_num_leaves = 0;
};

}  // namespace trivet
