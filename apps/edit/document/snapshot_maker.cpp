#include "apps/edit/document/snapshot_maker.h"

#include <algorithm>

namespace trivet::edit {
namespace {

constexpr std::uint32_t kNowhere = 0xffffffff;

}  // namespace

void SnapshotMaker::forget() {
  m_last.reset();
  m_changed.clear();
}

void SnapshotMaker::note_changed(std::span<const ObjectId> ids) {
  m_changed.insert(m_changed.end(), ids.begin(), ids.end());
}

std::shared_ptr<const SceneSnapshot> SnapshotMaker::make(const Scene& scene, double clearance) {
  auto made = std::make_shared<SceneSnapshot>();
  made->revision = ++m_revision;
  made->committed = ++m_committed;
  made->floor = scene.floor;
  made->clearance = clearance;
  for (const ObjectId id : scene.ids()) {
    const bool changed = std::find(m_changed.begin(), m_changed.end(), id) != m_changed.end();
    const ObjectSnapshot* const old = m_last && !changed ? m_last->find(id) : nullptr;
    made->objects.push_back(
        old ? *old : ObjectSnapshot{id, std::make_shared<const Object>(scene.at(id)), m_revision});
  }
  for (size_t i = 0; i < made->objects.size(); ++i) {
    const size_t slot = made->objects[i].id.index;
    if (slot >= made->position_of_slot.size()) made->position_of_slot.resize(slot + 1, kNowhere);
    made->position_of_slot[slot] = static_cast<std::uint32_t>(i);
  }
  made->support = std::make_shared<const LoadSupport>(load_support(scene));
  m_changed.clear();
  m_last = made;
  return made;
}

std::shared_ptr<const SceneSnapshot> SnapshotMaker::make_drag(const LiveMove& live) {
  auto made = std::make_shared<SceneSnapshot>(*m_last);
  made->revision = ++m_revision;
  DragSnapshot& drag = made->drag.emplace();
  for (const Placement& placement : live.placements()) {
    drag.moving.push_back(placement.id);
    ObjectSnapshot& shown = made->objects[made->position_of_slot[placement.id.index]];
    auto moved = std::make_shared<Object>(*shown.object);
    moved->pose = placement.pose;
    shown = {placement.id, std::move(moved), m_revision};
  }
  const OperationResult& result = live.result();
  drag.contacts = live.contacts();
  drag.end = result.end;
  drag.blocked = result.end != OperationResult::End::Reached;
  if (drag.blocked && result.end != OperationResult::End::Edge) {
    drag.blocked_by = result.blocked_by;
    drag.blocked_at = result.blocked_at;
  }
  return made;
}

std::shared_ptr<const SceneSnapshot> SnapshotMaker::make_again() {
  auto made = std::make_shared<SceneSnapshot>(*m_last);
  made->revision = ++m_revision;
  m_last = made;
  return made;
}

}  // namespace trivet::edit
