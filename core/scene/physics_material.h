// Physics material of an object: what rest, weights and simulators depend on.
#pragma once

#include <algorithm>
#include <string>

namespace trivet {

/// Coulomb's coefficient of objects and floors that give none; dry everyday things have 0.3 to 0.8.
inline constexpr double kDefaultFriction = 0.5;

struct PhysicsMaterial {
  std::string name;                    // of a preset; empty: none
  double friction = kDefaultFriction;  // Coulomb's coefficient, static and kinetic; > 0
  double density = 1000;               // kg/m^3
  double restitution = 0;              // 0 to 1; for simulators only, nothing bounces here
};

/// Coefficient of two surfaces in contact: the smaller one. Simulators that take the mean or the
/// larger one then hold at least what holds here.
inline double pair_friction(const PhysicsMaterial& a, const PhysicsMaterial& b) {
  return std::min(a.friction, b.friction);
}

}  // namespace trivet
