// Names of new objects.
#pragma once

#include <set>
#include <string>

#include "apps/edit/document/snapshot.h"

namespace trivet::edit {

/// "cup 2", "cup 3", ... of "cup" or "cup 7": the first that the scene does not have.
/// @param taken  further names; gets the new one.
std::string free_name(const SceneSnapshot& scene, const std::string& like,
                      std::set<std::string>& taken);

}  // namespace trivet::edit
