// Pairs of vertices, edges and faces that may come near each other, and their closest points.
#pragma once

#include <functional>

#include "core/flex/obstacles.h"

namespace trivet::flex {

enum class PairKind : std::uint8_t { VertexFace, EdgeEdge, FaceVertex, OwnVertexFace, OwnEdgeEdge };

/// `a` of the body; `b` of the obstacles, or, of the last two kinds, of the body as well.
struct NearPair {
  PairKind kind;
  int a, b;

  bool is_own() const { return kind >= PairKind::OwnVertexFace; }
};

/// The difference of the closest points: sum of weights x vertices, less the obstacle's point.
struct PairPoints {
  int count = 0;  // of the body's vertices
  int first = 0;  // of them on the side to which the difference points; the others on the other
  std::array<int, 4> vertices{};
  std::array<double, 4> weights{};  // of the second side: negative
  Vec3 difference;
  double distance = 0;
  int num_fixed = 0;
  std::array<int, 3> fixed{};  // the obstacle's vertices
  // Parameters that are free where the points are: derivatives by them of difference and weights.
  int num_free = 0;
  std::array<Vec3, 2> slope{};
  std::array<std::array<double, 4>, 2> weight_slope{};
  Vec3 edge_a = Vec3::Zero(), edge_b = Vec3::Zero();  // of two edges

  Vec3 direction() const { return difference / distance; }
};

/// Vertices of the body in a pair; some may come twice.
using BodyVertices = std::array<int, 6>;

/// Pairs at most: a hostile file may have everything in one place.
inline constexpr size_t kMostPairs = size_t{1} << 24;

/// The body among the obstacles: which elements are near each other.
class Surroundings {
 public:
  Surroundings(const Body& body, const Obstacles& obstacles);

  const Body& body() const { return m_body; }
  const Obstacles& obstacles() const { return m_obstacles; }
  /// Neighbours along a cable, within three diameters, do not count.
  bool are_neighbours(const NearPair& pair) const;

  /// All pairs whose boxes are no farther apart than a margin, sorted by kind, then as the trees
  /// have them. @param boxes  of the vertices; those of edges and faces hold theirs.
  /// @param margin  from obstacles; @param own_margin  from itself; both in metres.
  /// @param wanted  other pairs are left out; called by several threads.
  /// @return false if there are more than kMostPairs; `out` is empty then.
  bool find(
      std::span<const Aabb> boxes, double margin, double own_margin, std::vector<NearPair>& out,
      const std::function<bool(const NearPair&)>& wanted = [](const NearPair&) { return true; });

  PairPoints points(const NearPair& pair, const Points& x) const;
  BodyVertices body_vertices(const NearPair& pair) const;

 private:
  PairPoints vertex_face(const NearPair& pair, const Points& x) const;
  PairPoints face_vertex(const NearPair& pair, const Points& x) const;
  PairPoints edge_edge(const NearPair& pair, const Points& x) const;
  PairPoints own_vertex_face(const NearPair& pair, const Points& x) const;
  PairPoints own_edge_edge(const NearPair& pair, const Points& x) const;

  const Body& m_body;
  const Obstacles& m_obstacles;
  BoxTree m_edge_tree, m_face_tree;  // of the body
};

}  // namespace trivet::flex
