// The direction of a step: (second derivative + mass / h) step = -gradient.
#pragma once

#include "core/flex/model.h"
#include "core/flex/multifrontal.h"
#include "core/flex/step_limits.h"

namespace trivet::flex {

class NewtonStep {
 public:
  explicit NewtonStep(const Body& body) : m_body(body) {}

  /// @param h  seconds squared: how far the step may follow the model.
  /// @return false if the matrix is not positive definite.
  bool solve(const EnergyModel& model, const State& state, Curvature which, double h, Points& step);
  /// The same matrix with springs towards half-spaces that a refused step has hit.
  bool solve_again(const State& state, const std::vector<HalfSpace>& hits, Points& step);
  /// True if the exact second derivative is positive definite with mass / h.
  bool is_stable(const EnergyModel& model, const State& state, double h);
  /// The direction in which small pushes grow fastest, or nearly, if the state is not stable.
  /// @return false if none was found.
  bool find_unstable(const EnergyModel& model, const State& state, double h, Points& direction);

 private:
  void prepare(const EnergyModel& model, const State& state, Curvature which, double h);
  bool solve_prepared(Points& step);

  const Body& m_body;
  BlockMatrix m_matrix;
  Multifrontal m_factors;
  bool m_is_ordered = false;
};

}  // namespace trivet::flex
