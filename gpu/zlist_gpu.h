// z-lists along the motion, on the graphics hardware. README.md derives why no pair is missed.
#pragma once

#include <cstddef>
#include <memory>

#include "core/contact/zlist_stage.h"

namespace trivet {

struct GpuZListOptions {
  int resolution = 0;                     // pixels along the longer side, 16 to 1024; 0: 128,
                                          // or less on renderers that run on the CPU
  std::size_t memory_bytes = 512u << 20;  // of graphics memory, meshes included
  int max_list_entries = 1 << 20;         // faces in doubtful pixels, 16384 to 1048576
  bool allow_software = true;             // false: refuse renderers that run on the CPU
  bool force_fallback = false;            // do without OpenGL 4.3, as on old drivers
  bool bounds_alone = false;              // to measure: no lists, so no proposal is usable, but
                                          // `lower`, `upper` and the work up to there are true
};

/// A stage with a context of its own, made current only while it works. Meshes stay in graphics
/// memory, up to the limit, by the identity that make_shape() gave them. A context that is lost is
/// made again; after three errors of OpenGL in a row no query is usable. With OpenGL 4.3,
/// propose_many() draws as many queries together as there is room for, as layers of one image: 64
/// of 128 pixels. One thread at a time.
/// Drivers do have bugs: ask self_test() of core/contact/zlist_self_test.h before trusting it, as
/// make_detector() of ops does.
/// @throws Error (Environment) that says what is missing: EGL, OpenGL 3.3, or how much memory;
///   (BadInput) for an option out of range.
std::unique_ptr<ZListStage> make_gpu_zlist_stage(const GpuZListOptions& options = {});

}  // namespace trivet
