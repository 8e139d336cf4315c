#include "apps/edit/document/snapshot_maker.h"

#include <algorithm>

namespace trivet::edit {

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
  made->support = std::make_shared<const LoadSupport>(load_support(scene));
  m_changed.clear();
  m_last = made;
  return made;
}

}  // namespace trivet::edit
