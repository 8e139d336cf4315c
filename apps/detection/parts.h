// Parts that a build with OpenGL has, and one without lacks. Private.
#pragma once

#include "apps/detection/detection.h"

namespace trivet::detection {

/// Methods on the GPU that `auto` may choose.
std::vector<GpuSource> gpu_sources(const DetectionChoice& choice);
/// Brackets of falls at many places. @throws Error (Environment) if unavailable.
DropBracketFunction make_gpu_brackets(const DetectionChoice& choice, bool allow_software);
/// @throws Error (BadInput) when the names of a choice's lists are not accepted.
void check_lists(const DetectionChoice& choice);
/// Number of EGL devices. @throws Error (Environment) without EGL.
int num_devices();

}  // namespace trivet::detection
