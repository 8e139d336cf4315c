// Embree confirms: which proposed pairs of faces can meet in time, by boxes along the motion.
#pragma once

#include "core/candidates/zlist_stage.h"

namespace trivet {

/// Pairs that are decided before Embree is asked about the others: they lower the horizon.
inline constexpr std::size_t kPairsBeforeEmbree = 64;

/// Removes the pairs whose boxes, the moving face's swept up to the horizon, the fixed one's grown
/// by the largest stop, do not overlap: what Embree reports (rtcCollide over the distinct faces),
/// as far as it was proposed. The order of the others stays. No pair is removed that stops at or
/// before the horizon.
/// @param horizon  the earliest time known by which something stops, or the limit.
/// @return whether Embree was asked: not if it would report many times more pairs than are
/// proposed. Cost about a microsecond a face. Re-entrant.
bool confirm_pairs(const FirstContactQuery& query, double horizon, std::vector<FacePair>& pairs);

}  // namespace trivet
