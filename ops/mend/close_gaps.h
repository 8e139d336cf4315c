// Objects that hardly miss each other brought into contact, all at once. Private.
#pragma once

#include <vector>

#include "core/scene/scene.h"

namespace trivet {

struct GapsToClose {
  double clearance = 0;  // metres
  double reach = 0;      // metres: wider gaps stay
};

/// Moves these objects, placed and free of each other, so that contacts can hold them all where
/// they are, as they lie: a pile whose members hold each other up.
///
///   forces   a linear program balances all bodies by the contacts within a reach, which grows
///            until it does; a force costs the gap that it acts across
///   gaps     those that carry a force are to close, and no other contact is to be passed through:
///            the least motion of all bodies that does so, by relaxation [Hildreth 1957]
///   again    as features change on the way, until gaps are contacts
///
/// @return those that nothing within reach balances.
std::vector<ObjectId> close_gaps(Scene& scene, const std::vector<ObjectId>& ids,
                                 const GapsToClose& gaps);

}  // namespace trivet
