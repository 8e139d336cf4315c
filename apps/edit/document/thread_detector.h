// The detector of one asking thread: made there, replaced there, with a GPU that may fail. Private.
#pragma once

#include <future>
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
  /// Makes the detector if another one was chosen; nothing may refer to the old one. If the GPU has
  /// failed since, begins to make another on a thread of its own, which a later renew() takes; BVHs
  /// answer meanwhile. BackendOptions::note gets the reason if it is not the one that was asked
  /// for.
  void renew();
  /// Null before the first renew(): BVHs.
  Detector* get() const { return m_made.detector.get(); }
  Answering answering() const;
  /// The GPU's stage that answers; null: none does. Valid until renew().
  CandidateFinder* gpu_stage() const;

 private:
  struct Made {
    std::shared_ptr<GuardedStage> gpu;   // null: no GPU
    std::unique_ptr<Detector> detector;  // refers to it
  };
  static Made make(BackendOptions options);
  bool take_choice(BackendOptions& options);
  void make_again(BackendOptions options);

  std::mutex m_mutex;  // guards the two below
  BackendOptions m_options;
  int m_num_choices = 1;

  int m_num_made = 0;    // the choice that the detector was made for
  int m_num_losses = 0;  // of its GPU
  Made m_made;
  std::future<Made> m_next;  // valid: it is made
};

}  // namespace trivet::edit
