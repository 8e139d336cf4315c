// The exact test that every pose passes before it is committed.
#pragma once

#include <string>

#include "core/exact/interpenetration.h"
#include "core/scene/scene.h"

namespace trivet {

/// kRelativeClearance of the scene's size or its largest coordinate, with `extra` (the object to
/// be placed) in it.
double default_clearance(const Scene& scene, const Aabb& extra = {});

/// The box an object at `start` will probably come to lie in: its footprint, no higher above what
/// is there than it is high. (Its start may be far above the scene.)
Aabb expected_box(const Scene& scene, const Object& object, const Pose& start);

/// An object's vertices as stored, and as a reader of the exported file sees them.
struct ObjectPositions {
  Positions doubles, floats;
  double float_slack = 0;  // metres
};
ObjectPositions positions_of(const Object& object, const Pose& pose);

/// Faces of `a` and `b` that intersect on the doubles and on the exported floats, and components of
/// one inside the other.
struct PairVerdict {
  std::int64_t crossings = 0, float_crossings = 0;
  int a_inside_b = 0, b_inside_a = 0;
  bool clear() const { return !crossings && !float_crossings && !a_inside_b && !b_inside_a; }
};
/// @param limit  counting stops there.
PairVerdict verify_pair(const Object& a, const Pose& pose_a, const ObjectPositions& at_a,
                        const Object& b, const Pose& pose_b, const ObjectPositions& at_b,
                        std::int64_t limit);

/// Why `id` may not be at `pose`, among the other placed objects and over the floor: names them.
/// Empty: it may. @param floats  the exported floats, too.
std::string why_invalid(const Scene& scene, ObjectId id, const Pose& pose, bool floats);

}  // namespace trivet
