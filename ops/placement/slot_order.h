// An order of objects that does not depend on the run.
#pragma once

#include "core/scene/scene.h"

namespace trivet {

inline bool by_slot(ObjectId a, ObjectId b) { return a.index < b.index; }

}  // namespace trivet
