// Mass, centre of mass and inertia that a file or a user gives, instead of those of the geometry.
#pragma once

#include <optional>

#include "core/base/sentence.h"
#include "core/base/types.h"

namespace trivet {

/// Accepted masses, kilograms.
inline constexpr double kMinMass = 1e-9, kMaxMass = 1e12;

/// A value not given follows from the geometry, at uniform density. Metres from the object's
/// origin, z up: the frame of its pose.
struct GivenMass {
  double kilograms = 1;
  std::optional<Vec3> centre;   // of mass
  std::optional<Mat3> inertia;  // kg m^2 about the centre, symmetric

  friend bool operator==(const GivenMass&, const GivenMass&) = default;
};

/// Why no rigid body has this mass: a number out of range, an inertia that no distribution of mass
/// has. Nothing: it is accepted. Principal moments may break the triangle inequality by a
/// thousandth, as those of rounded files do.
std::optional<Sentence> refuse_mass(const GivenMass& mass);

}  // namespace trivet
