// GPU stages of this build; none without EGL.
#pragma once

#include <vector>

#include "ops/detect/calibration.h"

namespace trivet::perf {

/// Framebuffers and compute shaders.
std::vector<GpuSource> gpu_stages();

}  // namespace trivet::perf
