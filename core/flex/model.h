// The energy of a flexible body among obstacles: all that a minimiser needs.
#pragma once

#include "core/flex/friction.h"

namespace trivet::flex {

/// Positions with their contacts and derivatives.
struct State {
  Points x;
  std::vector<ContactPair> pairs;
  double energy = 0;  // J
  Points gradient;    // N
};

class EnergyModel {
 public:
  EnergyModel(const Body& body, Surroundings& surroundings, const ContactOptions& contact,
              double slip);

  Contact& contact() { return m_contact; }
  const Friction& friction() const { return m_friction; }
  /// Contacts, energy and gradient at state.x. @return false where it touches.
  bool evaluate(State& state);
  /// Pairs that began nearer than the thickness keep what they gained; see Contact. @return true if
  /// any did: energy and gradient are new then.
  bool raise_kept(State& state);
  /// Energy and gradient again, after an update of the friction.
  void update_friction(State& state, bool keep_faces);
  void curvature(const State& state, Curvature which, BlockMatrix& hessian) const;
  NodalForces forces(const State& state, bool with_owners = false) const;

  /// Largest force left at a vertex, of its own weight; `at`: which.
  double residual(const Points& gradient, int* at = nullptr) const;

 private:
  double sum(const State& state, Total total) const;
  void sum_up(State& state) const;

  const Body& m_body;
  Surroundings& m_surroundings;
  Contact m_contact;
  Friction m_friction;
};

}  // namespace trivet::flex
