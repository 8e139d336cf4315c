// z-lists along the motion, on the GPU. README.md proves that no pair is missed.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>

#include "core/candidates/doubtful_lists.h"
#include "core/candidates/gpu_notes.h"
#include "gpu/egl/gpu_faults.h"
#include "gpu/zlist/list_costs.h"

namespace trivet {

/// Ways in which the hardware finds the depths of pixels. Both give the same answers.
enum class GpuMethod {
  Auto,         // the faster one, measured once per process and renderer; on renderers that run on
                // the CPU Compute, unless measure_gpu_methods() was asked
  Framebuffer,  // it rasterises; OpenGL 3.3
  Compute,      // it computes; OpenGL 4.3
};
/// From "auto", "framebuffer" or "compute". @throws Error (BadInput) for anything else.
GpuMethod gpu_method_from_name(const std::string& name);

/// Method that lists the faces of doubtful pixels. Software needs GpuZListOptions::software_lists.
enum class GpuListing {
  Auto,      // per query, by the number of doubtful pixels, what costs less; the other one where it
             // gives up; without software_lists Gpu
  Gpu,       // it draws again
  Software,  // as in the paper; where it gives up (too many pieces of faces about an axis), the GPU
};

/// From "auto", "gpu" or "software". @throws Error (BadInput) for anything else.
GpuListing gpu_listing_from_name(const std::string& name);
/// And back.
std::string to_string(GpuListing listing);

struct GpuZListOptions {
  int resolution = 0;                     // pixels along the longer side, 16 to 1024; 0: 128,
                                          // or less on renderers that run on the CPU
  std::size_t memory_bytes = 512u << 20;  // of graphics memory, meshes included
  int max_list_entries = 1 << 20;         // faces in doubtful pixels, 16384 to 1048576
  bool allow_software = true;             // false: refuse renderers that run on the CPU
  int device = 0;                         // EGL device; 0: as EglOptions has it
  GpuMethod method = GpuMethod::Auto;
  int most_gl_version = 46;   // 33 to 46: uses no later OpenGL, for tests of older ones
  bool bounds_alone = false;  // for measurements: no lists, so no usable candidates, but
                              // `lower`, `upper` and the work up to there are valid
  /// Makes a new context at once when the hardware is lost, within the query, which takes up to a
  /// second; false: that query and all later ones are given up, for users who make another finder.
  bool recreates_context = true;
  GpuListing listing = GpuListing::Auto;
  std::shared_ptr<DoubtfulLists> software_lists =
      {};  // such as SoftwareDoubtfulLists; null: the GPU's
  /// For GpuListing::Auto. Without: on graphics hardware measured, once per process, renderer and
  /// kind of motion, when first needed; on renderers that run on the CPU those of llvmpipe.
  std::optional<ListCosts> list_costs = {};
  /// Told once when the hardware was lost and a new context goes on, once when there is none and
  /// BVHs answer.
  GpuNotes notes = {};
  GpuFaults faults = {};
};

/// Candidate finder with its own context, made current only while it works. Meshes stay in graphics
/// memory, up to the limit, by the identity assigned by make_shape(). A lost context is recreated;
/// after three consecutive OpenGL errors no query is usable. find_candidates_for_all() draws as
/// many queries together as memory allows, as layers of one image: 64 of 128 pixels. One thread at
/// a time. Drivers have bugs: run self_test() of core/candidates/self_test.h before relying on
/// it, as make_detector() of ops does.
/// @throws Error (Environment) naming what is missing: EGL, OpenGL 3.3 (4.3 for compute shaders),
///   or memory; (BadInput) for an option out of range.
std::unique_ptr<CandidateFinder> make_gpu_candidate_finder(const GpuZListOptions& options = {});

/// Milliseconds of a query, the mean of a fall and a turn; infinity: cannot be had.
struct GpuMethodTimes {
  double framebuffer_ms, compute_ms;
  GpuMethod faster() const {
    return compute_ms < framebuffer_ms ? GpuMethod::Compute : GpuMethod::Framebuffer;
  }
};

/// Measures both methods on the renderer that the options choose, on bumpy spheres of 15,000 faces
/// (1,000 if it runs on the CPU). What GpuMethod::Auto goes by, once per process and renderer.
/// @throws Error as make_gpu_candidate_finder().
GpuMethodTimes measure_gpu_methods(const GpuZListOptions& options = {});

}  // namespace trivet
