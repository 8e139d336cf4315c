#include "ops/arrange/hull_facets.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>
#include <tuple>

#include "core/mesh/hull.h"

namespace trivet {

HullFacets::HullFacets(std::vector<Vec3> points) : m_points(std::move(points)) {
  Aabb box;
  for (const Vec3& p : m_points) box.extend(p);
  m_size = box.diagonal();
  make_faces();
  connect();
  grow_facets();
}

void HullFacets::make_faces() {
  const ConvexHull hull = convex_hull(m_points);
  // The mean of the corners is inside, and tells which way a triangle looks.
  Vec3 inside = Vec3::Zero();
  for (const Index v : hull.vertices) inside += m_points[v] / double(hull.vertices.size());
  m_faces.reserve(hull.triangles.size());
  for (Index3 t : hull.triangles) {
    // Each triangle begins with its smallest corner, so that sorting gives one order.
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    HullFace face;
    face.corners = t;
    const Vec3 a = m_points[t[0]];
    Vec3 twice = (m_points[t[1]] - a).cross(m_points[t[2]] - a);
    if (twice.dot(a - inside) < 0) {
      std::swap(face.corners[1], face.corners[2]);
      twice = -twice;
    }
    face.area = 0.5 * twice.norm();
    if (face.area > 0) face.normal = twice / (2 * face.area);
    m_faces.push_back(face);
  }
  // Qhull's order is no promise.
  std::sort(m_faces.begin(), m_faces.end(),
            [](const HullFace& a, const HullFace& b) { return a.corners < b.corners; });
}

void HullFacets::connect() {
  // An edge has two sides, which sorting brings together.
  struct EdgeSide {
    Index a, b, face;
    int edge;
  };
  std::vector<EdgeSide> sides;
  sides.reserve(3 * m_faces.size());
  for (Index f = 0; f < static_cast<Index>(m_faces.size()); ++f)
    for (int k = 0; k < 3; ++k) {
      const auto [a, b] = std::minmax(m_faces[f].corners[k], m_faces[f].corners[(k + 1) % 3]);
      sides.push_back({a, b, f, k});
    }
  const auto key = [](const EdgeSide& s) { return std::tuple(s.a, s.b, s.face); };
  std::sort(sides.begin(), sides.end(),
            [&](const EdgeSide& s, const EdgeSide& t) { return key(s) < key(t); });
  for (size_t i = 0; i + 1 < sides.size(); ++i) {
    const EdgeSide &s = sides[i], &t = sides[i + 1];
    if (s.a != t.a || s.b != t.b) continue;
    m_faces[s.face].across[s.edge] = t.face;
    m_faces[t.face].across[t.edge] = s.face;
  }
}

void HullFacets::grow_facets() {
  // Large triangles begin facets, as their normals are known best.
  std::vector<Index> order(m_faces.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](Index a, Index b) { return m_faces[a].area > m_faces[b].area; });
  for (const Index seed : order) {
    if (m_faces[seed].region >= 0) continue;
    const auto region = static_cast<Index>(m_facets.size());
    std::vector<Index> facet;
    facet.push_back(seed);
    m_faces[seed].region = region;
    // A facet takes in neighbours that are nearly in the plane of its seed, not of each other.
    for (size_t i = 0; i < facet.size(); ++i)
      for (const Index next : m_faces[facet[i]].across)
        if (next >= 0 && m_faces[next].region < 0 && joins(m_faces[next], m_faces[seed])) {
          m_faces[next].region = region;
          facet.push_back(next);
        }
    m_facets.push_back(std::move(facet));
  }
}

bool HullFacets::joins(const HullFace& face, const HullFace& seed) const {
  // Slivers have no reliable normal, and join any facet.
  return face.area <= kHullTolerance * kHullTolerance * m_size * m_size ||
         face.normal.dot(seed.normal) >= kFacetMergeCosine;
}

}  // namespace trivet
