// Costs of each source of candidates on this machine, measured with a fixed set of queries.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/candidates/gpu_notes.h"
#include "core/candidates/zlist_stage.h"
#include "ops/detect/cost_model.h"

namespace trivet {

/// A way of finding candidates on a GPU. ops knows of no GPU: programs pass these in.
struct GpuSource {
  std::string name;  // "gpu framebuffer", "gpu compute"
  /// @throws Error (Environment) if it cannot be had, or only on a renderer that runs on the CPU
  ///   and `allow_software` is false.
  std::function<std::unique_ptr<CandidateFinder>(bool allow_software, const GpuNotes& notes)> make;
};

/// Machine and build for which a calibration is valid.
struct MachineKey {
  std::string version;   // of Trivet
  std::string build;     // ways of a GPU that the build has; empty: without OpenGL
  std::string cpu;       // model and number of cores
  std::string hardware;  // of graphics, with the version of its driver; empty: none
  int device = 0;        // of OpenGL that was asked for; 0: the usual one

  friend bool operator==(const MachineKey&, const MachineKey&) = default;
};

/// A source of candidates as measured.
struct SourceCost {
  std::string name;     // "bvh", "software", or that of a GpuSource
  std::string device;   // "cpu", or the renderer of OpenGL
  bool on_cpu = true;   // a GPU's: false on hardware
  std::string failure;  // why it cannot be used; empty: it can
  double start_ms = 0;  // to make it, with its self-test
  CostModel drop, turn;

  /// Infinity if it cannot be used, and for a GPU's that is not on hardware.
  double ms(const QuerySize& size) const;
  /// False for z-lists in software, which are measured for comparison: BVHs beat them in every
  /// query, and a mesh that is too new to have a BVH needs one for the proofs that follow.
  bool is_for_auto() const;
};

struct Calibration {
  MachineKey key;
  double seconds = 0;  // that it took
  std::vector<SourceCost> sources;

  static constexpr const char* kBvh = "bvh";
  static constexpr const char* kSoftware = "software";

  /// The cheapest source for a query that `auto` may take; null if none can be used.
  const SourceCost* fastest(const QuerySize& size) const;
};

/// Processor and number of cores.
std::string processor_name();

/// Measures BVHs, z-lists in software and each GPU source on hardware. Where a source only runs on
/// the CPU it is tested, not measured: `auto` never takes it. Takes about a second, and half a
/// second for each GPU source.
Calibration calibrate(const MachineKey& key, const std::vector<GpuSource>& gpu);

}  // namespace trivet
