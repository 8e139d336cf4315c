#include "core/scene/joint_load.h"

#include <Eigen/Geometry>
#include <cmath>

namespace trivet {
namespace {

constexpr double kLeastLoad = 1e-6;     // newtons or newton metres that count
constexpr double kAtJointLimit = 1e-9;  // metres or degrees

}  // namespace

double joint_load(const JointPlace& joint, const Vec3& centre, double newtons) {
  const Vec3 weight(0, 0, -newtons);
  return joint.turns ? joint.axis.dot((centre - joint.anchor).cross(weight))
                     : joint.axis.dot(weight);
}

bool moves_joint(const JointPlace& joint, double friction, double load) {
  const bool stopped = load > 0 ? joint.value >= joint.upper - kAtJointLimit
                                : joint.value <= joint.lower + kAtJointLimit;
  return !stopped && std::abs(load) > friction + kLeastLoad;
}

}  // namespace trivet
