#include "apps/edit/document/names.h"

#include <algorithm>

namespace trivet::edit {

std::string free_name(const SceneSnapshot& scene, const std::string& like,
                      std::set<std::string>& taken) {
  std::string stem = like;
  const size_t space = stem.find_last_of(' ');
  if (space != std::string::npos && space + 1 < stem.size() &&
      std::all_of(stem.begin() + static_cast<std::ptrdiff_t>(space) + 1, stem.end(),
                  [](char c) { return c >= '0' && c <= '9'; }))
    stem.resize(space);
  for (int i = 2;; ++i) {
    std::string name = stem;
    name.append(" ").append(std::to_string(i));
    if (!scene.find(name) && taken.insert(name).second) return name;
  }
}

std::vector<const Object*> objects_named(const SceneSnapshot& scene,
                                         const std::vector<std::string>& names) {
  std::vector<const Object*> out;
  out.reserve(names.size());
  for (const std::string& name : names)
    if (const ObjectSnapshot* const found = scene.find(name)) out.push_back(found->object.get());
  return out;
}

}  // namespace trivet::edit
