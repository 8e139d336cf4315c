// Interfering faces, for display: those that cross, and those that stop a motion [Shinya 1995, 6].
#pragma once

#include <span>
#include <vector>

#include "ops/placement/verify.h"

namespace trivet {

/// Faces of the model of one object; sorted, each once.
struct FacesOfObject {
  ObjectId id;
  std::vector<Index> faces;
};

struct InterferingFaces {
  std::vector<FacesOfObject> objects;  // sorted by slot, none without faces
  bool complete = true;                // false: `limit` was reached, there may be more
  bool empty() const { return objects.empty(); }
};

/// Pairs of faces that are looked at, by default: 5 to 20 ms where that many are near each other,
/// as when two fine meshes lie in each other; which of them may depend on the shape of the trees.
inline constexpr int kMostFacePairs = 1 << 16;

/// Finds, for objects that are where `moved` says, the faces that have a point in common with those
/// of another placed object, by the exact test of check_scene(), and those that reach below the
/// floor. On the doubles; of what crosses nothing on these, on the exported floats. What moves is
/// not tested among itself. An object that is wholly inside another has none.
InterferingFaces crossing_faces(const Scene& scene, std::span<const Placement> moved,
                                int limit = kMostFacePairs);

/// Obstacle of a motion, and where; as in OperationResult.
struct Blockage {
  Support by;
  Vec3 at = Vec3::Zero();
};

/// Finds, for objects that were stopped where `moved` says, the faces that are within `tolerance`
/// of faces of what stopped them, in about the same direction as those that are nearest to where it
/// did, and look there; so what an object lies on is not shown beside what it runs into.
/// @param tolerance  metres: kContactTolerance clearances, as for contacts.
InterferingFaces blocking_faces(const Scene& scene, std::span<const Placement> moved,
                                const Blockage& blockage, double tolerance,
                                int limit = kMostFacePairs);

}  // namespace trivet
