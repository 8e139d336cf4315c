// Time of a frame of the editor's live view.
#pragma once

#include "core/scene/scene.h"
#include "perf/report.h"

namespace trivet::perf {

/// Adds a row, and gives the median milliseconds of a frame of 1280 x 720 in which one object has
/// moved, as text; "-" in builds without EGL, and where there is no OpenGL.
std::string frame_text(const Scene& scene, Report& report);

}  // namespace trivet::perf
