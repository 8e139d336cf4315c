// Preview of an object's resting pose.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/scene/scene.h"
#include "ops/operations/perform.h"

namespace trivet::edit {

struct Ghost {
  ObjectId object;
  Operation operation;      // leads to this pose
  bool ok = false;          // otherwise refused; `text` gives the reason
  bool hangs_back = false;  // ok, but where it was wanted last was refused; `text` says why
  std::string text;
  struct Member {
    ObjectId id;
    Pose pose;
  };
  std::vector<Member> members;  // the object first, then its loads; of a refused PUT at its start,
                                // of others empty
  ObjectState state = ObjectState::Stable;
  std::vector<ObjectId> objects;  // blocking or holding objects
  std::vector<Vec3> points;       // contact points, world
  double milliseconds = 0;        // from request to answer
  double work_milliseconds = 0;   // of the processor, for the answer
};

}  // namespace trivet::edit
