#include "apps/edit/document/names.h"

namespace trivet::edit {

namespace {

std::string without_number(const std::string& name) {
  const size_t space = name.find_last_of(' ');
  const bool is_numbered = space != std::string::npos && space + 1 < name.size() &&
                           name.find_first_not_of("0123456789", space + 1) == std::string::npos;
  return is_numbered ? name.substr(0, space) : name;
}

}  // namespace

NewNames::NewNames(const SceneSnapshot& scene) {
  for (const ObjectSnapshot& object : scene.objects) m_taken.insert(object->name);
}

std::string NewNames::like(const std::string& name) {
  const std::string stem = without_number(name);
  for (int& number = m_next.try_emplace(stem, 2).first->second;; ++number) {
    std::string out = stem;
    out.append(" ").append(std::to_string(number));
    if (m_taken.insert(out).second) return out;
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
