#include "apps/edit/document/looks.h"

#include "apps/edit/document/snapshot.h"

namespace trivet::edit {

Look Looks::of(ObjectId id) const {
  const auto found = m_looks.find({id.index, id.generation});
  return found == m_looks.end() ? Look() : found->second;
}

void Looks::change(ObjectId id, const Look& look) {
  if (look == Look())
    m_looks.erase({id.index, id.generation});
  else
    m_looks[{id.index, id.generation}] = look;
}

void Looks::inherit(ObjectId from, ObjectId to) {
  if (of(to) == Look()) change(to, of(from));
  collections.inherit(from, to);
}

std::vector<ObjectId> Looks::differing(const Looks& other) const {
  std::vector<ObjectId> out;
  for (const auto& [key, look] : m_looks)
    if (const ObjectId id{key.first, key.second}; look != other.of(id)) out.push_back(id);
  for (const auto& [key, look] : other.m_looks)
    if (!m_looks.count(key)) out.push_back({key.first, key.second});
  return out;
}

Looks Looks::changed(const Looks& from, const Looks& to) const {
  Looks out = *this;
  if (!(from.collections == to.collections)) out.collections = to.collections;
  for (const ObjectId id : from.differing(to)) out.change(id, to.of(id));
  return out;
}

Look Looks::shown(ObjectId id) const {
  Look out = of(id);
  if (const Collection* const in = collections.of(id)) {
    out.hidden |= in->hidden;
    out.not_selectable |= in->not_selectable;
  }
  return out;
}

std::vector<ObjectId> Looks::those(const std::function<bool(const Look&)>& wanted) const {
  std::vector<ObjectId> out;
  for (const auto& [key, look] : m_looks)
    if (wanted(look)) out.push_back({key.first, key.second});
  for (const Collection& one : collections.all())
    if (wanted({one.hidden, one.not_selectable, std::nullopt}))
      out.insert(out.end(), one.objects.begin(), one.objects.end());
  return out;
}

std::vector<ObjectId> Looks::hidden() const {
  return those([](const Look& look) { return look.hidden; });
}

std::vector<ObjectId> Looks::not_selectable() const {
  return those([](const Look& look) { return look.hidden || look.not_selectable; });
}

SceneLooks Looks::named(const std::function<std::string(ObjectId)>& name_of) const {
  SceneLooks out;
  for (const auto& [key, look] : m_looks)
    if (std::string name = name_of({key.first, key.second}); !name.empty())
      out.objects.push_back({std::move(name), look.hidden, look.not_selectable, look.colour});
  for (const Collection& one : collections.all()) {
    ObjectCollection& entry = out.collections.emplace_back();
    entry.name = one.name;
    entry.hidden = one.hidden, entry.not_selectable = one.not_selectable;
    for (const ObjectId id : one.objects)
      if (std::string name = name_of(id); !name.empty()) entry.objects.push_back(std::move(name));
  }
  return out;
}

Looks Looks::of_file(const SceneLooks& looks, const SceneSnapshot& scene) {
  Looks out;
  for (const ObjectLook& look : looks.objects)
    if (const ObjectSnapshot* const found = scene.find(look.object))
      out.change(found->id, {look.hidden, look.not_selectable, look.colour});
  for (const ObjectCollection& entry : looks.collections) {
    std::vector<ObjectId> objects;
    for (const std::string& name : entry.objects)
      if (const ObjectSnapshot* const found = scene.find(name)) objects.push_back(found->id);
    out.collections.put(objects, entry.name);
    out.collections.show(entry.name, entry.hidden, entry.not_selectable);
  }
  return out;
}

std::function<std::string(ObjectId)> names_in(const SceneSnapshot& scene) {
  return [&scene](ObjectId id) {
    const ObjectSnapshot* const found = scene.find(id);
    return found ? (*found)->name : std::string();
  };
}

}  // namespace trivet::edit
