// Does a z-list stage, and the driver below it, do what it says?
#pragma once

#include "core/candidates/zlist_stage.h"

namespace trivet {

/// Asks a stage some small queries, half of them turns, and compares with the BVHs. A wrong
/// stage would lose contacts unseen, and drivers do have bugs.
/// @return what is wrong, with the number of the query; empty if nothing is.
std::string self_test(CandidateFinder& stage);

}  // namespace trivet
