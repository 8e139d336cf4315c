// Private to gpu: pairs of faces from the lists of doubtful pixels.
#pragma once

#include "core/candidates/zlist_frame.h"
#include "gpu/zlist/lists.h"

namespace trivet {

/// Candidate pairs of a moving and a fixed face that may meet by lists.upper in one pixel, each
/// once, with the smallest of their bounds as a time, sorted as in CandidatePairs.
/// @param lists  with sorted entries.
/// @return false if there are too many pairs: flat contacts in coarse pixels.
bool make_pairs(const ZListView& view, ZLists& lists, const ZListFrame& frame,
                std::vector<FacePair>& pairs);

}  // namespace trivet
