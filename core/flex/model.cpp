#include "core/flex/model.h"

#include <algorithm>
#include <numeric>

#include "core/base/in_parallel.h"
#include "core/flex/elasticity.h"

namespace trivet::flex {
namespace {

// Elements at the border of two shares are computed for both.
constexpr int kShareOfVertices = 700, kMostShares = 16;

}  // namespace

EnergyModel::EnergyModel(const Body& body, Surroundings& surroundings,
                         const ContactOptions& contact, double slip)
    : m_body(body),
      m_surroundings(surroundings),
      m_contact(surroundings, contact),
      m_friction(body, slip) {}

// Threads share the vertices.
double EnergyModel::sum(const State& state, Total total) const {
  const int count = static_cast<int>(state.x.size());
  const int shares = std::clamp(count / kShareOfVertices, 1, kMostShares);
  std::vector<double> energies(shares);
  in_parallel(shares, [&](size_t i) {
    const auto border = [&](int share) { return static_cast<int>(1LL * count * share / shares); };
    Total own = total;
    own.first = border(static_cast<int>(i)), own.last = border(static_cast<int>(i) + 1);
    energies[i] = elastic_energy(m_body, state.x, own) + Contact::energy(state.pairs, own) +
                  m_friction.energy(state.x, own);
  });
  return std::accumulate(energies.begin(), energies.end(), 0.0);
}

void EnergyModel::sum_up(State& state) const {
  state.gradient.assign(state.x.size(), Vec3::Zero());
  state.energy = sum(state, {&state.gradient, nullptr, Curvature::Exact});
}

bool EnergyModel::evaluate(State& state) {
  // Contacts are found first; a state that touches has no finite energy.
  if (!m_contact.find(state.x, state.pairs)) return false;
  sum_up(state);
  return true;
}

bool EnergyModel::raise_kept(State& state) {
  return m_contact.raise_kept(state.x) && evaluate(state);
}

void EnergyModel::update_friction(State& state, bool keep_faces) {
  m_friction.update(state.x, state.pairs, forces(state), keep_faces);
  sum_up(state);
}

void EnergyModel::curvature(const State& state, Curvature which, BlockMatrix& hessian) const {
  hessian.reset(state.x.size());
  sum(state, {nullptr, &hessian, which});
}

NodalForces EnergyModel::forces(const State& state, bool with_owners) const {
  return nodal_forces(m_surroundings, state.pairs, with_owners);
}

double EnergyModel::residual(const Points& gradient, int* at) const {
  double largest = 0;
  for (size_t v = 0; v < gradient.size(); ++v) {
    if (m_body.pinned[v]) continue;
    // Each vertex is judged by its own weight, so that large and small sheets have one tolerance.
    const double here = gradient[v].norm() / (m_body.mass[v] * kGravity);
    if (!(here > largest)) continue;
    largest = here;
    if (at) *at = static_cast<int>(v);
  }
  return largest;
}

}  // namespace trivet::flex
