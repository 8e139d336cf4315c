#include "core/flex/near_pairs.h"

#include <atomic>
#include <cstdlib>

#include "core/base/in_parallel.h"
#include "core/flex/closest.h"

namespace trivet::flex {
namespace {

constexpr double kArc = 3.2;  // diameters along a cable that are no contact

template <class Element>
Aabb box_of(const Element& element, std::span<const Aabb> boxes) {
  Aabb out;
  for (const int v : element) out.extend(boxes[v]);
  return out;
}

template <class Element>
std::vector<Aabb> boxes_of(const std::vector<Element>& elements, std::span<const Aabb> boxes) {
  std::vector<Aabb> out;
  out.reserve(elements.size());
  for (const Element& element : elements) out.push_back(box_of(element, boxes));
  return out;
}

template <class Element>
std::vector<Aabb> rest_boxes(const Body& body, const std::vector<Element>& elements) {
  std::vector<Aabb> of_vertices(body.rest.size());
  for (size_t v = 0; v < of_vertices.size(); ++v)
    of_vertices[v].extend(Vec3(body.rest[v][0], body.rest[v][1], 0));
  return boxes_of(elements, of_vertices);
}

template <class A, class B>
bool share_a_vertex(const A& a, const B& b) {
  for (const int v : a)
    for (const int w : b)
      if (v == w) return true;
  return false;
}

Vec3 face_weights(const Vec3& p, const Points& x, const std::array<int, 3>& face) {
  // A segment is a face with two equal corners.
  if (face[1] != face[2]) return closest_on_triangle(p, x[face[0]], x[face[1]], x[face[2]]);
  const double share = closest_on_segment(p, x[face[0]], x[face[1]]);
  return {1 - share, share, 0};
}

Vec3 weighted(const Vec3& w, const Points& x, const std::array<int, 3>& face) {
  return w[0] * x[face[0]] + w[1] * x[face[1]] + w[2] * x[face[2]];
}

// Free parameters of a point in a face: of the corners that have a share, all but the first.
// @param sign  of the point in the difference. @param at  place of its first corner among the
//   pair's vertices; -1: the obstacle's.
void free_in_face(PairPoints& out, const Vec3& w, const Points& x, const std::array<int, 3>& face,
                  double sign, int at) {
  // The first corner with a share follows from the others, as shares add up to one.
  int first = -1;
  for (int k = 0; k < 3; ++k) {
    if (!(w[k] > 0)) continue;
    if (first < 0) {
      first = k;
      continue;
    }
    const int q = out.num_free++;
    out.slope[q] = sign * (x[face[k]] - x[face[first]]);
    if (at >= 0) out.weight_slope[q][at + k] = sign, out.weight_slope[q][at + first] = -sign;
  }
}

bool is_inside(double share) { return share > 0 && share < 1; }

void free_on_edges(PairPoints& out, const SegmentShares& shares, bool is_own) {
  // A place inside an edge may slide along it; an end may not.
  if (is_inside(shares.s)) {
    const int q = out.num_free++;
    out.slope[q] = out.edge_a;
    out.weight_slope[q] = {-1, 1, 0, 0};
  }
  if (is_inside(shares.t)) {
    const int q = out.num_free++;
    out.slope[q] = -out.edge_b;
    if (is_own) out.weight_slope[q] = {0, 0, 1, -1};
  }
}

void set_difference(PairPoints& out, const Vec3& difference) {
  out.difference = difference;
  out.distance = difference.norm();
}

// Searches of trees, whose items are shared among threads in pieces; pairs come in their order.
class Search {
 public:
  explicit Search(size_t most) : m_most(most) {}

  // All items of a tree whose boxes are near those of the elements, and that are wanted.
  template <class Wanted>
  void add(PairKind kind, std::span<const Aabb> boxes, double margin, const BoxTree& tree,
           Wanted wanted) {
    const auto find = [=, this, &tree](size_t first, std::vector<NearPair>& out) {
      for (size_t i = first; i < std::min(first + kPiece, boxes.size()); ++i) {
        Aabb box = boxes[i];
        grow(box, margin);
        const int a = static_cast<int>(i);
        tree.visit(box, [&](int b) {
          if (wanted(a, b)) out.push_back({kind, a, b});
        });
        // Too many pairs are given up, whoever made the mesh.
        if (out.size() + m_found > m_most) break;
      }
      m_found += out.size();
    };
    for (size_t first = 0; first < boxes.size(); first += kPiece)
      m_pieces.push_back([=](std::vector<NearPair>& out) { find(first, out); });
  }

  bool run(std::vector<NearPair>& out) {
    std::vector<std::vector<NearPair>> found(m_pieces.size());
    const auto search = [&](size_t i) { m_pieces[i](found[i]); };
    // Few elements are done before other threads would have begun.
    if (m_pieces.size() > kManyPieces)
      in_parallel(m_pieces.size(), search);
    else
      for (size_t i = 0; i < m_pieces.size(); ++i) search(i);
    out.clear();
    if (m_found > m_most) return false;
    out.reserve(m_found);
    for (auto& pairs : found) {
      out.insert(out.end(), pairs.begin(), pairs.end());
      std::vector<NearPair>().swap(pairs);  // so that few are there twice
    }
    return true;
  }

 private:
  static constexpr size_t kPiece = 512;  // elements
  static constexpr size_t kManyPieces = 10;

  size_t m_most;
  std::atomic<size_t> m_found = 0;
  std::vector<std::function<void(std::vector<NearPair>&)>> m_pieces;
};

}  // namespace

Surroundings::Surroundings(const Body& body, const Obstacles& obstacles)
    : m_body(body),
      m_obstacles(obstacles),
      m_edge_tree(rest_boxes(body, body.edges)),
      m_face_tree(rest_boxes(body, body.faces)) {}

bool Surroundings::are_neighbours(const NearPair& pair) const {
  // Segments of a cable that are near along it are no contact.
  return m_body.is_cable && pair.is_own() &&
         std::abs(pair.a - pair.b) * m_body.cell < kArc * m_body.material.thickness;
}

bool Surroundings::find(std::span<const Aabb> boxes, double margin, double own_margin,
                        std::vector<NearPair>& out,
                        const std::function<bool(const NearPair&)>& wanted) {
  const Body& body = m_body;
  const std::vector<Aabb> of_edges = boxes_of(body.edges, boxes);
  const std::vector<Aabb> of_faces = boxes_of(body.faces, boxes);
  // The trees keep their order and take the new boxes.
  m_face_tree.refit(of_faces);
  m_edge_tree.refit(of_edges);
  // Vertices against faces, both ways, and edges against edges are all ways in which surfaces meet.
  Search search(kMostPairs);
  const auto outside = [&](PairKind kind, std::span<const Aabb> of, const BoxTree& tree) {
    search.add(kind, of, margin, tree, [&wanted, kind](int a, int b) {
      return wanted({kind, a, b});
    });
  };
  outside(PairKind::VertexFace, boxes, m_obstacles.face_tree());
  outside(PairKind::EdgeEdge, of_edges, m_obstacles.edge_tree());
  outside(PairKind::FaceVertex, of_faces, m_obstacles.vertex_tree());
  // Elements that share a vertex are always near, and no contact.
  search.add(PairKind::OwnVertexFace, boxes, own_margin, m_face_tree, [&](int v, int f) {
    return !share_a_vertex(std::array<int, 1>{v}, body.faces[f]) &&
           !are_neighbours({PairKind::OwnVertexFace, v, f}) &&
           wanted({PairKind::OwnVertexFace, v, f});
  });
  search.add(PairKind::OwnEdgeEdge, of_edges, own_margin, m_edge_tree, [&](int a, int b) {
    return b > a && !share_a_vertex(body.edges[a], body.edges[b]) &&
           !are_neighbours({PairKind::OwnEdgeEdge, a, b}) && wanted({PairKind::OwnEdgeEdge, a, b});
  });
  return search.run(out);
}

PairPoints Surroundings::vertex_face(const NearPair& pair, const Points& x) const {
  const Points& fixed = m_obstacles.vertices();
  PairPoints out;
  out.count = out.first = 1;
  out.vertices = {pair.a, 0, 0, 0}, out.weights = {1, 0, 0, 0};
  out.num_fixed = 3, out.fixed = m_obstacles.faces()[pair.b];
  const Vec3 w = face_weights(x[pair.a], fixed, out.fixed);
  set_difference(out, x[pair.a] - weighted(w, fixed, out.fixed));
  free_in_face(out, w, fixed, out.fixed, -1, -1);
  return out;
}

PairPoints Surroundings::face_vertex(const NearPair& pair, const Points& x) const {
  const auto& face = m_body.faces[pair.a];
  // The vertex is the obstacle's: the face's corners alone are free.
  const Vec3& p = m_obstacles.vertices()[pair.b];
  const Vec3 w = face_weights(p, x, face);
  PairPoints out;
  out.count = out.first = m_body.is_cable ? 2 : 3;
  out.vertices = {face[0], face[1], face[2], 0}, out.weights = {w[0], w[1], w[2], 0};
  out.num_fixed = 1, out.fixed = {pair.b, 0, 0};
  set_difference(out, weighted(w, x, face) - p);
  free_in_face(out, w, x, face, 1, 0);
  return out;
}

PairPoints Surroundings::edge_edge(const NearPair& pair, const Points& x) const {
  const auto [a, b] = m_body.edges[pair.a];
  const auto [p, q] = m_obstacles.edges()[pair.b];
  const Points& fixed = m_obstacles.vertices();
  // Shares tell where on each edge the closest points are; the obstacle's edge stands still.
  const SegmentShares shares = closest_on_segments(x[a], x[b], fixed[p], fixed[q]);
  PairPoints out;
  out.count = out.first = 2;
  out.vertices = {a, b, 0, 0}, out.weights = {1 - shares.s, shares.s, 0, 0};
  out.num_fixed = 2, out.fixed = {p, q, 0};
  out.edge_a = x[b] - x[a], out.edge_b = fixed[q] - fixed[p];
  set_difference(out, (1 - shares.s) * x[a] + shares.s * x[b] - (1 - shares.t) * fixed[p] -
                          shares.t * fixed[q]);
  free_on_edges(out, shares, false);
  return out;
}

PairPoints Surroundings::own_vertex_face(const NearPair& pair, const Points& x) const {
  const auto& face = m_body.faces[pair.b];
  // The face's corners count with negative weights: the difference goes from the face to the
  // vertex.
  const Vec3 w = face_weights(x[pair.a], x, face);
  PairPoints out;
  out.count = m_body.is_cable ? 3 : 4, out.first = 1;
  out.vertices = {pair.a, face[0], face[1], face[2]}, out.weights = {1, -w[0], -w[1], -w[2]};
  set_difference(out, x[pair.a] - weighted(w, x, face));
  free_in_face(out, w, x, face, -1, 1);
  return out;
}

PairPoints Surroundings::own_edge_edge(const NearPair& pair, const Points& x) const {
  const auto [a, b] = m_body.edges[pair.a];
  const auto [p, q] = m_body.edges[pair.b];
  const SegmentShares shares = closest_on_segments(x[a], x[b], x[p], x[q]);
  PairPoints out;
  out.count = 4, out.first = 2;
  out.vertices = {a, b, p, q};
  out.weights = {1 - shares.s, shares.s, shares.t - 1, -shares.t};
  out.edge_a = x[b] - x[a], out.edge_b = x[q] - x[p];
  set_difference(out,
                 (1 - shares.s) * x[a] + shares.s * x[b] - (1 - shares.t) * x[p] - shares.t * x[q]);
  free_on_edges(out, shares, true);
  return out;
}

BodyVertices Surroundings::body_vertices(const NearPair& pair) const {
  const auto& edges = m_body.edges;
  const auto& faces = m_body.faces;
  const int a = pair.a;
  const auto all = [](const std::array<int, 3>& p, const std::array<int, 3>& q) {
    return BodyVertices{p[0], p[1], p[2], q[0], q[1], q[2]};
  };
  const auto ends = [&](int edge) {
    return std::array<int, 3>{edges[edge][0], edges[edge][1], edges[edge][1]};
  };
  switch (pair.kind) {
    case PairKind::VertexFace:
      return all({a, a, a}, {a, a, a});
    case PairKind::EdgeEdge:
      return all(ends(a), ends(a));
    case PairKind::FaceVertex:
      return all(faces[a], faces[a]);
    case PairKind::OwnVertexFace:
      return all({a, a, a}, faces[pair.b]);
    case PairKind::OwnEdgeEdge:
      break;
  }
  return all(ends(a), ends(pair.b));
}

PairPoints Surroundings::points(const NearPair& pair, const Points& x) const {
  switch (pair.kind) {
    case PairKind::VertexFace:
      return vertex_face(pair, x);
    case PairKind::EdgeEdge:
      return edge_edge(pair, x);
    case PairKind::FaceVertex:
      return face_vertex(pair, x);
    case PairKind::OwnVertexFace:
      return own_vertex_face(pair, x);
    case PairKind::OwnEdgeEdge:
      break;
  }
  return own_edge_edge(pair, x);
}

}  // namespace trivet::flex
