// Where an object would come to rest if it were let go.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/scene/scene.h"
#include "ops/operations/perform.h"

namespace trivet::edit {

struct Ghost {
  ObjectId object;
  Operation operation;  // that would bring it there
  bool ok = false;      // else it cannot be done, and `text` says why
  std::string text;
  struct Member {
    ObjectId id;
    Pose pose;
  };
  std::vector<Member> members;  // the object first, then what it carries; empty unless ok
  ObjectState state = ObjectState::Stable;
  std::vector<ObjectId> objects;  // that are in the way, or that hold it
  std::vector<Vec3> points;       // where, world
  double milliseconds = 0;        // from the request to the answer
};

}  // namespace trivet::edit
