// Objects by name, and names of new ones.
#pragma once

#include <map>
#include <string>
#include <unordered_set>
#include <vector>

#include "apps/edit/document/snapshot.h"

namespace trivet::edit {

/// Names that a scene does not have, each once.
class NewNames {
 public:
  explicit NewNames(const SceneSnapshot& scene);
  /// "cup 2", "cup 3", ... of "cup" or "cup 7": the first that is free.
  std::string like(const std::string& name);

 private:
  std::unordered_set<std::string> m_taken;
  std::map<std::string, int> m_next;  // number by what stands before it
};

/// Objects of these names, in that order; without those that the scene does not have.
std::vector<const Object*> objects_named(const SceneSnapshot& scene,
                                         const std::vector<std::string>& names);

}  // namespace trivet::edit
