// Brings a flexible body to rest: steps that lower the energy, in two phases of friction.
#pragma once

#include <functional>

#include "core/flex/newton_step.h"

namespace trivet::flex {

struct Progress {
  int level = 0, step = 0;
  double residual = 0;  // largest force left at a vertex, of its weight
  double energy = 0;    // J
  const Points* x = nullptr;
};

/// Called before each step. @return false to stop.
using Watch = std::function<bool(const Progress&)>;

enum class Ending { AtRest, OutOfSteps, Stuck, Stopped };

struct MinimiserOptions {
  double tolerance = 1e-3;  // of a vertex's weight
  int max_steps = 4000;
  double exact_below = 0.3;  // residual from which on the exact second derivative comes first
};

/// In the flow phase, friction is updated after each step: a heavily damped slide. In the lag
/// phase it is fixed while the energy is truly minimised, and updated then; at rest the residual
/// stays small after the update. What is balanced there without being stable is pushed, and goes
/// on.
class Minimiser {
 public:
  Minimiser(const Body& body, Surroundings& surroundings, EnergyModel& model,
            const MinimiserOptions& options);

  /// @param state  its positions: clear of each other and of obstacles.
  Ending run(State& state, const Watch& watch, int level = 0);

  /// At rest: true if no small push grows faster than in 1,000 s.
  bool is_stable() const { return m_is_stable; }
  double residual() const { return m_residual; }
  int num_steps() const { return m_step; }

 private:
  bool has_come_to_rest(State& state);
  bool leaves_balance(State& state);
  bool fall(State& state, Points step);
  void choose_phase(State& state);
  bool find_direction(const State& state, Points& step);
  bool find_exact_direction(const State& state, Points& step);
  void shorten(Points& step) const;
  bool is_lower(const State& state, const State& next) const;
  bool take_step(State& state, Points step);
  bool try_part(const State& state, const Points& step, double part);
  void follow_up(State& state, double part);

  const Body& m_body;
  EnergyModel& m_model;
  MinimiserOptions m_options;
  NewtonStep m_newton;
  StepLimits m_limits;
  State m_next;
  bool m_flows = true;
  double m_residual = 0;
  double m_h;                      // s2: of mass / h in the matrix
  int m_step = 0, m_full = 0;      // steps; whole ones in a row
  int m_frozen = 0;                // steps since the friction was updated
  int m_skips = 0, m_skipped = 0;  // steps without exact derivatives: next time, and to come
  bool m_is_stable = false;
  int m_pushes = 0;  // out of balance
  int m_marked_step = 0, m_stalls = 0;
  double m_marked_energy = 0;  // by which stalls are seen
};

}  // namespace trivet::flex
