// Detectors that scenes of one choice share.
#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "apps/detection/detection.h"
#include "ops/detect/detector_pool.h"

namespace trivet::python {

/// A detector for each thread that computes at the same time; a forked child has its own.
class ChosenDetectors {
 public:
  explicit ChosenDetectors(DetectionChoice choice);

  const DetectionChoice& choice() const { return m_choice; }
  DetectorPool& pool() { return m_pool; }
  /// Takes the notes of the detectors since the last call; from any thread.
  std::vector<std::string> take_notes();

 private:
  DetectionChoice m_choice;
  std::mutex m_mutex;  // guards the one below
  std::vector<std::string> m_notes;
  DetectorPool m_pool;
};

/// The one of this choice, kept until the process ends. With the GIL.
/// @param device  "auto", or the number of an EGL device.
/// @throws Error (BadInput) for a name or device that is not accepted.
std::shared_ptr<ChosenDetectors> detectors_of(const std::string& detector,
                                              const std::string& device);

}  // namespace trivet::python
