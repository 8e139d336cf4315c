#include "core/flex/newton_step.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace trivet::flex {
namespace {

constexpr double kPinnedPerWeight = 1000;           // 1/m: diagonal of a pinned vertex
constexpr double kShift = 8, kLargestShift = 1e12;  // 1/s2: mass that makes a matrix definite
constexpr int kIterations = 30;

bool has_own_contact(const State& state) {
  return std::any_of(state.pairs.begin(), state.pairs.end(),
                     [](const ContactPair& p) { return p.pair.is_own(); });
}

// No symmetry is kept: each component has a number of its own between -1 and 1.
Points scattered(size_t count) {
  Points out(count);
  std::uint32_t bits = 1;
  for (Vec3& p : out)
    for (int k = 0; k < 3; ++k) {
      bits = bits * 1664525u + 1013904223u;  // Numerical Recipes' generator
      p[k] = (bits >> 8) / double(1 << 23) - 1;
    }
  return out;
}

bool is_finite(const Points& points) {
  return std::all_of(points.begin(), points.end(), [](const Vec3& p) { return p.allFinite(); });
}

}  // namespace

void NewtonStep::prepare(const EnergyModel& model, const State& state, Curvature which, double h) {
  // Mass over h keeps the step near: a small h trusts the model less.
  model.curvature(state, which, m_matrix);
  for (size_t v = 0; v < m_body.size(); ++v) {
    const int i = static_cast<int>(v);
    m_matrix.add(i, i, Mat3::Identity() * (m_body.mass[v] / h));
    // Pinned vertices have a row of their own, and do not move.
    if (m_body.pinned[v]) m_matrix.pin(i, kPinnedPerWeight * m_body.mean_weight());
  }
  // The order of elimination stays good while the pattern does.
  if (m_is_ordered && m_factors.covers(m_matrix)) return;
  // Contacts of the body with itself join what the rest shape has apart: positions help to find
  // cuts then.
  Multifrontal::Coordinates coordinates(has_own_contact(state) ? 5 : 2);
  for (size_t k = 0; k < coordinates.size(); ++k)
    for (size_t v = 0; v < m_body.size(); ++v)
      coordinates[k].push_back(k < 2 ? m_body.rest[v][static_cast<int>(k)]
                                     : state.x[v][static_cast<int>(k) - 2]);
  m_factors.analyse(m_matrix, coordinates);
  m_is_ordered = true;
}

bool NewtonStep::solve_prepared(Points& step) {
  if (!m_factors.factor(m_matrix)) return false;
  m_factors.solve(step);
  for (size_t v = 0; v < step.size(); ++v)
    if (m_body.pinned[v]) step[v].setZero();
  return is_finite(step);
}

bool NewtonStep::solve(const EnergyModel& model, const State& state, Curvature which, double h,
                       Points& step) {
  prepare(model, state, which, h);
  step.resize(state.x.size());
  for (size_t v = 0; v < step.size(); ++v)
    step[v] = m_body.pinned[v] ? Vec3(Vec3::Zero()) : Vec3(-state.gradient[v]);
  return solve_prepared(step);
}

bool NewtonStep::solve_again(const State& state, const std::vector<HalfSpace>& hits, Points& step) {
  step.resize(state.x.size());
  for (size_t v = 0; v < step.size(); ++v)
    step[v] = m_body.pinned[v] ? Vec3(Vec3::Zero()) : Vec3(-state.gradient[v]);
  for (const HalfSpace& hit : hits) {
    if (m_body.pinned[hit.vertex]) continue;
    // A spring as stiff as the vertex holds it off the half-space, so that its neighbours know.
    Mat3& diagonal = *m_matrix.find(hit.vertex, hit.vertex);
    const double stiffness = diagonal.trace();
    diagonal += stiffness * outer(hit.normal, hit.normal);
    step[hit.vertex] -= stiffness * hit.room * hit.normal;
  }
  return solve_prepared(step);
}

bool NewtonStep::is_stable(const EnergyModel& model, const State& state, double h) {
  prepare(model, state, Curvature::Exact, h);
  return m_factors.factor(m_matrix);
}

// Inverse iteration: with just enough mass to be definite, the matrix gives way most along its
// least eigenvector.
bool NewtonStep::find_unstable(const EnergyModel& model, const State& state, double h,
                               Points& direction) {
  double shift = 1 / h;
  do {
    shift *= kShift;
    if (shift > kLargestShift) return false;
    prepare(model, state, Curvature::Exact, 1 / shift);
  } while (!m_factors.factor(m_matrix));
  direction = scattered(m_body.size());
  double least = 0;
  for (int i = 0; i < kIterations; ++i) {
    for (size_t v = 0; v < direction.size(); ++v)
      direction[v] *= m_body.pinned[v] ? 0 : m_body.mass[v];
    Points solved = direction;
    m_factors.solve(solved);
    // Rayleigh's quotient of the matrix is that of the second derivative and the shift.
    double force = 0, mass = 0;
    for (size_t v = 0; v < solved.size(); ++v) {
      if (m_body.pinned[v]) solved[v].setZero();
      force += solved[v].dot(direction[v]);
      mass += m_body.mass[v] * solved[v].squaredNorm();
    }
    if (!(mass > 0)) return false;
    least = force / mass - shift;
    const double norm = std::sqrt(mass);
    for (size_t v = 0; v < solved.size(); ++v) direction[v] = solved[v] / norm;
  }
  return least < -1 / h && is_finite(direction);
}

}  // namespace trivet::flex
