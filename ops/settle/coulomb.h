// The first motion of bodies that are let go, with Coulomb friction at their contacts.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "core/base/types.h"

namespace trivet {

/// Velocity of a rigid body: of its centre of mass, and angular.
struct Twist {
  Vec3 velocity = Vec3::Zero(), turning = Vec3::Zero();

  Vec3 at(const Vec3& arm) const { return velocity + turning.cross(arm); }
};

struct CoulombBody {
  Vec3 centre;                                   // of mass
  double weight = 1;                             // in parts of any unit
  double size = 0;                               // diagonal, metres
  Mat3 inverse_inertia_per_mass = Mat3::Zero();  // world; zero: it does not turn
};

/// A contact of body `on`; the normal points to it.
struct CoulombContact {
  static constexpr Index kGround = -1;
  Index on = 0, from = kGround;
  Vec3 point, normal;
  double friction = 0;
  /// Metres that the bodies may still approach each other in a step that moves the fastest by
  /// CoulombOptions::step of its size; 0: they touch.
  double room = 0;
};

struct CoulombOptions {
  double parting = 1e-3;  // contacts part at this part of the bodies' speeds
  double step = 0.1;
};

struct FirstTwists {
  std::vector<Twist> twists;  // of each body
  double duration = 0;        // seconds of the step, in which contacts may use up their room
};

/// Velocities from rest after a short time of gravity (along -z) and contact forces: Gauss' least
/// constraint over the cones of Coulomb friction, by Gauss-Seidel sweeps over the contacts [Jourdan
/// 1998; Acary 2011], each of which finds its contact's force exactly (contact_force.h). All bodies
/// have one mass; weights are true. That is as good where only directions count, and needs far
/// fewer sweeps where masses differ. Sweeps are limited: of 1,059 motions of one body in heaps
/// 1.2 % were off by more than 1 %, of 50 of several bodies 44 %. Cost O(sweeps x contacts).
FirstTwists first_motion(const std::vector<CoulombBody>& bodies,
                         const std::vector<CoulombContact>& contacts,
                         const CoulombOptions& options = {});

/// The vector nearest to `wanted` of length one with normals[i] . x >= parting for all, by
/// Hildreth's projection [1957]. Zero: nearly none is left of it.
Vec3 parting_direction(const std::vector<Vec3>& normals, const Vec3& wanted, double parting);

}  // namespace trivet
