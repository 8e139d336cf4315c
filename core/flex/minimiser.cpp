#include "core/flex/minimiser.h"

#include <algorithm>
#include <cmath>

namespace trivet::flex {
namespace {

constexpr double kLongestStep = 1.5;                                   // cells
constexpr double kFirstH = 0.03, kLargestH = 1e4, kSmallestH = 1e-12;  // s2
constexpr double kCalm = 0.05;   // residual below which friction is frozen
constexpr int kStallSteps = 20;  // in which the energy has to fall
constexpr double kStall = 1e-3;  // by so much, of weight x slip
constexpr int kMostFrozen = 60;  // steps
constexpr int kMostStalls = 5;   // after which friction stays frozen
constexpr int kBackSteps = 5;
constexpr double kRounding = 1e-13;     // of the energy
constexpr double kStableSquared = 1e6;  // s2: pushes that grow faster are seen
constexpr double kPush = 0.5;           // cells, of the vertex that goes farthest
constexpr int kMostSkips = 7;           // steps without exact derivatives after they failed
constexpr int kMostPushes = 10, kPushCuts = 8;

}  // namespace

Minimiser::Minimiser(const Body& body, Surroundings& surroundings, EnergyModel& model,
                     const MinimiserOptions& options)
    : m_body(body),
      m_model(model),
      m_options(options),
      m_newton(body),
      m_limits(surroundings, model.contact()),
      m_h(kFirstH) {}

bool Minimiser::has_come_to_rest(State& state) {
  // A pair that began nearer than the thickness has to be beyond it in the end.
  if (m_model.raise_kept(state)) return false;
  // Friction is updated, and the force that is left afterwards decides: before it, rest would be a
  // matter of old anchors.
  m_model.update_friction(state, !m_flows);
  m_residual = m_model.residual(state.gradient);
  m_frozen = 0;
  m_flows = false;
  return m_residual < m_options.tolerance;
}

// A state that is balanced without being stable, as a sheet that hangs flat from one corner, is
// pushed to where it falls.
bool Minimiser::leaves_balance(State& state) {
  m_is_stable = m_newton.is_stable(m_model, state, kStableSquared);
  Points step;
  if (m_is_stable || m_pushes == kMostPushes ||
      !m_newton.find_unstable(m_model, state, kStableSquared, step))
    return false;
  ++m_pushes;
  double longest = 0, slope = 0;
  for (size_t v = 0; v < step.size(); ++v) {
    longest = std::max(longest, step[v].norm());
    slope += step[v].dot(state.gradient[v]);
  }
  // Both ways lead down; the one that begins downhill is taken.
  const double scale = (slope > 0 ? -kPush : kPush) * m_body.cell / longest;
  for (Vec3& s : step) s *= scale;
  return fall(state, std::move(step));
}

bool Minimiser::fall(State& state, Points step) {
  m_limits.limit(state.x, step);
  double part = 1;
  for (int cut = 0; cut < kPushCuts; ++cut, part /= 3) {
    if (!try_part(state, step, part) || m_next.energy >= state.energy) continue;
    std::swap(state, m_next);
    m_flows = true;
    m_h = kFirstH;
    m_full = 0;
    m_model.update_friction(state, false);
    m_marked_step = m_step, m_marked_energy = state.energy;
    return true;
  }
  return false;
}

// Updates at every step may go round in circles near rest; so friction is frozen when the state is
// calm or the energy no longer falls.
void Minimiser::choose_phase(State& state) {
  const auto mark = [&] { m_marked_step = m_step, m_marked_energy = state.energy; };
  if (m_flows) {
    // A calm body freezes its friction, so that the energy can truly be minimised.
    if (m_residual < kCalm && m_h > 1) m_flows = false;
    if (m_step - m_marked_step < kStallSteps) return;
    const double least = kStall * m_body.weight() * m_model.friction().slip();
    // Friction that goes round in circles stops the fall of energy: then it is frozen, too.
    if (m_marked_energy - state.energy < least) m_flows = false, ++m_stalls;
    mark();
  } else if (++m_frozen > kMostFrozen) {
    m_model.update_friction(state, true);
    m_frozen = 0;
    // A large residual after the update means that it slides again.
    if (m_model.residual(state.gradient) > 1 && m_stalls < kMostStalls) m_flows = true, mark();
  }
}

bool Minimiser::find_exact_direction(const State& state, Points& step) {
  if (m_newton.solve(m_model, state, Curvature::Exact, m_h, step)) return true;
  // A shorter horizon makes the matrix more definite, at the price of a shorter step.
  if (m_h <= 1 || !m_newton.solve(m_model, state, Curvature::Exact, m_h / 100, step)) return false;
  m_h /= 100;
  return true;
}

bool Minimiser::find_direction(const State& state, Points& step) {
  // Exact derivatives converge fastest near the end, and may fail far from it: where they fail,
  // they are left out in more and more steps.
  if (m_residual < m_options.exact_below && --m_skipped < 0) {
    if (find_exact_direction(state, step)) {
      m_skips = 0;
      return true;
    }
    m_skipped = m_skips;
    m_skips = std::min(2 * m_skips + 1, kMostSkips);
  }
  return m_newton.solve(m_model, state, Curvature::Hybrid, m_h, step) ||
         m_newton.solve(m_model, state, Curvature::Positive, m_h, step);
}

void Minimiser::shorten(Points& step) const {
  double longest = 0;
  for (const Vec3& s : step) longest = std::max(longest, s.norm());
  // A step much longer than a cell leaves what the model knows of contacts.
  const double limit = kLongestStep * m_body.cell;
  if (longest <= limit) return;
  for (Vec3& s : step) s *= limit / longest;
}

bool Minimiser::is_lower(const State& state, const State& next) const {
  // Rounding may hide the last falls of energy: then the residual has to halve.
  if (next.energy <= state.energy + kRounding * std::abs(state.energy) + 1e-16) return true;
  return next.energy <= state.energy + 1e-9 * std::abs(state.energy) &&
         m_model.residual(next.gradient) < 0.5 * m_residual;
}

// Into m_next. @return false where it touches.
bool Minimiser::try_part(const State& state, const Points& step, double part) {
  m_next.x = state.x;
  for (size_t v = 0; v < step.size(); ++v) m_next.x[v] += part * step[v];
  return m_model.evaluate(m_next);
}

// Every part of a limited step keeps to the limits, too. What a refused step hits becomes part of
// the model, which is solved again once; else a vertex that is held while its neighbours go on
// stretches the membrane, and the step is cut again and again.
bool Minimiser::take_step(State& state, Points step) {
  shorten(step);
  // Limits come before the search, so that every tried state is free of crossings.
  std::vector<HalfSpace> hits = m_limits.limit(state.x, step);
  double part = 1;
  // The step is cut to a third until the energy falls.
  for (int back = 0; back < kBackSteps; ++back) {
    if (try_part(state, step, part) && is_lower(state, m_next)) {
      std::swap(state, m_next);
      follow_up(state, part);
      return true;
    }
    part /= 3;
    // The first refusal solves again with springs at what was hit; later ones only cut.
    if (back > 0 || hits.empty() || !m_newton.solve_again(state, hits, step)) continue;
    shorten(step);
    m_limits.limit(state.x, step);
    part = 1;
  }
  return false;
}

void Minimiser::follow_up(State& state, double part) {
  if (part == 1) {
    // Whole steps lengthen the horizon, cut ones shorten it.
    m_h = std::min(m_h * (++m_full > 2 ? 2 : 1.3), kLargestH);
  } else {
    m_full = 0;
    m_h /= part > 0.3 ? 2 : 4;
  }
  if (!m_flows) return;
  m_model.raise_kept(state);
  m_model.update_friction(state, false);
}

Ending Minimiser::run(State& state, const Watch& watch, int level) {
  if (!m_model.evaluate(state)) return Ending::Stuck;
  m_model.update_friction(state, false);
  m_marked_energy = state.energy;
  Points step;
  // Each step: judge, choose the phase of friction, find a direction, go along it.
  for (m_step = 0; m_step < m_options.max_steps; ++m_step) {
    m_residual = m_model.residual(state.gradient);
    if (watch && !watch({level, m_step, m_residual, state.energy, &state.x}))
      return Ending::Stopped;
    if (m_residual >= m_options.tolerance)
      choose_phase(state);
    else if (has_come_to_rest(state) && !leaves_balance(state))
      return m_model.contact().keeps_any() ? Ending::Stuck : Ending::AtRest;
    // Without direction or descent the horizon shrinks; a tiny one means that it is stuck.
    if (!find_direction(state, step)) {
      m_h /= 4;
    } else if (!take_step(state, step)) {
      m_h /= 8;
      m_full = 0;
    }
    if (m_h < kSmallestH) return Ending::Stuck;
  }
  m_residual = m_model.residual(state.gradient);
  return Ending::OutOfSteps;
}

}  // namespace trivet::flex
