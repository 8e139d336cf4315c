// Messages to the user: no outcome is silent.
#pragma once

#include <string>
#include <vector>

#include "ops/placement/interference.h"

namespace trivet::edit {

struct Message {
  enum class Kind {
    Info,     // done, with a note: carried objects, blocked by
    Warning,  // done, with a defect: left without support, interpenetrates
    Refused,  // an operation refused by the geometry: the scene is unchanged
    Error,    // file or disk: names the item, the value and what is accepted
  };
  Kind kind = Kind::Info;
  std::string text;
  std::vector<ObjectId> objects;  // highlighted in the scene
  std::vector<Vec3> points;       // marked in the scene, world
  InterferingFaces faces = {};    // of the stopped object and of the one that stopped it
};

}  // namespace trivet::edit
