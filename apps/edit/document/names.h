// Objects by name, and names of new ones.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "apps/edit/document/snapshot.h"

namespace trivet::edit {

/// "cup 2", "cup 3", ... of "cup" or "cup 7": the first that the scene does not have.
/// @param taken  further names; gets the new one.
std::string free_name(const SceneSnapshot& scene, const std::string& like,
                      std::set<std::string>& taken);

/// Objects of these names, in that order; without those that the scene does not have.
std::vector<const Object*> objects_named(const SceneSnapshot& scene,
                                         const std::vector<std::string>& names);

}  // namespace trivet::edit
