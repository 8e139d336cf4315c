#include "core/scene/given_mass.h"

#include <Eigen/LU>

#include "core/scene/object.h"

namespace trivet {
namespace {

// Mean of (x - centre)(x - centre)^T, of an inertia of 1 kg.
Mat3 covariance_of(const Mat3& inertia_per_mass) {
  return 0.5 * inertia_per_mass.trace() * Mat3::Identity() - inertia_per_mass;
}

}  // namespace

void give_mass(const GivenMass& mass, Object& object) {
  object.given_mass = mass;
  // Kilograms alone leave the shape as it is: they are read from the object.
  if (!mass.centre && !mass.inertia) return;
  MassProperties properties = object.shape->mass;
  properties.findings = {};
  // The model's own frame is that of the shape: what was given in metres is brought back into it.
  const Affine frame = world_from_object(Pose{}, object.up, object.scale);
  const Mat3 back = frame.linear.inverse();
  if (mass.centre) properties.centre = back * *mass.centre;
  // The covariance goes from frame to frame by a product on both sides, as an inertia does not
  // where axes are scaled.
  if (mass.inertia) {
    const Mat3 spread = covariance_of(*mass.inertia / mass.kilograms);
    properties.covariance = back * spread * back.transpose();
    properties.radius_squared = properties.covariance.trace();
  }
  object.shape = with_mass(*object.shape, properties);
}

}  // namespace trivet
