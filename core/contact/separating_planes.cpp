#include "core/contact/separating_planes.h"

#include <array>
#include <cstdint>
#include <memory>

namespace trivet {
namespace {

/// A table in which newer planes take the place of older ones, cleared by counting on.
struct Table {
  struct Slot {
    std::uint64_t owner = 0;
    Index face_moving, face_fixed;
    Vec3 normal;
  };
  std::uint64_t owner = 0;
  bool is_in_use = false;
  std::array<Slot, 2048> slots;

  Slot& slot(Index face_moving, Index face_fixed) {
    const auto mixed = static_cast<std::uint32_t>(face_moving) * 2654435761u ^
                       static_cast<std::uint32_t>(face_fixed) * 2246822519u;
    return slots[(mixed >> 16) % slots.size()];
  }
};

Table& table() {
  thread_local const std::unique_ptr<Table> table = std::make_unique<Table>();
  return *table;
}

}  // namespace

SeparatingPlanes::SeparatingPlanes() : m_is_first(!table().is_in_use) {
  if (!m_is_first) return;
  table().is_in_use = true;
  ++table().owner;
}

SeparatingPlanes::~SeparatingPlanes() {
  if (m_is_first) table().is_in_use = false;
}

const Vec3* SeparatingPlanes::find(Index face_moving, Index face_fixed) {
  Table& t = table();
  if (!t.is_in_use) return nullptr;
  const Table::Slot& slot = t.slot(face_moving, face_fixed);
  const bool found =
      slot.owner == t.owner && slot.face_moving == face_moving && slot.face_fixed == face_fixed;
  return found ? &slot.normal : nullptr;
}

void SeparatingPlanes::remember(Index face_moving, Index face_fixed, const Vec3& normal) {
  Table& t = table();
  if (t.is_in_use) t.slot(face_moving, face_fixed) = {t.owner, face_moving, face_fixed, normal};
}

}  // namespace trivet
