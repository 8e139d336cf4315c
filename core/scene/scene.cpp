#include "core/scene/scene.h"

#include <algorithm>
#include <cassert>

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
  if (free_slot == m_slots.end()) m_slots.emplace_back();
  Slot& slot = m_slots[index];
  ++slot.generation;
  slot.order = m_next_order++;
  slot.object = std::move(object);
  return {static_cast<std::uint32_t>(index), slot.generation};
}

void Scene::remove(ObjectId id) {
  assert(contains(id));
  unlink(id);
  m_slots[id.index].object.reset();
}

bool Scene::contains(ObjectId id) const {
  return id.index < m_slots.size() && m_slots[id.index].object &&
         m_slots[id.index].generation == id.generation;
}

Object& Scene::at(ObjectId id) {
  assert(contains(id));
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
  std::sort(out.begin(), out.end(), [&](ObjectId a, ObjectId b) {
    return m_slots[a.index].order < m_slots[b.index].order;
  });
  return out;
}

Aabb Scene::box() const {
  Aabb out;
  for (const Slot& slot : m_slots)
    if (slot.object && slot.object->placed)
      out.extend(Body(*slot.object->shape, slot.object->world_from_object()).world_box);
  return out;
}

void Scene::unlink(ObjectId id) {
  for (Slot& slot : m_slots)
    if (slot.object) std::erase_if(slot.object->links, [&](const Link& l) { return l.with == id; });
  at(id).links.clear();
}

void Scene::link(ObjectId id, std::vector<Link> links) {
  // All that allocates comes first: nothing is half done when memory runs out.
  std::vector<std::pair<Object*, std::vector<Link>>> seen_by_others;
  for (Slot& slot : m_slots) {
    if (!slot.object || &*slot.object == &at(id)) continue;
    std::vector<Link> others = slot.object->links;
    std::erase_if(others, [&](const Link& l) { return l.with == id; });
    for (const Link& l : links)
      if (l.with && &at(*l.with) == &*slot.object) others.push_back({id, reversed(l.contact)});
    seen_by_others.emplace_back(&*slot.object, std::move(others));
  }
  for (auto& [object, others] : seen_by_others) object->links = std::move(others);
  at(id).links = std::move(links);
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

namespace {

bool holds_up(const Contact& contact) {
  return contact.normal.z() > kSupportNormalZ ||
         std::any_of(contact.points.begin(), contact.points.end(),
                     [](const ContactPoint& p) { return p.normal.z() > kSupportNormalZ; });
}

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
      if (l.with && holds_up(reversed(l.contact))) entry.loads.push_back(*l.with);
    }
    sort_by_slot(entry.supports);
    sort_by_slot(entry.loads);
    out.entries.push_back(std::move(entry));
  }
  return out;
}

}  // namespace trivet
