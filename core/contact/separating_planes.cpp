#include "core/contact/separating_planes.h"

#include <array>
#include <cstdint>
#include <vector>

namespace trivet {

/// Newer planes take the place of older ones. Cleared by counting on.
struct SeparatingPlanes::Table {
  struct Slot {
    std::uint64_t use = 0;
    Index face_moving, face_fixed;
    Vec3 normal;
  };
  std::uint64_t use = 0;
  std::array<Slot, 2048> slots;

  Slot& slot(Index face_moving, Index face_fixed) {
    // Two odd factors spread neighbouring face numbers over the table; a collision costs a plane,
    // never a wrong answer.
    const auto mixed = static_cast<std::uint32_t>(face_moving) * 2654435761u ^
                       static_cast<std::uint32_t>(face_fixed) * 2246822519u;
    return slots[(mixed >> 16) % slots.size()];
  }
  /// Unused tables of this thread: making one takes as long as a small query.
  static std::vector<std::unique_ptr<Table>>& unused() {
    thread_local std::vector<std::unique_ptr<Table>> tables;
    return tables;
  }
};

SeparatingPlanes::SeparatingPlanes() {
  auto& unused = Table::unused();
  if (unused.empty()) {
    m_table = std::make_unique<Table>();
  } else {
    m_table = std::move(unused.back());
    unused.pop_back();
  }
  // Counting on makes all slots of an earlier use invalid, without touching them.
  ++m_table->use;
}

SeparatingPlanes::~SeparatingPlanes() {
  constexpr size_t kMostKept = 2;
  auto& unused = Table::unused();
  if (unused.size() < kMostKept) unused.push_back(std::move(m_table));
}

const Vec3* SeparatingPlanes::find(Index face_moving, Index face_fixed) const {
  const Table::Slot& slot = m_table->slot(face_moving, face_fixed);
  const bool found =
      slot.use == m_table->use && slot.face_moving == face_moving && slot.face_fixed == face_fixed;
  return found ? &slot.normal : nullptr;
}

void SeparatingPlanes::remember(Index face_moving, Index face_fixed, const Vec3& normal) {
  m_table->slot(face_moving, face_fixed) = {m_table->use, face_moving, face_fixed, normal};
}

}  // namespace trivet
