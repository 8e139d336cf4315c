#include "core/scene/scene.h"

#include <algorithm>
#include <cassert>
#include <iterator>
#include <type_traits>
#include <utility>

#include "core/base/error.h"
#include "core/base/make_room.h"
#include "core/base/tunables.h"
#include "core/contact/contact_points.h"

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

bool stands_on_its_own(const Object& object) {
  return object.state == ObjectState::Stable &&
         object.stability_margin >= kRestMargin * object.scale * object.shape->box.diagonal();
}

ObjectId Scene::add(Object object) {
  if (object.name.empty())
    throw Error(Error::Kind::BadInput, "an object has an empty name; every object needs one");
  if (find(object.name))
    throw Error(Error::Kind::BadInput, "two objects are named \"%1\"; names must be unique",
                object.name);
  // The lowest free slot is used again; its generation tells old ids from new ones.
  const Index free = m_index.first_free();
  const size_t index = free >= 0 ? free : m_slots.size();
  if (free < 0) {
    m_index.reserve(index + 1);
    m_generations.resize(index + 1);
    m_slots.emplace_back();
    refresh(index);
  }
  keep(index);
  // From here on, no allocation.
  Slot& slot = m_slots[index];
  slot.generation = ++m_generations[index];
  slot.order = m_next_order++;
  slot.object = std::move(object);
  ++m_num_objects;
  refresh(index);
  return {static_cast<std::uint32_t>(index), slot.generation};
}

void Scene::remove(ObjectId id) {
  assert(contains(id));
  keep(id.index);
  // Partners lose their contacts with the object before it goes.
  set_contacts(id, {});
  m_slots[id.index].object.reset();
  --m_num_objects;
  refresh(id.index);
}

bool Scene::contains(ObjectId id) const {
  return id.index < m_slots.size() && m_slots[id.index].object &&
         m_slots[id.index].generation == id.generation;
}

const Object& Scene::at(ObjectId id) const {
  assert(contains(id));
  return *m_slots[id.index].object;
}

std::optional<ObjectId> Scene::find(const std::string& name) const {
  // Names hash to chains: those that meet by chance are told apart here.
  std::optional<ObjectId> found;
  m_index.visit_named(name, [&](Index slot) {
    if (m_slots[slot].object->name == name) found = id_of(slot);
  });
  return found;
}

void Scene::sort(std::vector<ObjectId>& ids) const {
  const auto earlier = [&](ObjectId a, ObjectId b) {
    return m_slots[a.index].order < m_slots[b.index].order;
  };
  if (!std::is_sorted(ids.begin(), ids.end(), earlier)) std::sort(ids.begin(), ids.end(), earlier);
}

std::vector<ObjectId> Scene::ids() const {
  std::vector<ObjectId> out;
  out.reserve(m_num_objects);
  for (size_t i = 0; i < m_slots.size(); ++i)
    if (m_slots[i].object) out.push_back(id_of(static_cast<Index>(i)));
  sort(out);
  return out;
}

std::vector<ObjectId> Scene::near(const Aabb& box, double margin) const {
  std::vector<ObjectId> out;
  visit_near(box, margin, [&](ObjectId id) { out.push_back(id); });
  sort(out);
  return out;
}

std::vector<ObjectId> Scene::leaning_near(const Aabb& box) const {
  std::vector<ObjectId> out;
  m_index.tree().visit(
      [&](const ObjectTree::Extent& there) {
        return there.leaning_reach > 0 && overlaps(there.box, box, there.leaning_reach);
      },
      [&](Index slot) { out.push_back(id_of(slot)); });
  sort(out);
  return out;
}

std::vector<ObjectId> Scene::invalid_objects() const {
  std::vector<ObjectId> out;
  m_index.visit_invalid([&](Index slot) { out.push_back(id_of(slot)); });
  sort(out);
  return out;
}

std::vector<ObjectId> Scene::group_members(const std::string& group) const {
  std::vector<ObjectId> out;
  if (group.empty()) return out;
  m_index.visit_group(group, [&](Index slot) {
    if (m_slots[slot].object->group == group) out.push_back(id_of(slot));
  });
  sort(out);
  return out;
}

Aabb Scene::world_box(ObjectId id) const {
  assert(contains(id));
  return m_index.tree().at(static_cast<Index>(id.index)).box;
}

SceneExtent Scene::extent_without(std::span<const ObjectId> left_out) const {
  std::vector<Index> slots;
  for (const ObjectId id : left_out)
    if (contains(id)) slots.push_back(static_cast<Index>(id.index));
  return m_index.tree().extent_without(slots);
}

namespace {

bool is_within(const Aabb& inner, const Aabb& outer) {
  return (inner.lower.array() >= outer.lower.array()).all() &&
         (inner.upper.array() <= outer.upper.array()).all();
}

}  // namespace

SceneExtent Scene::extent_near(const Aabb& box, double margin) const {
  const ObjectTree& tree = m_index.tree();
  const SceneExtent all = tree.extent();
  // Most scenes lie within the margin as a whole.
  if (is_within(all.box, {box.lower.array() - margin, box.upper.array() + margin})) return all;
  SceneExtent out;
  // A subtree that would change neither box nor sizes is left out.
  const auto adds = [&](const SceneExtent& there) {
    return !is_within(there.box, out.box) || there.coarse_size > out.coarse_size ||
           there.smallest_diagonal < out.smallest_diagonal;
  };
  tree.visit(
      [&](const SceneExtent& there) { return overlaps(there.box, box, margin) && adds(there); },
      [&](Index slot) { out.unite(tree.at(slot)); });
  return out;
}

void Scene::set_contacts(ObjectId id, std::vector<ObjectContact> object_contacts) {
  // All that allocates comes first: nothing is half done when memory runs out.
  std::map<std::uint32_t, std::vector<ObjectContact>> new_of_others;
  const auto note = [&](const ObjectContact& l) -> std::vector<ObjectContact>* {
    if (l.with.is_floor() || l.with == Support(id)) return nullptr;
    assert(contains(l.with.object()));
    return &new_of_others[l.with.object().index];
  };
  for (const ObjectContact& l : at(id).contacts) note(l);
  for (const ObjectContact& l : object_contacts)
    if (std::vector<ObjectContact>* others = note(l))
      others->push_back({id, reversed(l.contact), l.across_gap, l.is_carried, l.carries});
  keep(id.index);
  for (const auto& [index, news] : new_of_others) {
    keep(index);
    std::vector<ObjectContact>& contacts = m_slots[index].object->contacts;
    make_room(contacts, contacts.size() + news.size());
  }
  // The floor first, then in the scene's order, whoever was linked last.
  const auto earlier = [&](const ObjectContact& a, const ObjectContact& b) {
    if (a.with.is_floor() || b.with.is_floor()) return a.with.is_floor() && !b.with.is_floor();
    return m_slots[a.with.object().index].order < m_slots[b.with.object().index].order;
  };
  const auto sort_links = [&](std::vector<ObjectContact>& contacts) {
    if (!std::is_sorted(contacts.begin(), contacts.end(), earlier))
      std::sort(contacts.begin(), contacts.end(), earlier);
  };
  for (auto& [index, news] : new_of_others) {
    std::vector<ObjectContact>& contacts = m_slots[index].object->contacts;
    std::erase_if(contacts, [&](const ObjectContact& other) { return other.with == Support(id); });
    std::move(news.begin(), news.end(), std::back_inserter(contacts));
    sort_links(contacts);
  }
  sort_links(object_contacts);
  m_slots[id.index].object->contacts = std::move(object_contacts);
}

Scene::Open& Scene::Open::operator=(const Open&) noexcept {
  assert(!change);
  return *this;
}

void Scene::keep(size_t index) {
  if (m_open.change) m_open.change->m_slots.try_emplace(index, m_slots[index]);
}

void Scene::refresh(size_t index) noexcept {
  const std::optional<Object>& object = m_slots[index].object;
  m_index.set(static_cast<Index>(index), object ? &*object : nullptr);
}

void Scene::exchange(SceneChange& change) noexcept {
  assert(!m_open.change);
  swap_with(change);
}

void Scene::swap_with(SceneChange& change) noexcept {
  static_assert(std::is_nothrow_swappable_v<Slot>);
  for (auto& [index, slot] : change.m_slots) {
    m_num_objects -= m_slots[index].object.has_value();
    std::swap(m_slots[index], slot);
    m_num_objects += m_slots[index].object.has_value();
    refresh(index);
  }
  std::swap(m_next_order, change.m_next_order);
}

bool Scene::is_consistent() const {
  // Everything is found anew from the objects and compared with what the indices say.
  const std::vector<ObjectId> ids = this->ids();
  ObjectTree::Extent all;
  for (const ObjectId id : ids) {
    const Object& object = at(id);
    const ObjectTree& tree = m_index.tree();
    const bool placed = object.placed && object.shape;
    if (find(object.name) != id || tree.contains(static_cast<Index>(id.index)) != placed)
      return false;
    if (!placed) continue;
    const ObjectTree::Extent extent = extent_of(object);
    const Aabb box = extent.box.empty() ? Aabb{} : extent.box, there = world_box(id);
    if (box.lower != there.lower || box.upper != there.upper) return false;
    all.unite({box, extent.smallest_diagonal > 0 ? extent.smallest_diagonal : kInfinity, 0,
               extent.coarse_size});
  }
  const auto free_slot =
      std::find_if(m_slots.begin(), m_slots.end(), [](const Slot& slot) { return !slot.object; });
  const auto first = free_slot == m_slots.end() ? -1 : free_slot - m_slots.begin();
  const ObjectTree::Extent known = m_index.tree().extent();
  return m_index.tree().is_valid() && ids.size() == m_num_objects &&
         m_index.first_free() == first && all.box.lower == known.box.lower &&
         all.box.upper == known.box.upper && all.smallest_diagonal == known.smallest_diagonal &&
         all.coarse_size == known.coarse_size;
}

std::vector<ObjectId> SceneChange::ids() const {
  std::vector<ObjectId> out;
  for (const auto& [index, slot] : m_slots)
    if (slot.object) out.push_back({static_cast<std::uint32_t>(index), slot.generation});
  return out;
}

}  // namespace trivet
