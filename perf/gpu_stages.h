// GPU stages of this build; none without EGL.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "ops/detect/calibration.h"

namespace trivet::perf {

/// Framebuffers and compute shaders.
std::vector<GpuSource> gpu_stages();

/// A finder of candidates, and the same that stops after the depths of pixels.
struct StagedFinder {
  std::string name;
  std::unique_ptr<CandidateFinder> whole, depths;
};

/// Both methods, with lists by the GPU and in software. @throws Error (Environment) where no OpenGL
/// is to be had.
std::vector<StagedFinder> staged_gpu_finders();

}  // namespace trivet::perf
