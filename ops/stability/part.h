// Parts of the scene that contacts connect, judged alone: what an operation may have unbalanced.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "ops/stability/free_bodies.h"

namespace trivet {

/// Placed objects that may move by themselves (neither fixed nor held by a hand), among `seeds` or
/// connected with them by contacts; contacts through fixed or held objects do not connect. Sorted
/// by name. Cost O(found log found).
std::vector<ObjectId> connected_with(const Scene& scene, std::span<const ObjectId> seeds);

/// near_bodies() of these and of all that such contacts connect with them, sorted by name: what is
/// held across a gap wider than a link's is of the same part.
FreeBodies near_part(const Scene& scene, std::vector<ObjectId> ids, double clearance,
                     const IsGround& is_ground, const ContactFriction& friction,
                     double num_clearances = kCarryingTolerance);

struct PartVerdict {
  bool stands = true;
  bool known = true;              // false: a part is too large for a proof, or not solved
  std::vector<ObjectId> topples;  // sorted by name
};

/// Names of what topples: all; or, where a few bodies near the change prove that a part of many
/// does not stand, those of them that do, which is known soon.
enum class Toppling { All, SomeWillDo };

/// Verdict whether connected parts stand: by the vertical certificate; then by contact forces of
/// what it leaves open, loaded by the rest as certified; then of the whole part. Of a part with
/// more than `max_program_objects` open bodies those nearest to what has changed are judged, and
/// all others stand still: it is unknown then, unless these do not stand.
/// @param ids  as connected_with() returns them. @param changed  any of them.
PartVerdict judge_parts(const Scene& scene, std::span<const ObjectId> ids,
                        std::span<const ObjectId> changed, double clearance,
                        int max_program_objects, const ContactFriction& friction = {},
                        Toppling toppling = Toppling::All);

}  // namespace trivet
