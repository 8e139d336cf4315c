// Orders of objects that do not depend on the run.
#pragma once

#include "core/scene/scene.h"

namespace trivet {

inline bool by_slot(ObjectId a, ObjectId b) { return a.index < b.index; }

/// The same in a scene that is saved and read again, where slots are others.
inline auto by_name(const Scene& scene) {
  return [&scene](ObjectId a, ObjectId b) { return scene.at(a).name < scene.at(b).name; };
}

}  // namespace trivet
