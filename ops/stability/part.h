// Parts of the scene that contacts connect, judged alone: what an operation may have unbalanced.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "ops/stability/free_bodies.h"

namespace trivet {

/// Placed objects that may move by themselves (neither fixed nor held by a hand), among `seeds` or
/// connected with them by contacts; contacts through fixed or held objects do not connect. Sorted
/// by slot. Cost O(found).
std::vector<ObjectId> connected_with(const Scene& scene, std::span<const ObjectId> seeds);

/// These objects with all contacts within kBalanceTolerance clearances, found anew, at most 12 for
/// a pair; fixed and held objects and the floor are ground. Contacts with any other object are left
/// out.
/// @param friction  of all contacts; none: of each pair.
FreeBodies near_bodies(const Scene& scene, std::span<const ObjectId> ids, double clearance,
                       std::optional<double> friction);

/// What may be missing to the balance of these bodies together: that of one of them, see
/// residual_tolerance(). (stability() allows the sum.)
double balance_tolerance(const FreeBodies& part, double clearance);

struct PartVerdict {
  bool stands = true;
  bool known = true;              // false: a part is too large for a proof, or not solved
  std::vector<ObjectId> topples;  // sorted by slot
};

/// Verdict whether connected parts stand: by the vertical certificate, else by contact forces.
/// @param ids  as connected_with() returns them.
PartVerdict judge_parts(const Scene& scene, std::span<const ObjectId> ids, double clearance,
                        int max_program_objects);

}  // namespace trivet
