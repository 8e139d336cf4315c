// When an answer is due that takes many operations: then it ends with what there is.
#pragma once

#include <algorithm>
#include <functional>
#include <limits>
#include <utility>

#include "ops/base/stopwatch.h"

namespace trivet {

/// Asked now and then by work that takes long, by any thread; true: it ends as soon as it can.
/// Empty: never. Once it is true, it stays so.
using IsOver = std::function<bool()>;

inline bool is_time_over(const IsOver& is_over) { return is_over && is_over(); }

class Deadline {
 public:
  /// @param seconds  from now on; 0: unlimited. @param is_over  ends it earlier.
  explicit Deadline(double seconds = 0, IsOver is_over = {})
      : m_seconds(seconds > 0 ? seconds : std::numeric_limits<double>::infinity()),
        m_is_over(std::move(is_over)) {}

  bool is_over() const { return seconds_left() <= 0 || is_time_over(m_is_over); }
  /// Infinity: unlimited. Negative: since when it is over.
  double seconds_left() const { return m_seconds - 1e-3 * m_watch.milliseconds(); }

  /// From now on, this share of what is left.
  Deadline of_rest(double share) const {
    const double left = seconds_left();
    const bool is_limited = left < std::numeric_limits<double>::infinity();
    // A deadline of 0 seconds would be no limit.
    return Deadline(is_limited ? std::max(share * left, 1e-9) : 0, function());
  }

  IsOver function() const {
    return [deadline = *this] { return deadline.is_over(); };
  }

 private:
  double m_seconds;
  IsOver m_is_over;
  Stopwatch m_watch;
};

}  // namespace trivet
