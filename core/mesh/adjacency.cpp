// Half-edge h = 3 * face + k runs from corner k of its face to corner k + 1. All grouping is by
// counting, never by searching, so that the cost is linear for any mesh.
#include "core/mesh/adjacency.h"

#include <algorithm>
#include <cassert>
#include <numeric>

#include "core/mesh/solid_faces.h"

namespace trivet {
namespace {

/// Collects items by row, in the order in which `visit(emit)` calls emit(row, item). `visit` runs
/// twice: to count and to fill.
template <class T, class Visit>
Rows<T> collect_rows(size_t num_rows, const Visit& visit) {
  Rows<T> rows;
  // A row's count is one place ahead, so that the running sum gives where each row begins.
  rows.offsets.assign(num_rows + 1, 0);
  visit([&](Index row, const T&) { ++rows.offsets[row + 1]; });
  std::partial_sum(rows.offsets.begin(), rows.offsets.end(), rows.offsets.begin());
  rows.items.resize(rows.offsets.back());
  // The second visit fills rows from their begins: items keep the order in which they are emitted.
  std::vector<Index> next(rows.offsets.begin(), rows.offsets.end() - 1);
  visit([&](Index row, const T& item) { rows.items[next[row]++] = item; });
  return rows;
}

std::array<Index, 2> half_edge_ends(const Mesh& mesh, Index half_edge) {
  const Index3& t = mesh.triangles[half_edge / 3];
  return {t[half_edge % 3], t[(half_edge + 1) % 3]};
}

std::array<Index, 2> sorted_ends(const Mesh& mesh, Index half_edge) {
  const auto [from, to] = half_edge_ends(mesh, half_edge);
  return {std::min(from, to), std::max(from, to)};
}

/// Groups half-edges of the same two vertices, each group in ascending order: two stable counting
/// sorts, by the larger and then by the smaller vertex.
std::vector<Index> half_edges_by_ends(const Mesh& mesh) {
  const Index num_half_edges = 3 * static_cast<Index>(mesh.triangles.size());
  const auto by_larger = collect_rows<Index>(mesh.vertices.size(), [&](const auto& emit) {
    // The first sort is by the larger vertex; half-edges of equal ends are no edges.
    for (Index h = 0; h < num_half_edges; ++h) {
      const auto [from, to] = half_edge_ends(mesh, h);
      if (from != to) emit(std::max(from, to), h);
    }
  });
  // The second keeps that order within each smaller vertex: half-edges of one edge are neighbours.
  return collect_rows<Index>(mesh.vertices.size(),
                             [&](const auto& emit) {
                               for (const Index h : by_larger.items)
                                 emit(sorted_ends(mesh, h)[0], h);
                             })
      .items;
}

/// Numbers the edges in the order of their first half-edges.
void number_edges(const Mesh& mesh, Adjacency& out) {
  const std::vector<Index> sorted = half_edges_by_ends(mesh);
  // Each half-edge learns the first of its group, which decides the edge's number.
  std::vector<Index> first_of_group(3 * mesh.triangles.size(), -1);
  for (size_t i = 0, begin = 0; i < sorted.size(); ++i) {
    if (sorted_ends(mesh, sorted[i]) != sorted_ends(mesh, sorted[begin])) begin = i;
    first_of_group[sorted[i]] = sorted[begin];
  }
  out.face_edges.assign(mesh.triangles.size(), {-1, -1, -1});
  for (Index h = 0; h < static_cast<Index>(first_of_group.size()); ++h) {
    // An edge is new where its first half-edge comes by; later ones copy the number.
    const Index first = first_of_group[h];
    if (first < 0) continue;  // equal ends
    if (first == h) {
      out.face_edges[h / 3][h % 3] = static_cast<Index>(out.edge_vertices.size());
      out.edge_vertices.push_back(sorted_ends(mesh, h));
    } else {
      out.face_edges[h / 3][h % 3] = out.face_edges[first / 3][first % 3];
    }
  }
}

void collect_edge_faces(const Mesh& mesh, Adjacency& out) {
  out.edge_faces = collect_rows<Wing>(out.edge_vertices.size(), [&](const auto& emit) {
    for (Index h = 0; h < 3 * static_cast<Index>(mesh.triangles.size()); ++h) {
      const Index edge = out.face_edges[h / 3][h % 3];
      // The wing's direction tells later whether the faces of an edge agree in winding.
      const auto [from, to] = half_edge_ends(mesh, h);
      if (edge >= 0) emit(edge, Wing{h / 3, from < to});
    }
  });
}

void collect_vertex_rows(const Mesh& mesh, Adjacency& out) {
  out.vertex_faces = collect_rows<Index>(mesh.vertices.size(), [&](const auto& emit) {
    for (Index f = 0; f < static_cast<Index>(mesh.triangles.size()); ++f) {
      // A degenerate face counts once for each vertex, however often it names it.
      const auto& [a, b, c] = mesh.triangles[f];
      emit(a, f);
      if (b != a) emit(b, f);
      if (c != a && c != b) emit(c, f);
    }
  });
  out.vertex_edges = collect_rows<Index>(mesh.vertices.size(), [&](const auto& emit) {
    for (Index e = 0; e < static_cast<Index>(out.edge_vertices.size()); ++e)
      for (const Index v : out.edge_vertices[e]) emit(v, e);
  });
}

/// Disjoint sets of faces; the root of a set is its smallest face.
class FaceSets {
 public:
  explicit FaceSets(size_t num_faces) : m_parent(num_faces) {
    std::iota(m_parent.begin(), m_parent.end(), 0);
  }

  Index root(Index face) {
    // Paths are halved on the way, which keeps them short.
    while (m_parent[face] != face) face = m_parent[face] = m_parent[m_parent[face]];
    return face;
  }

  void unite(Index a, Index b) {
    // The smaller root wins: the root of a set is its smallest face, whatever the order of unions.
    const Index root_a = root(a), root_b = root(b);
    m_parent[std::max(root_a, root_b)] = std::min(root_a, root_b);
  }

 private:
  std::vector<Index> m_parent;
};

/// Numbers the components in the order of their first faces.
void find_components(const Mesh& mesh, Adjacency& out) {
  const Index num_faces = static_cast<Index>(mesh.triangles.size());
  FaceSets sets(mesh.triangles.size());
  // Faces that share an edge are of one component; a shared vertex alone joins nothing.
  for (Index e = 0; e < out.edge_faces.size(); ++e)
    for (const Wing& wing : out.edge_faces[e]) sets.unite(out.edge_faces[e][0].face, wing.face);

  out.face_component.resize(mesh.triangles.size());
  for (Index f = 0; f < num_faces; ++f) {
    // A root comes before all other faces of its set.
    const Index root = sets.root(f);
    if (root == f) {
      out.face_component[f] = static_cast<Index>(out.components.size());
      out.components.emplace_back().sample_vertex = mesh.triangles[f][0];
    } else {
      out.face_component[f] = out.face_component[root];
    }
    Component& component = out.components[out.face_component[f]];
    ++component.num_faces;
    for (const Index v : mesh.triangles[f]) component.box.extend(mesh.vertices[v]);
  }
}

void classify_components(Adjacency& out) {
  for (Index e = 0; e < out.edge_faces.size(); ++e) {
    const std::span<const Wing> wings = out.edge_faces[e];
    // A solid's edge is used twice, once in each direction; weaker findings are kept for the
    // doubtful.
    const auto uses = static_cast<std::ptrdiff_t>(wings.size());
    const auto forward =
        std::count_if(wings.begin(), wings.end(), [](const Wing& wing) { return wing.forward; });
    Component& component = out.components[out.face_component[wings[0].face]];
    component.even = component.even && uses % 2 == 0;
    component.balanced = component.balanced && 2 * forward == uses;
    component.manifold = component.manifold && uses == 2 && forward == 1;
  }
}

}  // namespace

Adjacency make_adjacency(const Mesh& mesh) {
  assert(mesh.triangles.size() <= static_cast<size_t>(std::numeric_limits<Index>::max() / 3));
  Adjacency out;
  number_edges(mesh, out);
  collect_edge_faces(mesh, out);
  collect_vertex_rows(mesh, out);
  find_components(mesh, out);
  classify_components(out);
  nest_components(mesh, solid_faces(mesh, out), out);
  return out;
}

}  // namespace trivet
