#include "core/io/foreign/joint_loads.h"

#include <Eigen/Geometry>
#include <cmath>

namespace trivet {
namespace {

constexpr double kGravity = 9.81;         // m/s^2
constexpr double kLeastJointLoad = 1e-6;  // newtons or newton metres that count
constexpr double kAtLimit = 1e-9;         // metres or degrees

// Force along the axis, or torque about it, of the weight of a body.
double load_of(const ForeignBody& body, const ForeignJoint& joint) {
  if (!body.mass) return 0;
  const Vec3 weight(0, 0, -kGravity * body.mass->kilograms);
  const Vec3 centre =
      composed(body.pose, {{}, body.mass->centre.value_or(Vec3::Zero())}).translation;
  return joint.kind == ForeignJoint::Kind::Slide
             ? joint.axis.dot(weight)
             : joint.axis.dot((centre - joint.anchor).cross(weight));
}

}  // namespace

void note_if_gravity_moves(const ForeignJoint& joint, std::span<const ForeignBody* const> bodies,
                           std::vector<Sentence>& notes) {
  double load = 0;
  for (const ForeignBody* body : bodies) load += load_of(*body, joint);
  // The joint stands at the limit that the weight pulls it to.
  const bool stopped =
      load > 0 ? joint.value >= joint.upper - kAtLimit : joint.value <= joint.lower + kAtLimit;
  if (stopped || !(std::abs(load) > joint.friction + kLeastJointLoad)) return;
  note_once(notes,
            joint.kind == ForeignJoint::Kind::Hinge
                ? say("the link in the joint \"%1\" would swing: its weight turns it with %2 N m",
                      joint.name, figure(load))
                : say("the link in the joint \"%1\" would slide: its weight pulls it with %2 N",
                      joint.name, figure(load)));
}

}  // namespace trivet
