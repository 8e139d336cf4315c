// The exact test that every pose passes before it is committed.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/exact/interpenetration.h"
#include "core/scene/scene.h"

namespace trivet {

/// kRelativeClearance of the scene's size or its largest coordinate, with `extra` (the object to
/// be placed) in it.
double default_clearance(const Scene& scene, const Aabb& extra = {});

/// The box an object at `start` will probably come to lie in: its footprint, no higher above what
/// is there than it is high. (Its start may be far above the scene.)
Aabb expected_box(const Scene& scene, const Object& object, const Pose& start);

/// An object, and where it shall be.
struct Placement {
  ObjectId id;
  Pose pose;
};

/// An object, and what it shall fill.
struct PlacedBox {
  ObjectId id;
  Aabb box;
};

/// Why the placed objects cannot be told apart with these there: the default clearance would be
/// larger than 1/64 of the smallest object's diagonal, because something is far out
/// or very large. Names both objects, the coordinate, and what is accepted. Empty: they can.
/// @param clearance  one that was asked for and is small enough is as good; 0: none was.
std::string why_too_coarse(const Scene& scene, std::span<const PlacedBox> moved, double clearance);
std::string why_too_coarse(const Scene& scene, std::span<const Placement> moved, double clearance);

/// An object somewhere: its vertices as stored, and as a reader of the exported file sees them.
struct ObjectInWorld {
  const Object* object = nullptr;
  Aabb box;  // holds both
  PlacedShape doubles, floats;
};
/// @throws Error (BadInput) when the pose is beyond the range of float32.
ObjectInWorld in_world(const Object& object, const Pose& pose);

/// Vertices below the floor z = 0.
std::int64_t num_below_floor(const PlacedShape& placed);

/// Faces of `a` and `b` that intersect on the doubles and on the exported floats, and components of
/// one inside the other.
struct PairVerdict {
  std::int64_t crossings = 0, float_crossings = 0;
  int a_inside_b = 0, b_inside_a = 0;
  bool clear() const { return !crossings && !float_crossings && !a_inside_b && !b_inside_a; }
};
/// @param floats  the exported floats, too. @param limit  counting stops there.
PairVerdict verify_pair(const ObjectInWorld& a, const ObjectInWorld& b, bool floats,
                        std::int64_t limit);

/// The other placed objects that each of these would interpenetrate (and the floor, as no id), in
/// doubles or, if asked for, in the exported floats; sorted. Empty: none.
struct Interpenetration {
  ObjectId id;
  std::optional<ObjectId> with;
  std::string what;  // "\"a\" passes through \"b\""
};
/// @param limit  no more than this many are looked for.
std::vector<Interpenetration> interpenetrations(const Scene& scene,
                                                std::span<const Placement> moved, bool floats,
                                                size_t limit);

/// What interpenetrated something when it was rated. It may not any more when the other has moved.
std::vector<ObjectId> invalid_objects(const Scene& scene);

/// What an object passes through where the scene has it, if anything is ObjectState::Invalid (else
/// nothing does); no id: the floor. None of that holds it.
std::vector<std::optional<ObjectId>> passed_through(const Scene& scene, ObjectId id);

/// Why these, which keep their places among each other, may not be there all together; empty: they
/// may. Among each other only the exported floats are tested.
std::string why_invalid(const Scene& scene, std::span<const Placement> moved, bool floats);

/// Why `id` may not be at `pose`, among the other placed objects and over the floor: names them.
/// Empty: it may. @param floats  the exported floats, too.
std::string why_invalid(const Scene& scene, ObjectId id, const Pose& pose, bool floats);

}  // namespace trivet
