// Detectors of a server's threads.
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <vector>

#include "ops/detect/detector.h"

namespace trivet::serve {

/// A detector for each thread that computes at the same time, made when first needed and kept.
/// Safe to use from many threads.
class Detectors {
 public:
  using Make = std::function<std::unique_ptr<Detector>()>;

  /// @param make  safe to call from many threads; empty: BVHs.
  explicit Detectors(Make make) : m_make(std::move(make)) {}

  /// A detector for one thread, given back at the end of a scope.
  class Loan {
   public:
    /// @throws what Make throws.
    explicit Loan(Detectors& from) : m_from(from), m_detector(from.take()) {}
    ~Loan() { m_from.give_back(std::move(m_detector)); }
    Loan(const Loan&) = delete;
    Loan& operator=(const Loan&) = delete;
    Detector* get() const { return m_detector.get(); }  // null: BVHs

   private:
    Detectors& m_from;
    std::unique_ptr<Detector> m_detector;
  };

 private:
  std::unique_ptr<Detector> take();
  void give_back(std::unique_ptr<Detector> detector);

  Make m_make;
  std::mutex m_mutex;
  std::vector<std::unique_ptr<Detector>> m_free;
};

}  // namespace trivet::serve
