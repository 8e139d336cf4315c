// True if the scene stands as a whole, and which way what topples would go.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "apps/edit/document/snapshot.h"
#include "ops/stability/stability.h"

namespace trivet::edit {

/// Verdict at the materials' friction. Immutable.
struct SceneVerdict {
  std::uint64_t committed = 0;  // SceneSnapshot::committed of the judged scene
  Stability stability;

  /// Null: fixed or not placed.
  const ObjectStability* find(ObjectId id) const;
};

/// Arrow from the object's end that goes farthest, the way it goes; world, metres.
struct TopplingArrow {
  Vec3 from, to;
};
/// Nullopt: it does not topple. @param object  as judged.
std::optional<TopplingArrow> toppling_arrow(const Object& object, const ObjectStability& verdict);

/// "stands, margin 1.1 mm", "stands, but only just: ...", "topples: \"a\", \"b\" and 3 more".
std::string whole_text(const SceneSnapshot& scene, const SceneVerdict& verdict);
/// The same of one object.
std::string object_text(const Object& object, const ObjectStability& verdict);

}  // namespace trivet::edit
