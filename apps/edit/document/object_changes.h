// Changes of objects in a step: other names, or other objects of the same name.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "apps/edit/document/snapshot.h"

namespace trivet::edit {

struct ObjectChanges {
  std::map<std::string, std::string> renamed;         // old name, new name
  std::vector<std::pair<ObjectId, ObjectId>> remade;  // of one name: gone, new
};

/// Changes between two snapshots of one scene. O(objects).
ObjectChanges changes_between(const SceneSnapshot& before, const SceneSnapshot& now);

}  // namespace trivet::edit
