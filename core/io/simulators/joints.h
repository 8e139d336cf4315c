// Joints of a scene as its writers need them. Private.
#pragma once

#include <vector>

#include "core/io/simulators/simulation_scene.h"

namespace trivet {

/// Looks joints up by body.
class JointsOfBodies {
 public:
  explicit JointsOfBodies(const SimulationScene& scene);
  /// The one that the body hangs in; null: none.
  const SimulationJoint* of(size_t body) const { return m_of[body]; }
  /// Joints of the bodies that hang in it.
  const std::vector<const SimulationJoint*>& below(size_t body) const { return m_below[body]; }
  /// The body and all that hang in it, those above first.
  std::vector<size_t> tree(size_t body) const;

 private:
  std::vector<const SimulationJoint*> m_of;
  std::vector<std::vector<const SimulationJoint*>> m_below;
};

/// Pose of b's frame in a's.
Pose relative_pose(const Pose& a, const Pose& b);

/// Turns the x axis to a unit vector.
Rotation x_to(const Vec3& axis);

/// A limit that formats want as a number.
double finite_limit(double limit);

}  // namespace trivet
