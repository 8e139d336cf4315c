// The detector of one asking thread: made there, replaced there, with a GPU that may fail. Private.
#pragma once

#include <memory>
#include <mutex>
#include <string>

#include "ops/detect/backend.h"

namespace trivet::edit {

/// The detector that answers first-contact queries, for display; see Detector.
struct Answering {
  std::string name = "bvh", device = "cpu", method;
  bool operator==(const Answering&) const = default;
};

class GuardedStage;

/// All functions but choose() are for the asking thread.
class ThreadDetector {
 public:
  explicit ThreadDetector(BackendOptions options);
  ~ThreadDetector();

  /// Sets the options of the next renew(). From any thread.
  void choose(BackendOptions options);
  /// Makes the detector if another one was chosen, or the GPU has failed since; nothing may refer
  /// to the old one. BackendOptions::note gets the reason if it is not the one that was asked for.
  void renew();
  /// Null before the first renew(): BVHs.
  Detector* get() const { return m_detector.get(); }
  Answering answering() const;
  /// The GPU's stage that answers; null: none does. Valid until renew().
  CandidateFinder* gpu_stage() const;

 private:
  bool take_choice(BackendOptions& options);

  std::mutex m_mutex;  // guards the two below
  BackendOptions m_options;
  int m_num_choices = 1;

  int m_num_made = 0;                    // the choice that m_detector was made for
  std::shared_ptr<GuardedStage> m_gpu;   // null: no GPU
  std::unique_ptr<Detector> m_detector;  // refers to m_gpu
};

}  // namespace trivet::edit
