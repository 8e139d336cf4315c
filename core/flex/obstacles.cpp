#include "core/flex/obstacles.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace trivet::flex {
namespace {

template <class Element>
BoxTree tree_of(const std::vector<Element>& elements, const Points& x) {
  std::vector<Aabb> boxes(elements.size());
  for (size_t i = 0; i < elements.size(); ++i)
    for (const int v : elements[i]) boxes[i].extend(x[v]);
  return BoxTree(boxes);
}

}  // namespace

int Obstacles::add(const Points& vertices, std::span<const std::array<Index, 3>> triangles,
                   double friction) {
  const auto first = static_cast<int>(m_vertices.size());
  // Vertices of an obstacle follow each other, and each knows whose it is, for friction and shares.
  const int owner = num_owners();
  m_friction.push_back(friction);
  m_vertices.insert(m_vertices.end(), vertices.begin(), vertices.end());
  m_owner.resize(m_vertices.size(), owner);
  for (const auto& t : triangles) m_faces.push_back({first + t[0], first + t[1], first + t[2]});
  return owner;
}

void Obstacles::build() {
  // Shared edges are kept once.
  for (const auto& face : m_faces)
    for (int k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax({face[k], face[(k + 1) % 3]});
      if (low != high) m_edges.push_back({low, high});
    }
  std::sort(m_edges.begin(), m_edges.end());
  m_edges.erase(std::unique(m_edges.begin(), m_edges.end()), m_edges.end());
  std::erase_if(m_faces, [&](const auto& f) {  // their edges say all
    const Vec3& a = m_vertices[f[0]];
    return (m_vertices[f[1]] - a).cross(m_vertices[f[2]] - a).squaredNorm() == 0;
  });
  std::vector<std::array<int, 1>> used;
  for (size_t v = 0; v < m_vertices.size(); ++v) used.push_back({static_cast<int>(v)});
  m_vertex_tree = tree_of(used, m_vertices);
  m_edge_tree = tree_of(m_edges, m_vertices);
  m_face_tree = tree_of(m_faces, m_vertices);
}

}  // namespace trivet::flex
