// Detectors of threads that come and go.
#pragma once

#include <sys/types.h>

#include <functional>
#include <memory>
#include <mutex>
#include <vector>

#include "ops/detect/detector.h"

namespace trivet {

/// A detector for each thread that computes at the same time, made when first needed and kept.
/// Safe to use from many threads. A forked child makes its own, and leaves those of its parent.
class DetectorPool {
 public:
  using Make = std::function<std::unique_ptr<Detector>()>;

  /// @param make  safe to call from many threads; empty: BVHs.
  explicit DetectorPool(Make make);
  ~DetectorPool();
  DetectorPool(const DetectorPool&) = delete;
  DetectorPool& operator=(const DetectorPool&) = delete;

  /// A detector for one thread, given back at the end of a scope.
  class Loan {
   public:
    /// @throws what Make throws.
    explicit Loan(DetectorPool& from);
    ~Loan();
    Loan(const Loan&) = delete;
    Loan& operator=(const Loan&) = delete;
    Detector* get() const { return m_detector.get(); }  // null: BVHs

   private:
    DetectorPool& m_from;
    std::unique_ptr<Detector> m_detector;
    pid_t m_process;
  };

 private:
  std::unique_ptr<Detector> take();
  void give_back(std::unique_ptr<Detector> detector);
  void leave_those_of_parent();

  Make m_make;
  std::mutex m_mutex;
  pid_t m_process;  // that made those below
  std::vector<std::unique_ptr<Detector>> m_free;
};

}  // namespace trivet
