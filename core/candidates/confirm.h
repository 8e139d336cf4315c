// Embree on the way from proposed pairs of faces to the first contact: its collision of two scenes
// visits them, and its callback decides.
#pragma once

#include "core/candidates/zlist_stage.h"

namespace trivet {

/// Pairs that are decided before Embree is asked about the others: they lower the horizon.
inline constexpr std::size_t kPairsBeforeEmbree = 64;

/// Embree visits the faces of the pairs: those whose boxes overlap, the moving face's swept up to
/// the horizon, the fixed one's grown by the largest stop. Its callback (of rtcCollide) decides
/// each such pair, as far as it was proposed, by the closed form, and keeps what is earlier than
/// `best`.
/// @param horizon  the earliest time known by which something stops, or the limit.
/// @param pairs    then those that were visited, in their order: no pair is removed that stops at
/// or
///   before the horizon.
/// @return whether Embree was asked: not if it would report many times more pairs than are
/// proposed; then nothing has changed. Cost about a microsecond a face. Re-entrant.
bool decide_by_embree(const FirstContactQuery& query, double horizon, std::vector<FacePair>& pairs,
                      FirstContact& best);

}  // namespace trivet
