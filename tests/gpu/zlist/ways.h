// The ways of the GPU stage: method, version of OpenGL, and who makes the lists.
#pragma once

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "gpu/zlist/stage.h"
#include "raster/zlist/software_zlists.h"

namespace trivet::test {

struct Way {
  GpuMethod method;
  int gl_version;
  bool software_lists = false;

  bool computes_lists() const { return gl_version >= 43 && !software_lists; }
  GpuZListOptions options(GpuZListOptions out = {}) const {
    out.method = method;
    out.most_gl_version = gl_version;
    if (!software_lists) return out;
    out.listing = GpuListing::Software;
    out.software_lists = std::make_shared<SoftwareDoubtfulLists>();
    return out;
  }
  std::string name() const {
    return std::string(method == GpuMethod::Compute ? "Compute" : "Framebuffer") +
           std::to_string(gl_version) + (software_lists ? "SoftwareLists" : "");
  }
};

inline void PrintTo(const Way& way, std::ostream* out) { *out << way.name(); }

inline const Way kComputeWay{GpuMethod::Compute, 45};
inline const Way kFramebufferWay{GpuMethod::Framebuffer, 45};
inline const Way kOldestWay{GpuMethod::Framebuffer, 33};
inline const Way kHybridWay{GpuMethod::Framebuffer, 45, true};

/// Null if the machine has no EGL.
inline std::unique_ptr<CandidateFinder> make_stage(const GpuZListOptions& options) {
  try {
    return make_gpu_candidate_finder(options);
  } catch (const Error& error) {
    const std::string why = error.what();
    if (!why.starts_with("no EGL") && !why.starts_with("no OpenGL")) throw;
    return nullptr;
  }
}

}  // namespace trivet::test

#define TRIVET_SKIP_WITHOUT_EGL(stage) \
  if (!(stage)) GTEST_SKIP() << "this machine has no OpenGL through EGL"
