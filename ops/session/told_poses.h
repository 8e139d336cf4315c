// Poses that a client of a session has been told, so that an answer has those alone that changed.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/scene/scene.h"
#include "ops/files/report/json_parts.h"

namespace trivet {

/// "position" and "rotation" (w, x, y, z) of a placed object; both null of one out of the scene.
void add_pose(const Object& object, OrderedJson& json);

class ToldPoses {
 public:
  explicit ToldPoses(const Scene& scene);

  /// An entry for every object of these that is elsewhere than it was told, came, went or has
  /// another name; a name that no object has any more is out of the scene.
  OrderedJson news(const Scene& scene, const std::vector<ObjectId>& changed);

 private:
  using Key = std::pair<std::uint32_t, std::uint32_t>;
  struct Told {
    std::string name;
    std::optional<Pose> pose;  // nullopt: out of the scene
  };
  static Key key(ObjectId id) { return {id.index, id.generation}; }
  static Told told_of(const Object& object);

  std::map<Key, Told> m_told;
};

}  // namespace trivet
