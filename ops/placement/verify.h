// Exact test that every pose passes before it is committed.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/exact/interpenetration.h"
#include "ops/base/refusal.h"
#include "ops/placement/neighbourhood.h"

namespace trivet {

/// An object somewhere: its vertices as stored, and as a reader of the exported file sees them.
struct ObjectInWorld {
  const Object* object = nullptr;
  Aabb box;  // holds both
  PlacedShape doubles;
  PlacedShape floats;  // relative to the origin
  Vec3 origin;         // of the export
};
/// @param origin  export_origin() of the scene.
/// @throws Error (BadInput) when the pose is beyond the range of float32.
ObjectInWorld in_world(const Object& object, const Pose& pose, const Vec3& origin);

/// Vertices below the floor z = 0.
std::int64_t num_below_floor(const ObjectInWorld& here);
std::int64_t num_floats_below_floor(const ObjectInWorld& here);

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

/// One object that interpenetrates another or the floor.
struct Interpenetration {
  ObjectId id;
  Support with;
  Refusal refusal;  // of a pose that does
};
/// Other placed objects, and the floor, that each of these would interpenetrate, in doubles or, if
/// asked for, in the exported floats; by `moved`, the floor first, then in the scene's order.
/// @param limit  no more than this many are looked for.
std::vector<Interpenetration> interpenetrations(const Scene& scene,
                                                std::span<const Placement> moved, bool floats,
                                                size_t limit);

/// Objects, and the floor, that an object passes through in its pose in the scene; they do not hold
/// it. Only pairs with one of ObjectState::Invalid are tested: no other pair interpenetrates.
std::vector<Support> passed_through(const Scene& scene, ObjectId id);

inline bool is_invalid(const Scene& scene, ObjectId id) {
  return scene.at(id).state == ObjectState::Invalid;
}

/// Refuses poses that interpenetrate others, of objects that keep their places among each other.
/// Among each other only the exported floats are tested; so are all objects where the move gives
/// the export another origin.
/// @param floats  the exported floats, too.
std::optional<Refusal> refuse_interpenetration(const Scene& scene, std::span<const Placement> moved,
                                               bool floats);
std::optional<Refusal> refuse_interpenetration(const Scene& scene, ObjectId id, const Pose& pose,
                                               bool floats);

}  // namespace trivet
