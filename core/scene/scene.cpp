#include "core/scene/scene.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "core/base/error.h"
#include "core/contact/body.h"

namespace trivet {

const char* to_string(ObjectState state) {
  switch (state) {
    case ObjectState::Unplaced:
      return "unplaced";
    case ObjectState::Fixed:
      return "fixed";
    case ObjectState::Stable:
      return "stable";
    case ObjectState::Wedged:
      return "wedged";
    case ObjectState::Held:
      return "held";
    case ObjectState::Unsupported:
      return "unsupported";
    case ObjectState::Invalid:
      return "invalid";
  }
  return "?";
}

ObjectId Scene::add(Object object) {
  if (object.name.empty())
    throw Error(Error::Kind::BadInput, "an object has an empty name; every object needs one");
  if (find(object.name))
    throw Error(Error::Kind::BadInput,
                "two objects are named \"" + object.name + "\"; names must be unique");
  const auto free_slot =
      std::find_if(m_slots.begin(), m_slots.end(), [](const Slot& slot) { return !slot.object; });
  const size_t index = free_slot - m_slots.begin();
  if (free_slot == m_slots.end()) {
    m_slots.emplace_back();
    m_generations.push_back(0);
  }
  keep(index);
  Slot& slot = m_slots[index];
  slot.generation = ++m_generations[index];
  slot.order = m_next_order++;
  slot.object = std::move(object);
  return {static_cast<std::uint32_t>(index), slot.generation};
}

void Scene::remove(ObjectId id) {
  assert(contains(id));
  unlink(id);
  keep(id.index);
  m_slots[id.index].object.reset();
}

bool Scene::contains(ObjectId id) const {
  return id.index < m_slots.size() && m_slots[id.index].object &&
         m_slots[id.index].generation == id.generation;
}

Object& Scene::at(ObjectId id) {
  assert(contains(id));
  keep(id.index);
  return *m_slots[id.index].object;
}

const Object& Scene::at(ObjectId id) const {
  assert(contains(id));
  return *m_slots[id.index].object;
}

std::optional<ObjectId> Scene::find(const std::string& name) const {
  for (size_t i = 0; i < m_slots.size(); ++i)
    if (m_slots[i].object && m_slots[i].object->name == name)
      return ObjectId{static_cast<std::uint32_t>(i), m_slots[i].generation};
  return std::nullopt;
}

std::vector<ObjectId> Scene::ids() const {
  std::vector<ObjectId> out;
  for (size_t i = 0; i < m_slots.size(); ++i)
    if (m_slots[i].object) out.push_back({static_cast<std::uint32_t>(i), m_slots[i].generation});
  const auto earlier = [&](ObjectId a, ObjectId b) {
    return m_slots[a.index].order < m_slots[b.index].order;
  };
  if (!std::is_sorted(out.begin(), out.end(), earlier)) std::sort(out.begin(), out.end(), earlier);
  return out;
}

Aabb Scene::box() const {
  Aabb out;
  for (const Slot& slot : m_slots)
    if (slot.object && slot.object->placed)
      out.extend(Body(*slot.object->shape, slot.object->world_from_object()).world_box);
  return out;
}

void Scene::unlink(ObjectId id) { link(id, {}); }

void Scene::link(ObjectId id, std::vector<Link> links) {
  // All that allocates comes first: nothing is half done when memory runs out.
  std::map<std::uint32_t, std::vector<Link>> seen_by_others;
  const auto note = [&](const Link& l) -> std::vector<Link>* {
    if (!l.with || *l.with == id) return nullptr;
    const auto [it, is_new] = seen_by_others.try_emplace(l.with->index);
    if (is_new) {
      it->second = std::as_const(*this).at(*l.with).links;
      std::erase_if(it->second, [&](const Link& other) { return other.with == id; });
    }
    return &it->second;
  };
  for (const Link& l : std::as_const(*this).at(id).links) note(l);
  for (const Link& l : links)
    if (std::vector<Link>* others = note(l)) others->push_back({id, reversed(l.contact)});
  keep(id.index);
  for (const auto& [index, others] : seen_by_others) keep(index);
  for (auto& [index, others] : seen_by_others) m_slots[index].object->links = std::move(others);
  m_slots[id.index].object->links = std::move(links);
}

void Scene::keep(size_t index) {
  if (m_recording) m_kept.try_emplace(index, m_slots[index]);
}

void Scene::start_recording() {
  assert(!m_recording);
  m_recording = true;
  m_order_before = m_next_order;
}

SceneChange Scene::stop_recording() {
  assert(m_recording);
  m_recording = false;
  SceneChange change;
  change.m_slots = std::exchange(m_kept, {});
  change.m_next_order = m_order_before;
  return change;
}

void Scene::exchange(SceneChange& change) {
  assert(!m_recording);
  for (auto& [index, slot] : change.m_slots) std::swap(m_slots[index], slot);
  std::swap(m_next_order, change.m_next_order);
}

std::vector<ObjectId> SceneChange::ids() const {
  std::vector<ObjectId> out;
  for (const auto& [index, slot] : m_slots)
    if (slot.object) out.push_back({static_cast<std::uint32_t>(index), slot.generation});
  return out;
}

Contact reversed(const Contact& contact) {
  Contact out = contact;
  out.normal = -contact.normal;
  std::swap(out.faces_object, out.faces_support);
  for (ContactPoint& p : out.points) {
    p.normal = -p.normal;
    std::swap(p.feature_object, p.feature_support);
    if (p.features == ContactFeatures::VertexFace)
      p.features = ContactFeatures::FaceVertex;
    else if (p.features == ContactFeatures::FaceVertex)
      p.features = ContactFeatures::VertexFace;
  }
  return out;
}

bool holds_up(const Contact& contact) {
  return contact.normal.z() > kSupportNormalZ ||
         std::any_of(contact.points.begin(), contact.points.end(),
                     [](const ContactPoint& p) { return p.normal.z() > kSupportNormalZ; });
}

bool weighs_on(const Contact& contact) {
  return contact.normal.z() < -kSupportNormalZ ||
         std::any_of(contact.points.begin(), contact.points.end(),
                     [](const ContactPoint& p) { return p.normal.z() < -kSupportNormalZ; });
}

namespace {

void sort_by_slot(std::vector<ObjectId>& ids) {
  std::sort(ids.begin(), ids.end(), [](ObjectId a, ObjectId b) { return a.index < b.index; });
}

}  // namespace

LoadSupport load_support(const Scene& scene) {
  LoadSupport out;
  for (const ObjectId id : scene.ids()) {
    const Object& object = scene.at(id);
    if (!object.placed) continue;
    LoadSupport::Entry entry{id, false, {}, {}};
    for (const Link& l : object.links) {
      if (holds_up(l.contact)) {
        if (l.with)
          entry.supports.push_back(*l.with);
        else
          entry.on_floor = true;
      }
      if (l.with && weighs_on(l.contact)) entry.loads.push_back(*l.with);
    }
    sort_by_slot(entry.supports);
    sort_by_slot(entry.loads);
    out.entries.push_back(std::move(entry));
  }
  return out;
}

}  // namespace trivet
