// Mass, centre and spread of bodies made of several shapes, by the rules of engines.
#pragma once

#include <array>
#include <optional>

#include "core/mesh/given_mass.h"
#include "core/mesh/mesh.h"
#include "core/motion/pose.h"

namespace trivet {

/// A shape of density 1 in its own frame.
struct SolidMoments {
  double volume = 0;           // of shells: the area
  Vec3 centre = Vec3::Zero();  // of mass
  Mat3 spread = Mat3::Zero();  // mean of (x - centre)(x - centre)^T
};
SolidMoments box_moments(const Vec3& half);
SolidMoments ellipsoid_moments(const Vec3& radii);
SolidMoments cylinder_moments(double radius, double half);
SolidMoments capsule_moments(double radius, double half);

/// The way a mesh weighs: Exact by signed tetrahedra; Legacy, MuJoCo's default, by their
/// magnitudes, about the middle of the surface and then about the centre that comes out; Shell by
/// area.
enum class MeshMass { Exact, Legacy, Shell };
SolidMoments mesh_moments(const Mesh& mesh, MeshMass rule);

/// Inertia of its six numbers: xx, yy, zz, xy, xz, yz. All are read before a matrix is filled,
/// which an error must not interrupt.
Mat3 inertia_of(const std::array<double, 6>& numbers);

/// The shape of density 1 / volume that has the centre and the inertia of a mass; volume 1.
SolidMoments moments_of(const GivenMass& mass);

/// Parts of a body, in the body's frame.
class MassSum {
 public:
  /// @param pose  of the part's frame in the body's.
  void add(double kilograms, const SolidMoments& part, const Pose& pose);
  double kilograms() const { return m_kilograms; }
  /// There is none without mass.
  std::optional<GivenMass> total() const;

 private:
  double m_kilograms = 0;
  Vec3 m_first = Vec3::Zero();
  Mat3 m_second = Mat3::Zero();
};

}  // namespace trivet
