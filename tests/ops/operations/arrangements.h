// Scenes for PUT on various supports, and invariants of every PUT.
#pragma once

#include <string>
#include <vector>

#include "ops/operations/perform.h"
#include "support/same_scene.h"
#include "support/settle_options.h"
#include "support/solids.h"

namespace trivet::test {

/// A scene with fixed supports, and one unplaced object above them.
struct Arrangement {
  std::string name;
  Scene scene;
  ObjectId object;
  Pose start;
};

/// All deterministic; `index` selects shape and orientation.
Arrangement on_floor(int index);  // box, tetrahedron, cylinder, plate, torus, ball, ...
Arrangement stick_on_saucer(int index);
Arrangement into_bowl(int index);
Arrangement torus_over_peg(int index);
Arrangement on_two_heights(int index);
Arrangement against_wall(int index);
Arrangement into_wedge(int index);  // a V of three angles
Arrangement hook_on_bar(int index);
Arrangement onto_ball(int index);
Arrangement onto_slope(int index);

using MakeArrangement = Arrangement (*)(int);

/// Adds a fixed object at its pose.
ObjectId add_fixed(Scene& scene, const std::string& name, const Triangles& triangles,
                   const Vec3& at = Vec3::Zero(), const Rotation& rotation = {});

/// One of the shapes of about the given size, by number.
Triangles some_shape(int index, double size);

/// Puts, and checks the invariants: energy decreases in every step (with finite friction: in all
/// together), no crossings in double and
/// float32, at rest, gaps within (0, 2] clearances, contacts and state consistent. When refused,
/// the scene must be unchanged.
OperationResult checked_put(Scene& scene, ObjectId object, const Pose& start,
                            const SettleOptions& options = perfect_friction());

/// Runs checked_put() twice from the same scene: equal poses to the last bit.
OperationResult put_twice(Arrangement& a, const SettleOptions& options = perfect_friction());

/// Turned about an axis of unit length. @param angle  radians
Rotation about(const Vec3& axis, double angle);

/// Adds an unplaced box. @param half  half its edges, metres
ObjectId add_box(Scene& scene, const std::string& name, const Vec3& half);

/// So many boxes, or objects of several shapes, put one after the other at about the same place.
Scene heap(int num, bool boxes);

/// A table with a box on it, and an object that is not placed.
struct Room {
  Scene scene;
  ObjectId table, box, object;

  Room();
  /// Expects a refusal with `words`, and no change.
  void expect_refused(ObjectId id, const Pose& start, const std::vector<std::string>& words,
                      const SettleOptions& options = {});
};

}  // namespace trivet::test
