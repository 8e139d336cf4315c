#include "core/flex/near_pairs.h"

#include <cstdlib>

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

void Surroundings::find_outside(std::span<const Aabb> boxes, double margin,
                                std::vector<NearPair>& out) const {
  // Too many pairs are given up, whoever made the mesh.
  const auto search = [&](const BoxTree& tree, PairKind kind, size_t a, Aabb box) {
    if (out.size() > kMostPairs) return;
    grow(box, margin);
    tree.visit(box, [&](int b) { out.push_back({kind, static_cast<int>(a), b}); });
  };
  // Vertices against faces, both ways, and edges against edges are all ways in which surfaces meet.
  for (size_t v = 0; v < boxes.size(); ++v)
    search(m_obstacles.face_tree(), PairKind::VertexFace, v, boxes[v]);
  for (size_t e = 0; e < m_body.edges.size(); ++e)
    search(m_obstacles.edge_tree(), PairKind::EdgeEdge, e, box_of(m_body.edges[e], boxes));
  for (size_t f = 0; f < m_body.faces.size(); ++f)
    search(m_obstacles.vertex_tree(), PairKind::FaceVertex, f, box_of(m_body.faces[f], boxes));
}

void Surroundings::find_own(std::span<const Aabb> boxes, double margin,
                            std::vector<NearPair>& out) {
  // The trees keep their order and take the new boxes.
  m_face_tree.refit(boxes_of(m_body.faces, boxes));
  m_edge_tree.refit(boxes_of(m_body.edges, boxes));
  const auto add = [&](PairKind kind, int a, int b) {
    const NearPair pair{kind, a, b};
    if (!are_neighbours(pair)) out.push_back(pair);
  };
  for (size_t v = 0; v < boxes.size() && out.size() <= kMostPairs; ++v) {
    // Elements that share a vertex are always near, and no contact.
    Aabb box = boxes[v];
    grow(box, margin);
    const std::array<int, 1> vertex{static_cast<int>(v)};
    m_face_tree.visit(box, [&](int f) {
      if (!share_a_vertex(vertex, m_body.faces[f])) add(PairKind::OwnVertexFace, vertex[0], f);
    });
  }
  for (size_t e = 0; e < m_body.edges.size() && out.size() <= kMostPairs; ++e) {
    Aabb box = box_of(m_body.edges[e], boxes);
    grow(box, margin);
    const int a = static_cast<int>(e);
    m_edge_tree.visit(box, [&](int b) {
      if (b > a && !share_a_vertex(m_body.edges[e], m_body.edges[b]))
        add(PairKind::OwnEdgeEdge, a, b);
    });
  }
}

void Surroundings::find(std::span<const Aabb> boxes, double margin, double own_margin,
                        std::vector<NearPair>& out) {
  find_outside(boxes, margin, out);
  find_own(boxes, own_margin, out);
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
