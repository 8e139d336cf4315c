// What the editor says to the user: never a silent nothing.
#pragma once

#include <string>
#include <vector>

#include "ops/placement/interference.h"

namespace trivet::edit {

struct Message {
  enum class Kind {
    Info,     // done, with something to say: what was carried, blocked by
    Warning,  // done, and something is not as it should be: left without support, interpenetrates
    Refused,  // an operation, by the geometry: the scene is as it was
    Error,    // a file, the disk: names what, the value and what is accepted
  };
  Kind kind = Kind::Info;
  std::string text;
  std::vector<ObjectId> objects;  // to be lit in the scene
  std::vector<Vec3> points;       // to be marked there, world
  InterferingFaces faces = {};    // of what was stopped and of what stopped it
};

}  // namespace trivet::edit
