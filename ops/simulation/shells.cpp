#include "ops/simulation/shells.h"

#include <map>
#include <utility>

namespace trivet {
namespace {

/// Edges of the shell so far that wait for the triangle on their other side.
class OpenEdges {
 public:
  void add(const Index3& triangle) {
    for (size_t k = 0; k < 3; ++k) add(triangle[k], triangle[(k + 1) % 3]);
  }
  bool none() const { return m_open.empty(); }

 private:
  void add(Index from, Index to) {
    const auto other = m_open.find({to, from});
    if (other == m_open.end()) {
      ++m_open[{from, to}];
    } else if (--other->second == 0) {
      m_open.erase(other);
    }
  }

  std::map<std::pair<Index, Index>, int> m_open;
};

}  // namespace

Mesh shells_apart(const Mesh& mesh) {
  Mesh out;
  OpenEdges open;
  std::map<Index, Index> number;  // in this shell, by that in the mesh
  for (const Index3& triangle : mesh.triangles) {
    Index3 copy = triangle;
    for (Index& vertex : copy) {
      const auto [it, is_new] = number.emplace(vertex, static_cast<Index>(out.vertices.size()));
      if (is_new) out.vertices.push_back(mesh.vertices[vertex]);
      vertex = it->second;
    }
    out.triangles.push_back(copy);
    open.add(triangle);
    if (open.none()) number.clear();
  }
  return out;
}

}  // namespace trivet
