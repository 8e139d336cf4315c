// Vertices by their coordinates: equal ones are one.
#pragma once

#include <bit>
#include <cstdint>
#include <sstream>
#include <vector>

#include "core/base/error.h"
#include "core/base/types.h"

namespace trivet {

/// Open addressing; a slot holds a vertex id, whose coordinates are the key.
class VertexTable {
 public:
  explicit VertexTable(std::vector<Vec3>& vertices) : m_vertices(vertices) { grow(1024); }

  /// @throws Error (BadInput): not finite.
  Index find_or_add(const Vec3& corner) {
    const Vec3 point = corner.array() + 0.0;  // -0 becomes 0
    Index& slot = slot_of(key_of(point));
    if (slot >= 0) return slot;
    if (!point.allFinite()) fail_not_finite(point);
    const Index id = static_cast<Index>(m_vertices.size());
    slot = id;
    m_vertices.push_back(point);
    // The table stays at most half full, so that probes are short.
    if (2 * m_vertices.size() > m_slots.size()) grow(4 * m_slots.size());
    return id;
  }

 private:
  using Key = std::array<std::uint64_t, 3>;

  // Equal points have equal bits once -0 is replaced by 0.
  static Key key_of(const Vec3& p) {
    return std::bit_cast<Key>(std::array<double, 3>{p.x(), p.y(), p.z()});
  }

  // Multiplies and folds; affects the time only, never the ids.
  static std::uint64_t hash(const Key& key) {
    std::uint64_t h = 0;
    for (const std::uint64_t bits : key) {
      h = (h ^ bits) * 0x9e3779b97f4a7c15u;
      h ^= h >> 32;
    }
    return h;
  }

  [[noreturn]] static void fail_not_finite(const Vec3& p) {
    std::ostringstream out;
    out << "mesh vertex (" << p.x() << ", " << p.y() << ", " << p.z()
        << ") is not finite; accepted: finite coordinates";
    throw Error(Error::Kind::BadInput, out.str());
  }

  /// Slot that holds this point, or the free one for it.
  Index& slot_of(const Key& key) {
    // The size is a power of two: a mask replaces the division.
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

}  // namespace trivet
