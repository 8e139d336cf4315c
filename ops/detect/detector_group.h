// Detectors of threads that work side by side: on a GPU their queries share draws.
#pragma once

#include <memory>
#include <mutex>

#include "ops/detect/backend.h"
#include "ops/detect/detector_pool.h"
#include "ops/detect/gathered_stage.h"

namespace trivet {

/// With Backend::Gpu one stage, and one source of brackets, for all; else a detector each, kept for
/// the next. Safe to use from many threads.
class DetectorGroup {
 public:
  /// Makes the GPU's stage; as make_detector() where it cannot be had.
  explicit DetectorGroup(const BackendOptions& options);

  /// For one thread and one piece of work: the others' queries wait for those of this one.
  class Part {
   public:
    explicit Part(DetectorGroup& group);
    Detector* get() const { return m_own ? m_own.get() : m_loan->get(); }  // null: BVHs

   private:
    std::unique_ptr<Detector> m_own;
    std::unique_ptr<DetectorPool::Loan> m_loan;
  };

  bool gathers() const { return m_stage != nullptr; }

 private:
  class SharedBrackets;

  std::unique_ptr<GatheredStage> m_stage;  // null: the pool's
  Confirmation m_confirmation;
  std::mutex m_mutex;  // guards the one below
  std::shared_ptr<BracketSource> m_brackets;
  std::unique_ptr<DetectorPool> m_pool;
};

}  // namespace trivet
