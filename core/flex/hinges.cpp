#include "core/flex/hinges.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace trivet::flex {
namespace {

// One face beside the edge from a to b, its third corner p: how it turns about the edge.
struct Leaf {
  Vec3 normal, across;  // unit vectors; `across` in the face, from the edge to p
  Vec3 edge;            // from a to b
  double length, height;
  double foot;                  // of p on the edge: 0 at a, 1 at b
  std::array<double, 3> share;  // the angle's slope is share x normal / height, of a, b and p

  // @param side  1: p is on the left of the edge, seen against the normal; -1: on the right.
  Leaf(const Vec3& a, const Vec3& b, const Vec3& p, double side) : edge(b - a) {
    const Vec3 to = p - a, product = side * edge.cross(to);
    length = edge.norm();
    normal = product / product.norm();
    across = side * normal.cross(edge) / length;
    height = product.norm() / length;
    foot = to.dot(edge) / (length * length);
    share = {1 - foot, foot, -1};
  }
  Vec3 slope(int k) const { return share[k] / height * normal; }
  // The second derivative by corners k and l, this face's part of it.
  Mat3 curvature(int k, int l) const {
    const Vec3 by_foot = k == 2 ? Vec3(Vec3::Zero()) : Vec3((k == 1 ? 1 : -1) * foot_slope(l));
    const Vec3 stretched = by_foot / height + share[k] * share[l] / (height * height) * across;
    return outer(normal, stretched) - outer(hat_slope(l), normal) * (share[k] / height);
  }

 private:
  Vec3 foot_slope(int l) const {
    const Vec3 by_p = edge / (length * length);
    const Vec3 by_b = (height * across - foot * edge) / (length * length);
    return l == 2 ? by_p : l == 1 ? by_b : Vec3(-by_p - by_b);
  }
  // The slope, in the face, of the function that is one at corner l and zero at the others.
  Vec3 hat_slope(int l) const {
    const Vec3 along = edge / (length * length);
    if (l == 2) return across / height;
    return (l == 1 ? along : Vec3(-along)) - share[l] / height * across;
  }
};

// Two faces at an edge. The angle is measured as 2 sin(angle / 2), which needs no inverse function.
class BentHinge {
 public:
  BentHinge(const Hinge& hinge, const Points& x)
      : m_left(x[hinge.vertices[0]], x[hinge.vertices[1]], x[hinge.vertices[2]], 1),
        m_right(x[hinge.vertices[0]], x[hinge.vertices[1]], x[hinge.vertices[3]], -1) {
    const Vec3 &u = m_left.normal, &v = m_right.normal;
    const double size = (u - v).norm();
    m_value = m_left.edge.dot(u.cross(v)) < 0 ? -size : size;
    m_cosine = (u + v).norm() / 2;
  }
  double value() const { return m_value; }
  // By vertex k of the hinge.
  Vec3 slope(int k) const { return m_cosine * angle_slope(k); }
  Mat3 curvature(int k, int l) const {
    Mat3 out = Mat3::Zero();
    if (k != 3 && l != 3) out += m_left.curvature(k, l);
    if (k != 2 && l != 2) out += m_right.curvature(std::min(k, 2), std::min(l, 2));
    return m_cosine * out - m_value / 4 * outer(angle_slope(k), angle_slope(l));
  }

 private:
  Vec3 angle_slope(int k) const {
    if (k == 2) return m_left.slope(2);
    if (k == 3) return m_right.slope(2);
    return m_left.slope(k) + m_right.slope(k);
  }

  Leaf m_left, m_right;
  double m_value, m_cosine;  // 2 sin(angle / 2); cos(angle / 2)
};

// A face with the hinges at its edges, and its own and its neighbours' corners.
class BentFace {
 public:
  BentFace(const Body& body, const HingedFace& face, const Points& x) : m_face(face) {
    m_bent.reserve(face.count);
    for (auto& slopes : m_slopes) slopes.fill(Vec3::Zero());
    for (int i = 0; i < face.count; ++i) {
      const Hinge& hinge = body.hinges[face.hinges[i]];
      const BentHinge& bent = m_bent.emplace_back(hinge, x);
      m_bends[i] = bent.value() - hinge.rest;
      for (int k = 0; k < 4; ++k) {
        m_place[i][k] = place_of(hinge.vertices[k]);
        m_slopes[i][m_place[i][k]] = bent.slope(k);
      }
    }
    for (int i = 0; i < face.count; ++i)
      for (int j = 0; j < face.count; ++j) m_moments[i] += face.stiffness[i][j] * m_bends[j];
  }
  double energy() const {
    double sum = 0;
    for (int i = 0; i < m_face.count; ++i) sum += m_moments[i] * m_bends[i] / 2;
    return sum;
  }
  void add_gradient(const Total& total) const {
    for (int i = 0; i < m_face.count; ++i)
      for (int k = 0; k < m_count; ++k) total.add(m_vertices[k], m_moments[i] * m_slopes[i][k]);
  }
  void add_curvature(const Total& total) const {
    for (int k = 0; k < m_count; ++k)
      for (int l = 0; l < m_count; ++l)
        if (total.has(m_vertices[k])) total.add(m_vertices[k], m_vertices[l], stiff_block(k, l));
    if (total.curvature != Curvature::Exact) return;
    for (int i = 0; i < m_face.count; ++i)
      for (int k = 0; k < 4; ++k)
        for (int l = 0; l < 4; ++l)
          total.add(m_vertices[m_place[i][k]], m_vertices[m_place[i][l]],
                    m_moments[i] * m_bent[i].curvature(k, l));
  }

 private:
  int place_of(int vertex) {
    for (int k = 0; k < m_count; ++k)
      if (m_vertices[k] == vertex) return k;
    m_vertices[m_count] = vertex;
    return m_count++;
  }
  Mat3 stiff_block(int k, int l) const {
    Mat3 out = Mat3::Zero();
    for (int i = 0; i < m_face.count; ++i) {
      Vec3 other = Vec3::Zero();
      for (int j = 0; j < m_face.count; ++j) other += m_face.stiffness[i][j] * m_slopes[j][l];
      out += outer(m_slopes[i][k], other);
    }
    return out;
  }

  const HingedFace& m_face;
  std::vector<BentHinge> m_bent;
  int m_count = 0;
  std::array<int, 6> m_vertices{};
  int m_place[3][4] = {};
  double m_bends[3] = {}, m_moments[3] = {};
  std::array<std::array<Vec3, 6>, 3> m_slopes;
};

// True if the face has the edge in this direction.
bool goes_along(const std::array<int, 3>& face, const std::array<int, 2>& edge) {
  for (int k = 0; k < 3; ++k)
    if (face[k] == edge[0]) return face[(k + 1) % 3] == edge[1];
  return false;
}

int third_corner(const std::array<int, 3>& face, const std::array<int, 2>& edge) {
  for (const int v : face)
    if (v != edge[0] && v != edge[1]) return v;
  return -1;
}

// The hinge of each edge, or -1; an edge with one face is a rim, and bends freely.
std::vector<int> hinges_of_edges(Body& body, const Points& x,
                                 std::vector<std::array<int, 2>>& sides) {
  sides.assign(body.edges.size(), {-1, -1});
  for (size_t f = 0; f < body.faces.size(); ++f)
    for (const int edge : body.face_edges[f]) {
      const bool second = sides[edge][0] >= 0;
      sides[edge][second] = static_cast<int>(f);
      // The left one first.
      if (second && goes_along(body.faces[f], body.edges[edge]))
        std::swap(sides[edge][0], sides[edge][1]);
    }
  std::vector<int> out(body.edges.size(), -1);
  for (size_t e = 0; e < body.edges.size(); ++e) {
    if (sides[e][1] < 0) continue;
    const auto& edge = body.edges[e];
    Hinge hinge{{edge[0], edge[1], third_corner(body.faces[sides[e][0]], edge),
                 third_corner(body.faces[sides[e][1]], edge)},
                0};
    hinge.rest = BentHinge(hinge, x).value();
    out[e] = static_cast<int>(body.hinges.size());
    body.hinges.push_back(hinge);
  }
  return out;
}

}  // namespace

void add_hinges(Body& body, const Points& x) {
  std::vector<std::array<int, 2>> sides;
  const std::vector<int> hinges = hinges_of_edges(body, x, sides);
  for (size_t f = 0; f < body.faces.size(); ++f) {
    HingedFace out;
    Vec3 edges[3];
    double signs[3] = {};
    for (const int e : body.face_edges[f]) {
      if (hinges[e] < 0) continue;
      edges[out.count] = x[body.edges[e][1]] - x[body.edges[e][0]];
      // Faces of other orientation than their neighbours see the angle from the other side.
      const bool is_left = sides[e][0] == static_cast<int>(f);
      signs[out.count] = goes_along(body.faces[f], body.edges[e]) == is_left ? 1 : -1;
      out.hinges[out.count++] = hinges[e];
    }
    // The shape operator is the sum of angle x length / (2 area) x n n', n across the edge; its
    // energy is that of an isotropic plate. Normals of edges have the angle of the edges.
    for (int i = 0; i < out.count; ++i)
      for (int j = 0; j < out.count; ++j) {
        const double lengths = edges[i].norm() * edges[j].norm();
        const double cosine = edges[i].dot(edges[j]) / lengths, twist = body.material.twist;
        out.stiffness[i][j] = signs[i] * signs[j] * body.material.bending * lengths /
                              (4 * body.face_area[f]) * (twist * cosine * cosine + 1 - twist);
      }
    if (out.count > 0) body.hinged_faces.push_back(out);
  }
}

double bend_hinges(const Body& body, const Points& x, const Total& total) {
  double sum = 0;
  for (const HingedFace& face : body.hinged_faces) {
    bool is_wanted = false;
    for (int i = 0; i < face.count; ++i)
      is_wanted = is_wanted || total.has_any(body.hinges[face.hinges[i]].vertices, 4);
    if (!is_wanted) continue;
    const BentFace bent(body, face, x);
    sum += total.energy_of(body.hinges[face.hinges[0]].vertices[0], bent.energy());
    if (total.gradient) bent.add_gradient(total);
    if (total.hessian) bent.add_curvature(total);
  }
  return sum;
}

}  // namespace trivet::flex
