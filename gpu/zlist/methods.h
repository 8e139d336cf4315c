// Private to gpu: the faster of the two methods.
#pragma once

#include "gpu/zlist/stage.h"

namespace trivet {

/// For GpuMethod::Auto. Measures both when this process has not measured the renderer yet.
std::unique_ptr<CandidateFinder> make_faster_candidate_finder(GpuZListOptions options);

}  // namespace trivet
