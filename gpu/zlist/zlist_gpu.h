// z-lists along the motion, on the GPU. README.md proves that no pair is missed.
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
  bool force_fallback = false;            // do without OpenGL 4.3, for tests of the fallback
  bool bounds_alone = false;  // for measurements: no lists, so no usable candidates, but
                              // `lower`, `upper` and the work up to there are valid
};

/// Candidate finder with its own context, made current only while it works. Meshes stay in graphics
/// memory, up to the limit, by the identity assigned by make_shape(). A lost context is recreated;
/// after three consecutive OpenGL errors no query is usable. With OpenGL 4.3,
/// find_candidates_for_all() draws as many queries together as memory allows, as layers of one
/// image: 64 of 128 pixels. One thread at a time. Drivers have bugs: run self_test() of
/// core/contact/zlist_self_test.h before relying on it, as make_detector() of ops does.
/// @throws Error (Environment) naming what is missing: EGL, OpenGL 3.3, or memory; (BadInput) for
///   an option out of range.
std::unique_ptr<CandidateFinder> make_gpu_candidate_finder(const GpuZListOptions& options = {});

}  // namespace trivet
