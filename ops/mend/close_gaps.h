// Objects that hardly miss each other brought into contact, all at once. Private.
#pragma once

#include <functional>
#include <vector>

#include "ops/mend/known_contacts.h"
#include "ops/placement/neighbourhood.h"

namespace trivet {

struct GapsToClose {
  double clearance = 0;          // metres
  double reach = 0;              // metres: wider gaps stay
  double most_step = kInfinity;  // metres: turns of longer ones are not linear
  bool near_given = true;        // the first steps aim at the given poses, else at where all are
  std::function<bool()> is_over = {};  // asked before each step: it ends there
  KnownContacts* known = nullptr;      // if not null: of the same reach and clearance; it goes on
  double first_share = 1;  // of the reach, at first: less where a single object is near its rest
};

struct ClosedGaps {
  std::vector<ObjectId> not_held;  // nothing within reach holds it, or only across an open gap
  std::vector<SmallMotion> falls;  // of each of these; the fastest point of all goes a metre
  std::vector<ObjectId> missed;    // nothing held it at a step that aimed at the given poses
  double longest_step = 0;         // metres, of those asked for: a higher bound changes nothing
};

/// Moves these objects, placed and free of each other, so that contacts can hold them all, as they
/// lie: a pile whose members hold each other up. The result is nearly the nearest such one.
///
///   contacts  all within the reach, and which are to carry (choose_contacts.h)
///   motions   to the poses nearest to the given ones at which these are closed and no other one is
///             passed through; what would meet elsewhere is another condition
///   again     as features change on the way, until gaps are contacts
///
/// @param given  the objects, and the poses that they are to stay near.
ClosedGaps close_gaps(Scene& scene, const std::vector<Placement>& given, const GapsToClose& gaps);

}  // namespace trivet
