// Convex parts of a mesh that follow it as closely as is asked for, where it is asked for.
#pragma once

#include <array>
#include <compare>
#include <memory>
#include <span>
#include <vector>

#include "core/convex/parts.h"

namespace trivet {

class HullMemo;

/// Least thickness of parts, by what is added behind their faces.
struct PartThickness {
  double shell = 0;                  // of all, units of the mesh
  double flat = kFlatPartThickness;  // of flat ones, relative to their size
  auto operator<=>(const PartThickness&) const = default;
};

/// A hull for each component of a mesh (of more than kMaxParts: one for all), and below it hulls of
/// halves of its faces, down to single triangles, made when refine() asks for them. The leaves are
/// the parts: together their hulls contain the whole surface, and the more of them there are the
/// less they contain beside it. Parts thinner than a shell, such as those of a wall's one side, are
/// thickened behind their faces by what is missing, or by less where refine() says that there is no
/// room. Flat parts have kFlatPartThickness behind their faces at least, or less where thin() says
/// so.
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
    double flat = 0;                  // the same, as it is flat; 0: it is not
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
  /// The same leaf with a quarter of the thickness that it has as it is flat. @return whether it is
  /// thinner now; not of one that is not flat, nor one as thin as rounding allows.
  bool thin(Index leaf);

 private:
  Node make_node(std::vector<Index> faces, const PartThickness& thickness) const;
  Node known_node(std::vector<Index> faces, const PartThickness& thickness) const;
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
