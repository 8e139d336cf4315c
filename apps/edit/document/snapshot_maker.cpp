#include "apps/edit/document/snapshot_maker.h"

#include <algorithm>

#include "core/base/tunables.h"
#include "core/scene/joint.h"
#include "ops/placement/neighbourhood.h"
#include "ops/placement/verify.h"

namespace trivet::edit {
namespace {

constexpr std::uint32_t kNowhere = 0xffffffff;
constexpr size_t kMostInvalid = 32;  // limit for the search of crossing faces

std::shared_ptr<const std::vector<InvalidObject>> with_faces_lit(const Scene& scene) {
  std::vector<InvalidObject> found;
  for (const ObjectId id : scene.invalid_objects()) {
    if (found.size() == kMostInvalid) break;
    const Placement here{id, scene.at(id).pose};
    found.push_back({id, crossing_faces(scene, {&here, 1})});
  }
  if (found.empty()) return nullptr;
  return std::make_shared<const std::vector<InvalidObject>>(std::move(found));
}

bool is_free(const Operation& operation) {
  if (const auto* const move = std::get_if<TranslateOperation>(&operation)) return move->free;
  const auto* const rotate = std::get_if<RotateOperation>(&operation);
  return rotate && rotate->free;
}

// The object is a copy of this snapshot's own.
void show_joint_value(double value, ObjectId link, SceneSnapshot& snapshot) {
  ObjectSnapshot& shown = snapshot.objects[snapshot.position_of_slot[link.index]];
  auto joint = std::make_shared<LinkJoint>(*shown->joint);
  joint->value = value;
  auto moved = std::make_shared<Object>(*shown.object);
  moved->joint = std::move(joint);
  shown.object = std::move(moved);
}

void note_in_the_way(const Scene& scene, const LiveMove& live, DragSnapshot& drag) {
  if (is_free(live.operation()))
    drag.faces = crossing_faces(scene, live.placements());
  else if (drag.blocked_by.support)
    drag.faces =
        blocking_faces(scene, live.placements(), {*drag.blocked_by.support, drag.blocked_at},
                       kContactTolerance * live.clearance());
}

}  // namespace

void SnapshotMaker::forget() {
  m_last.reset();
  m_changed.clear();
}

void SnapshotMaker::note_changed(std::span<const ObjectId> ids) {
  m_changed.insert(m_changed.end(), ids.begin(), ids.end());
}

std::shared_ptr<const SceneSnapshot> SnapshotMaker::make(const Scene& scene, double clearance,
                                                         std::optional<SettledWay> way) {
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
  made->invalid = with_faces_lit(scene);
  if (way) made->way = std::make_shared<const SettledWay>(std::move(*way));
  m_changed.clear();
  m_last = made;
  return made;
}

std::shared_ptr<const SceneSnapshot> SnapshotMaker::make_drag(const Scene& scene,
                                                              const LiveMove& live,
                                                              const std::optional<Motion>& motion) {
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
  if (result.joint_value) show_joint_value(*result.joint_value, drag.moving.front(), *made);
  drag.contacts = live.contacts();
  if (motion) drag.volume = projection_volume(live.bodies(), *motion);
  drag.end = result.end;
  drag.blocked = result.end != OperationResult::End::Reached;
  if (drag.blocked && result.end != OperationResult::End::Edge) {
    drag.blocked_by = result.blocked_by;
    drag.blocked_at = result.blocked_at;
  }
  note_in_the_way(scene, live, drag);
  return made;
}

std::shared_ptr<const SceneSnapshot> SnapshotMaker::make_falling(
    std::shared_ptr<const Object> falling) {
  auto made = std::make_shared<SceneSnapshot>(*m_last);
  made->revision = ++m_revision;
  made->falling = std::move(falling);
  return made;
}

std::shared_ptr<const SceneSnapshot> SnapshotMaker::make_again() {
  auto made = std::make_shared<SceneSnapshot>(*m_last);
  made->revision = ++m_revision;
  m_last = made;
  return made;
}

}  // namespace trivet::edit
