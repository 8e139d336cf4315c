#include "apps/edit/tools/hand_turn.h"

#include <cmath>

#include "apps/edit/document/pose_numbers.h"

namespace trivet::edit {

std::optional<int> turns_by(const KeyEvent& event) {
  const Modifiers& held = event.modifiers;
  if (event.key != KeyEvent::Key::Character || held.control || held.alt) return std::nullopt;
  switch (event.character) {
    case ',':
      return 1;
    case '.':
      return -1;
    case 'l':
      return 0;
    default:
      return std::nullopt;
  }
}

HandTurn::HandTurn(Document& document, std::function<void()> changed)
    : m_document(document), m_changed(std::move(changed)) {
  m_found = QObject::connect(&document, &Document::ways_found,
                             [this](const WaysToLie& ways) { found(ways); });
}

HandTurn::~HandTurn() { QObject::disconnect(m_found); }

void HandTurn::take(std::optional<ObjectId> object) {
  m_object = object;
  m_degrees = 0;
  m_ways.reset();
  m_way = 0;
  m_wanted = 0;
}

void HandTurn::turn(double degrees) {
  m_degrees = std::fmod(m_degrees + degrees, 360);
  m_changed();
}

void HandTurn::next_way() {
  if (!m_object) return;
  if (!m_ways) {
    if (m_wanted++ == 0) m_document.request_ways(*m_object);
    return;
  }
  m_way = (m_way + 1) % (m_ways->size() + 1);
  m_changed();
}

void HandTurn::found(const WaysToLie& ways) {
  if (ways.object != m_object || m_wanted == 0) return;
  m_ways.emplace();
  for (const WayToLie& way : ways.ways)
    if (way.turn_deg >= kSameWayDeg) m_ways->push_back(way);
  m_way = static_cast<size_t>(std::exchange(m_wanted, 0)) % (m_ways->size() + 1);
  m_changed();
}

Rotation HandTurn::of(const Rotation& now) const {
  const Rotation lying = m_way > 0 ? (*m_ways)[m_way - 1].rotation : now;
  if (m_degrees == 0) return lying;
  return (turned_about(Vec3::UnitZ(), m_degrees) * lying).normalized();
}

}  // namespace trivet::edit
