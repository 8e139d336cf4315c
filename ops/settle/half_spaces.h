// The point of many half spaces that is nearest to another.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <vector>

namespace trivet {

/// All x with normal . x >= bound. The normal need not be of length one: `squared` is its square.
template <int N>
struct HalfSpace {
  Eigen::Matrix<double, N, 1> normal;
  double bound = 0, squared = 1;
};

/// The point of all half spaces that is nearest to `x`, by Hildreth's projection [1957]: as near as
/// `max_sweeps` get; somewhere else if there is none.
template <int N>
Eigen::Matrix<double, N, 1> nearest_inside(const std::vector<HalfSpace<N>>& spaces,
                                           Eigen::Matrix<double, N, 1> x, int max_sweeps) {
  // Each weight is the push that its half space has given so far. It never becomes negative: a
  // space may take back its push, but does not pull.
  std::vector<double> weights(spaces.size(), 0.0);
  bool changes = true;
  for (int sweep = 0; changes && sweep < max_sweeps; ++sweep) {
    changes = false;
    for (size_t i = 0; i < spaces.size(); ++i) {
      const HalfSpace<N>& s = spaces[i];
      const double change = std::max(-weights[i], (s.bound - s.normal.dot(x)) / s.squared);
      if (change == 0) continue;
      changes = true;
      weights[i] += change;
      x += change * s.normal;
    }
  }
  return x;
}

}  // namespace trivet
