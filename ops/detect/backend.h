// Choice of the source of candidates, and of its replacement if it fails.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "core/base/sentence.h"
#include "core/candidates/self_test.h"
#include "ops/detect/detector.h"
#include "ops/detect/machine.h"

namespace trivet {

/// Answers are the same bits with all of them; they differ in time (perf/README.md).
enum class Backend {
  Auto,      // for each query the fastest on this machine, as measured; see Machine
  Gpu,       // z-lists on the graphics hardware
  Software,  // z-lists in memory
  Bvh,       // BVHs alone
};

/// From "auto", "bvh", "software"; "gpu", "framebuffer", "compute" are Gpu, by the faster method or
/// by this one. @throws Error (BadInput) for anything else.
Backend backend_from_name(const std::string& name);

/// From "embree" (about all pairs that a stage proposes, but the first), "off", or "auto" (about
/// many). Answers are the same bits. @throws Error (BadInput) for anything else.
Confirmation confirmation_from_name(const std::string& name);
/// And back.
std::string to_string(const Confirmation& confirmation);

struct BackendOptions {
  Backend backend = Backend::Auto;
  int num_threads = 0;  // of software z-lists; 0: all cores
  Confirmation confirmation;
  /// For Backend::Auto, one object for all threads. Null, or without hardware: BVHs.
  std::shared_ptr<Machine> machine;
  /// Makes the stage for Backend::Gpu, such as make_gpu_candidate_finder(); empty: a build without.
  std::function<std::unique_ptr<CandidateFinder>(const GpuNotes& notes)> make_gpu_stage;
  /// Makes what computes brackets of falls for Backend::Gpu and, where there is graphics hardware,
  /// for Backend::Auto, such as a GpuDropBrackets; empty: software. Not on a renderer that runs on
  /// the CPU if `allow_software` is false, as with Backend::Auto: then it throws Error.
  std::function<DropBracketFunction(bool allow_software)> make_gpu_brackets;
  /// Told, once, why another source answers than was asked for. May be empty.
  std::function<void(const Sentence&)> note;
  /// Told when a GPU is lost, of queries or of places. Without, once_each(note). Detectors of
  /// several threads that have the same one tell a loss once together.
  std::optional<GpuNotes> gpu_notes;
};

/// A GPU that cannot be had (the factory throws), or that fails self_test(), is replaced by BVHs.
std::unique_ptr<Detector> make_detector(const BackendOptions& options);

/// Z-lists on the GPU for Backend::Gpu; where it cannot be had, and else, in software.
std::unique_ptr<CandidateFinder> make_zlist_stage(const BackendOptions& options);

/// Parts of a detector for Backend::Gpu. Null for others, and, told once, where it cannot be had.
std::unique_ptr<CandidateFinder> make_gpu_stage_of(const BackendOptions& options);
std::unique_ptr<BracketSource> make_gpu_brackets_of(const BackendOptions& options);

}  // namespace trivet
