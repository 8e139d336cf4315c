#include "core/io/simulators/joints.h"

#include <algorithm>

namespace trivet {
namespace {

constexpr double kNoLimit = 1e6;  // metres or radians

}  // namespace

JointsOfBodies::JointsOfBodies(const SimulationScene& scene)
    : m_of(scene.bodies.size()), m_below(scene.bodies.size()) {
  for (const SimulationJoint& joint : scene.joints) {
    m_of.at(joint.child) = &joint;
    if (joint.parent) m_below.at(*joint.parent).push_back(&joint);
  }
}

std::vector<size_t> JointsOfBodies::tree(size_t body) const {
  std::vector<size_t> out = {body};
  for (size_t i = 0; i < out.size(); ++i)
    for (const SimulationJoint* joint : m_below[out[i]]) out.push_back(joint->child);
  return out;
}

Pose relative_pose(const Pose& a, const Pose& b) {
  const Rotation& r = a.rotation;
  const Rotation back{r.w, -r.x, -r.y, -r.z};
  return {(back * b.rotation).normalized(),
          back.normalized().matrix() * (b.translation - a.translation)};
}

Rotation x_to(const Vec3& axis) {
  const double w = 1 + axis.x();
  if (w < 1e-9) return {0, 0, 0, 1};
  return Rotation{w, 0, -axis.z(), axis.y()}.normalized();
}

double finite_limit(double limit) { return std::clamp(limit, -kNoLimit, kNoLimit); }

}  // namespace trivet
