#include "core/mesh/mesh.h"

#include <bit>
#include <sstream>

#include "core/base/error.h"

namespace trivet {
namespace {

using Key = std::array<std::uint64_t, 3>;

/// Equal points have equal bits once -0 is replaced by 0.
Key key_of(const Vec3& p) { return std::bit_cast<Key>(std::array<double, 3>{p.x(), p.y(), p.z()}); }

/// Multiplies and folds; affects the time only, never the ids.
std::uint64_t hash(const Key& key) {
  std::uint64_t h = 0;
  for (const std::uint64_t bits : key) {
    h = (h ^ bits) * 0x9e3779b97f4a7c15u;
    h ^= h >> 32;
  }
  return h;
}

[[noreturn]] void fail_not_finite(const Vec3& p) {
  std::ostringstream out;
  out << "mesh vertex (" << p.x() << ", " << p.y() << ", " << p.z()
      << ") is not finite; accepted: finite coordinates";
  throw Error(Error::Kind::BadInput, out.str());
}

/// Open addressing; a slot holds a vertex id, whose coordinates are the key.
class VertexTable {
 public:
  explicit VertexTable(std::vector<Vec3>& vertices) : m_vertices(vertices) { grow(1024); }

  Index find_or_add(const Vec3& corner) {
    const Vec3 point = corner.array() + 0.0;  // -0 becomes 0
    Index& slot = slot_of(key_of(point));
    if (slot >= 0) return slot;
    if (!point.allFinite()) fail_not_finite(point);
    const Index id = static_cast<Index>(m_vertices.size());
    slot = id;
    m_vertices.push_back(point);
    if (2 * m_vertices.size() > m_slots.size()) grow(4 * m_slots.size());
    return id;
  }

 private:
  /// Slot that holds this point, or the free one for it.
  Index& slot_of(const Key& key) {
    const size_t mask = m_slots.size() - 1;
    size_t i = hash(key) & mask;
    while (m_slots[i] >= 0 && key_of(m_vertices[m_slots[i]]) != key) i = (i + 1) & mask;
    return m_slots[i];
  }

  void grow(size_t num_slots) {
    m_slots.assign(num_slots, -1);
    for (size_t id = 0; id < m_vertices.size(); ++id)
      slot_of(key_of(m_vertices[id])) = static_cast<Index>(id);
  }

  std::vector<Vec3>& m_vertices;
  std::vector<Index> m_slots;  // a power of two, at least twice the vertices
};

}  // namespace

Aabb Mesh::box() const {
  Aabb box;
  for (const Vec3& p : vertices) box.extend(p);
  return box;
}

Mesh weld(const std::vector<Triangle>& triangles) {
  Mesh mesh;
  mesh.triangles.reserve(triangles.size());
  VertexTable table(mesh.vertices);
  for (const Triangle& t : triangles) {
    const Index a = table.find_or_add(t[0]), b = table.find_or_add(t[1]);
    mesh.triangles.push_back({a, b, table.find_or_add(t[2])});
  }
  mesh.vertices.shrink_to_fit();
  return mesh;
}

}  // namespace trivet
