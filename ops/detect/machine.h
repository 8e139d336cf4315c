// This machine's sources of candidates and what they cost: one object for the detectors of all
// threads.
#pragma once

#include <memory>
#include <mutex>

#include "core/base/sentence.h"
#include "ops/detect/calibration.h"

namespace trivet {

struct MachineOptions {
  std::string version;   // of Trivet: another one measures again
  std::string hardware;  // of graphics, such as from graphics_hardware(); empty: none
  int device = 0;        // of OpenGL that `gpu` uses; 0: the usual one
  std::vector<GpuSource> gpu;
  int num_threads = 0;  // of software z-lists; 0: all cores
  std::string file;     // where the calibration is kept; empty: nowhere
  /// Told, once, why the file is not used or cannot be written. May be empty.
  std::function<void(const Sentence&)> note;
};

/// Thread-safe.
class Machine {
 public:
  explicit Machine(MachineOptions options);
  /// With this calibration, for tests.
  Machine(MachineOptions options, Calibration calibration);

  /// True if `auto` has a choice. Without graphics hardware BVHs answer, nothing is measured, and
  /// no file is read.
  bool has_hardware() const { return !m_options.hardware.empty(); }
  MachineKey key() const;

  /// From the file if it is valid for this machine, else measured, which takes seconds and is
  /// written to the file. Other threads wait.
  std::shared_ptr<const Calibration> calibration();
  /// Measured again, and written, unless another thread has done so since `old`.
  std::shared_ptr<const Calibration> recalibrate(const std::shared_ptr<const Calibration>& old);

  /// The name of the source that `auto` takes once it is ready.
  std::string choice(const QuerySize& size);

  /// By its name in the calibration, with its self-test passed; null: BVHs.
  /// @throws Error (Environment) why it cannot be had.
  std::unique_ptr<CandidateFinder> make_stage(const std::string& name,
                                              const GpuNotes& notes = {}) const;

 private:
  std::shared_ptr<const Calibration> read() const;
  std::shared_ptr<const Calibration> measure() const;
  void tell(const Sentence& note) const;

  MachineOptions m_options;
  std::mutex m_mutex;
  std::shared_ptr<const Calibration> m_calibration;  // null: not known yet
};

}  // namespace trivet
