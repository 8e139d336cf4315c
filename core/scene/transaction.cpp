#include "core/scene/transaction.h"

#include <algorithm>
#include <cassert>

namespace trivet {

Transaction::Transaction(Scene& scene) noexcept : m_scene(scene), m_outer(scene.m_open.change) {
  m_before.m_next_order = scene.m_next_order;
  scene.m_open.change = &m_before;
}

Transaction::~Transaction() {
  if (m_open) rollback();
}

void Transaction::rollback() noexcept {
  assert(is_innermost());
  m_open = false;
  // All slots that were touched change places with what they were before.
  m_scene.m_open.change = m_outer;
  m_scene.swap_with(m_before);
}

ObjectId Transaction::add(Object object) {
  assert(is_innermost());
  return m_scene.add(std::move(object));
}

void Transaction::remove(ObjectId id) {
  assert(is_innermost());
  m_scene.remove(id);
}

void Transaction::set_contacts(ObjectId id, std::vector<ObjectContact> object_contacts) {
  assert(is_innermost());
  m_scene.set_contacts(id, std::move(object_contacts));
}

Transaction::Refresh::Refresh(Transaction& transaction, ObjectId id)
    : m_scene(transaction.m_scene), m_index(id.index) {
  assert(transaction.is_innermost() && m_scene.contains(id));
  m_scene.keep(m_index);
}

Transaction::Refresh::~Refresh() { m_scene.refresh(m_index); }

Object& Transaction::Refresh::object() const { return *m_scene.m_slots[m_index].object; }

std::vector<ObjectId> Transaction::touched() const {
  std::vector<ObjectId> out;
  for (const auto& [index, before] : m_before.m_slots) {
    // A slot may have lost one object and got another.
    const Scene::Slot& now = m_scene.m_slots[index];
    if (before.object) out.push_back({static_cast<std::uint32_t>(index), before.generation});
    if (now.object && !(before.object && before.generation == now.generation))
      out.push_back({static_cast<std::uint32_t>(index), now.generation});
  }
  return out;
}

SceneChange Transaction::commit() noexcept {
  assert(is_innermost());
  m_open = false;
  m_scene.m_open.change = m_outer;
  // Entries that the outer one has are older and stay; the rest change hands as tree nodes.
  if (m_outer) m_outer->m_slots.merge(m_before.m_slots), m_before.m_slots.clear();
  return std::move(m_before);
}

}  // namespace trivet
