// Appearance of a scene's objects in an editor: kept in layouts and scene files, of no influence on
// any operation.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace trivet {

struct ObjectLook {
  std::string object;
  bool hidden = false;                              // not drawn; still in the scene
  bool not_selectable = false;                      // clicks pass through it
  std::optional<std::array<float, 3>> colour = {};  // sRGB, 0 to 1
  friend bool operator==(const ObjectLook&, const ObjectLook&) = default;
};

/// Objects under one name, to be shown and selected together. An object is in one at most.
struct ObjectCollection {
  std::string name;  // unique
  bool hidden = false, not_selectable = false;
  std::vector<std::string> objects = {};
  friend bool operator==(const ObjectCollection&, const ObjectCollection&) = default;
};

/// Names are those of the objects after all operations of the layout; others mean nothing.
struct SceneLooks {
  std::vector<ObjectLook> objects;  // those that are not as by default
  std::vector<ObjectCollection> collections;
  bool empty() const { return objects.empty() && collections.empty(); }
  friend bool operator==(const SceneLooks&, const SceneLooks&) = default;
};

}  // namespace trivet
