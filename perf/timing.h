// Clocks and order statistics of the measurements.
#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <vector>

namespace trivet::perf {

/// Wall time and processor time of a measurement, the latter of the calling thread unless specified
/// otherwise. They differ while other processes or threads are running.
struct Took {
  double wall_ms = 0, cpu_ms = 0;
};

class Stopwatch {
 public:
  /// @param clock  CLOCK_PROCESS_CPUTIME_ID includes all threads, also a driver's.
  explicit Stopwatch(clockid_t clock = CLOCK_THREAD_CPUTIME_ID) : m_clock(clock) {}
  Took elapsed() const {
    const auto wall = std::chrono::steady_clock::now() - m_wall;
    return {std::chrono::duration<double, std::milli>(wall).count(), cpu_ms() - m_cpu};
  }

 private:
  double cpu_ms() const {
    timespec now{};
    clock_gettime(m_clock, &now);
    return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
  }

  clockid_t m_clock;
  std::chrono::steady_clock::time_point m_wall = std::chrono::steady_clock::now();
  double m_cpu = cpu_ms();
};

/// The q-quantile (0 to 1) of values in any order, by rank; 0 if empty.
inline double quantile(std::vector<double> values, double q) {
  if (values.empty()) return 0;
  const auto rank = std::lround(q * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + rank, values.end());
  return values[static_cast<size_t>(rank)];
}

inline double median(const std::vector<double>& values) { return quantile(values, 0.5); }

/// Measurements of one kind.
class Samples {
 public:
  void add(const Took& took) {
    m_wall_ms.push_back(took.wall_ms);
    m_cpu_ms.push_back(took.cpu_ms);
  }
  void append(const Samples& more) {
    m_wall_ms.insert(m_wall_ms.end(), more.m_wall_ms.begin(), more.m_wall_ms.end());
    m_cpu_ms.insert(m_cpu_ms.end(), more.m_cpu_ms.begin(), more.m_cpu_ms.end());
  }
  size_t count() const { return m_wall_ms.size(); }
  double median_ms() const { return median(m_wall_ms); }
  double p95_ms() const { return quantile(m_wall_ms, 0.95); }
  double median_cpu_ms() const { return median(m_cpu_ms); }

 private:
  std::vector<double> m_wall_ms, m_cpu_ms;
};

template <class Work>
Took timed(Work&& work, clockid_t clock = CLOCK_THREAD_CPUTIME_ID) {
  const Stopwatch stopwatch(clock);
  work();
  return stopwatch.elapsed();
}

}  // namespace trivet::perf
