// Report of a scene that was brought to rest.
#pragma once

#include <string>
#include <vector>

#include "core/base/sentence.h"
#include "core/motion/pose.h"
#include "core/scene/support.h"

namespace trivet {

/// An object that was moved.
struct SettledObject {
  ObjectId id;
  std::string name;
  Pose from, to;
  double moved = 0;       // metres, of its centre of mass
  double turned_deg = 0;  // by the shortest turn
};

/// An object that stays where it was, though it should not.
struct UnsettledObject {
  ObjectId id;
  std::string name;
  Sentence why;
};

struct SettledScene {
  std::vector<SettledObject> moved;     // in the scene's order
  std::vector<UnsettledObject> unable;  // by the order in which they were tried
};

/// A change of an object's supports.
struct ChangedRelation {
  std::string object;
  std::vector<std::string> lost, gained;  // names; "floor"
};

struct MendedScene : SettledScene {
  double tolerance = 0;                    // metres, that was used; 0: nothing was meant
  size_t num_kept = 0, num_meant = 0;      // supports of objects that were looked at
  std::vector<ChangedRelation> relations;  // of objects whose supports are not those meant
};

}  // namespace trivet
