#include "apps/edit/document/collections.h"

#include <algorithm>

namespace trivet::edit {

const Collection* Collections::find(const std::string& name) const {
  const auto found = std::find_if(m_all.begin(), m_all.end(),
                                  [&](const Collection& one) { return one.name == name; });
  return found == m_all.end() ? nullptr : &*found;
}

const Collection* Collections::of(ObjectId id) const {
  for (const Collection& one : m_all)
    if (std::find(one.objects.begin(), one.objects.end(), id) != one.objects.end()) return &one;
  return nullptr;
}

std::string Collections::free_name(const std::string& like) const {
  for (int i = 1;; ++i)
    if (std::string name = like + " " + std::to_string(i); !find(name)) return name;
}

void Collections::take_out(std::span<const ObjectId> objects) {
  for (Collection& one : m_all)
    std::erase_if(one.objects, [&](ObjectId id) {
      return std::find(objects.begin(), objects.end(), id) != objects.end();
    });
}

void Collections::put(std::span<const ObjectId> objects, const std::string& name) {
  take_out(objects);
  if (!find(name)) m_all.push_back({name});
  for (Collection& one : m_all)
    if (one.name == name) one.objects.insert(one.objects.end(), objects.begin(), objects.end());
}

void Collections::inherit(ObjectId from, ObjectId to) {
  if (of(to)) return;
  for (Collection& one : m_all)
    if (const auto at = std::find(one.objects.begin(), one.objects.end(), from);
        at != one.objects.end()) {
      one.objects.insert(at + 1, to);
      return;
    }
}

bool Collections::rename(const std::string& name, const std::string& to) {
  if (to.empty() || find(to)) return false;
  for (Collection& one : m_all)
    if (one.name == name) {
      one.name = to;
      return true;
    }
  return false;
}

void Collections::show(const std::string& name, bool hidden, bool not_selectable) {
  for (Collection& one : m_all)
    if (one.name == name) one.hidden = hidden, one.not_selectable = not_selectable;
}

void Collections::dissolve(const std::string& name) {
  std::erase_if(m_all, [&](const Collection& one) { return one.name == name; });
}

}  // namespace trivet::edit
