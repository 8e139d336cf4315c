#include "core/mesh/solid_faces.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <utility>

namespace trivet {
namespace {

/// Clears up one part that is not a clean solid.
class PartCleaner {
 public:
  PartCleaner(const Mesh& mesh, const Adjacency& adjacency, SolidFaces& out)
      : m_mesh(mesh), m_adjacency(adjacency), m_out(out), m_turn(mesh.triangles.size(), 0) {}

  void clean(Index component, const std::vector<Index>& all) {
    // Copies are tried first: one of each is kept, and the rest may be a solid.
    std::vector<Index> faces = all;
    Index num_double = drop_copies(faces, Copies::KeepOne);
    bool closed = orient(faces) || (num_double == 0 && m_adjacency.components[component].balanced);
    // The copies may also be walls between solids side by side: both faces go then, the outside
    // remains.
    if (!closed && num_double > 0) {
      std::vector<Index> outer = all;
      const Index num_walls = drop_copies(outer, Copies::DropPairs);
      closed = orient(outer) || is_balanced(outer);
      // The part stays open, with one face of each, if neither closes it.
      num_double = closed ? num_walls : drop_copies(faces = all, Copies::KeepOne);
    }
    m_out.num_double += num_double;
    m_out.closed[component] = closed;
  }

 private:
  /// A solid's faces that are there twice have copies; solids side by side have walls in between.
  enum class Copies { KeepOne, DropPairs };

  static size_t num_kept(size_t num, Copies copies) {
    return copies == Copies::KeepOne ? 1 : num % 2;
  }

  // All faces count as wound at first. @return how many are left out.
  Index drop_copies(std::vector<Index>& faces, Copies copies) {
    m_is_reached.resize(m_mesh.triangles.size(), 0);
    for (const Index f : faces) m_out.weights[f] = 1, m_turn[f] = 0, m_is_reached[f] = 0;
    const Index count = drop_double(faces, copies);
    return count + drop_double_patches(faces, copies);
  }

  // Each edge is run through as often forward as backward. False without faces.
  bool is_balanced(const std::vector<Index>& faces) const {
    // Each edge's wings are summed over the faces that are kept.
    for (const Index face : faces)
      for (const Index edge : m_adjacency.face_edges[face]) {
        int sum = 0;
        for (const Wing& wing : m_adjacency.edge_faces[edge])
          if (is_kept(wing.face)) sum += wing.forward ? 1 : -1;
        if (sum != 0) return false;
      }
    return !faces.empty();
  }

  // Faces without area bound nothing, and stay.
  static bool is_flat(const Index3& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }

  // Faces with the same corners.
  Index drop_double(std::vector<Index>& faces, Copies copies) {
    std::vector<std::pair<Index3, Index>> sorted;
    // Corners in order make faces equal whatever their first corner and winding.
    for (const Index f : faces) {
      Index3 corners = m_mesh.triangles[f];
      std::sort(corners.begin(), corners.end());
      if (!is_flat(corners)) sorted.emplace_back(corners, f);
    }
    std::sort(sorted.begin(), sorted.end());
    Index count = 0;
    for (size_t i = 0, end = 0; i < sorted.size(); i = end) {
      // Equal faces are neighbours now; copies beyond those that are kept get no weight.
      while (end < sorted.size() && sorted[end].first == sorted[i].first) ++end;
      for (size_t k = i + num_kept(end - i, copies); k < end; ++k, ++count)
        m_out.weights[sorted[k].second] = 0;
    }
    std::erase_if(faces,
                  [&](Index f) { return m_out.weights[f] == 0 || is_flat(m_mesh.triangles[f]); });
    return count;
  }

  /// Faces joined by edges that have two faces, up to edges that have more.
  struct Patch {
    std::vector<Index> faces, outline;  // sorted edges
    Vec3 normal = Vec3::Zero();         // as long as twice the area, if it is flat
    double size = 0;                    // twice the area

    bool is_flat() const { return normal.norm() >= (1 - 1e-6) * size; }
  };

  Patch patch_of(Index first) {
    Patch out{{first}, {}, Vec3::Zero(), 0};
    m_is_reached[first] = 1;
    // The patch grows over edges of exactly two faces.
    for (size_t i = 0; i < out.faces.size(); ++i) {
      const Triangle t = m_mesh.triangle(out.faces[i]);
      const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]);
      out.normal += normal;
      out.size += normal.norm();
      for (const Index edge : m_adjacency.face_edges[out.faces[i]]) {
        const Index other = across(out.faces[i], edge);
        // An edge where it cannot go on is part of the outline.
        if (other < 0)
          out.outline.push_back(edge);
        else if (!m_is_reached[other])
          m_is_reached[other] = 1, out.faces.push_back(other);
      }
    }
    std::sort(out.outline.begin(), out.outline.end());
    return out;
  }

  // Polygons that were cut along other diagonals.
  Index drop_double_patches(std::vector<Index>& faces, Copies copies) {
    // Two flat patches of one outline are the same polygon.
    std::map<std::vector<Index>, std::vector<std::vector<Index>>> of_outlines;
    for (const Index first : faces) {
      if (m_is_reached[first]) continue;
      Patch patch = patch_of(first);
      if (!patch.outline.empty() && patch.is_flat())
        of_outlines[std::move(patch.outline)].push_back(std::move(patch.faces));
    }
    Index count = 0;
    for (const auto& [outline, patches] : of_outlines)
      for (size_t k = num_kept(patches.size(), copies); k < patches.size(); ++k)
        for (const Index f : patches[k]) m_out.weights[f] = 0, ++count;
    std::erase_if(faces, [&](Index f) { return m_out.weights[f] == 0; });
    return count;
  }

  // The other face at an edge; -1: there is not just one.
  Index across(Index face, Index edge) const {
    Index other = -1;
    for (const Wing& wing : m_adjacency.edge_faces[edge]) {
      if (wing.face == face || !is_kept(wing.face)) continue;
      if (other >= 0) return -1;
      other = wing.face;
    }
    return other;
  }

  bool is_kept(Index face) const {
    return m_out.weights[face] != 0 && !is_flat(m_mesh.triangles[face]);
  }

  bool runs_forward(Index face, Index edge) const {
    for (const Wing& wing : m_adjacency.edge_faces[edge])
      if (wing.face == face) return wing.forward;
    return false;
  }

  // False: an edge has not two faces, or they cannot all be turned alike; faces stay then.
  bool orient(const std::vector<Index>& faces) {
    const Index num_flipped = m_out.num_flipped;
    for (const Index first : faces) {
      if (m_turn[first] != 0) continue;
      // Without its copies a part may be in pieces: each is oriented from its first face.
      std::vector<Index> reached{first};
      m_turn[first] = 1;
      for (size_t i = 0; i < reached.size(); ++i)
        if (!reach_neighbours(reached[i], reached)) return m_out.num_flipped = num_flipped, false;
      keep_most(reached);
    }
    for (const Index face : faces) m_out.weights[face] = m_turn[face];
    return !faces.empty();
  }

  bool reach_neighbours(Index face, std::vector<Index>& reached) {
    for (const Index edge : m_adjacency.face_edges[face]) {
      const Index other = across(face, edge);
      if (other < 0) return false;
      // Two faces agree if they run along their edge in opposite directions.
      const bool alike = runs_forward(face, edge) != runs_forward(other, edge);
      const auto wanted = static_cast<std::int8_t>(alike ? m_turn[face] : -m_turn[face]);
      if (m_turn[other] == 0) reached.push_back(other), m_turn[other] = wanted;
      if (m_turn[other] != wanted) return false;
    }
    return true;
  }

  void keep_most(const std::vector<Index>& reached) {
    // The winding of most faces is kept; the others count as flipped.
    const auto count = static_cast<Index>(
        std::count_if(reached.begin(), reached.end(), [&](Index f) { return m_turn[f] < 0; }));
    const auto size = static_cast<Index>(reached.size());
    const bool most = 2 * count > size;
    m_out.num_flipped += most ? size - count : count;
    for (const Index f : reached)
      if (most) m_turn[f] = static_cast<std::int8_t>(-m_turn[f]);
  }

  const Mesh& m_mesh;
  const Adjacency& m_adjacency;
  SolidFaces& m_out;
  std::vector<std::int8_t> m_turn;  // #F: 0 until reached
  std::vector<char> m_is_reached;   // #F: by patches
};

bool is_clean(const Component& c) { return c.balanced && c.manifold; }

// Parts that neither are clean nor have an edge of one face, which nothing can close.
std::vector<char> doubtful_parts(const Adjacency& adjacency) {
  // An edge of one face alone means an open surface: no cleaning closes it.
  std::vector<char> out;
  for (const Component& c : adjacency.components) out.push_back(!is_clean(c));
  for (Index e = 0; e < adjacency.edge_faces.size(); ++e)
    if (adjacency.edge_faces[e].size() == 1)
      out[adjacency.face_component[adjacency.edge_faces[e][0].face]] = 0;
  return out;
}

}  // namespace

SolidFaces solid_faces(const Mesh& mesh, const Adjacency& adjacency) {
  SolidFaces out;
  for (const Component& c : adjacency.components) out.closed.push_back(is_clean(c));
  const std::vector<char> doubtful = doubtful_parts(adjacency);
  // Most meshes are clean: they pay for nothing more.
  if (std::find(doubtful.begin(), doubtful.end(), 1) == doubtful.end()) return out;
  std::vector<std::vector<Index>> faces_of(doubtful.size());
  for (Index f = 0; f < static_cast<Index>(mesh.triangles.size()); ++f)
    if (const Index c = adjacency.face_component[f]; doubtful[c]) faces_of[c].push_back(f);
  out.weights.assign(mesh.triangles.size(), 1);
  PartCleaner cleaner(mesh, adjacency, out);
  for (size_t c = 0; c < doubtful.size(); ++c)
    if (doubtful[c]) cleaner.clean(static_cast<Index>(c), std::move(faces_of[c]));
  return out;
}

}  // namespace trivet
