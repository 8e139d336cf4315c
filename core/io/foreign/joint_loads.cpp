#include "core/io/foreign/joint_loads.h"

#include "core/scene/joint_load.h"

namespace trivet {
namespace {

double load_of(const ForeignBody& body, const JointPlace& joint) {
  if (!body.mass) return 0;
  const Vec3 centre =
      composed(body.pose, {{}, body.mass->centre.value_or(Vec3::Zero())}).translation;
  return joint_load(joint, centre, kGravity * body.mass->kilograms);
}

}  // namespace

void note_if_gravity_moves(const ForeignJoint& joint, std::span<const ForeignBody* const> bodies,
                           std::vector<Sentence>& notes) {
  const JointPlace place{joint.kind == ForeignJoint::Kind::Hinge,
                         joint.axis,
                         joint.anchor,
                         joint.value,
                         joint.lower,
                         joint.upper};
  double load = 0;
  for (const ForeignBody* body : bodies) load += load_of(*body, place);
  if (!moves_joint(place, joint.friction, load)) return;
  note_once(notes,
            joint.kind == ForeignJoint::Kind::Hinge
                ? say("the link in the joint \"%1\" would swing: its weight turns it with %2 N m",
                      joint.name, figure(load))
                : say("the link in the joint \"%1\" would slide: its weight pulls it with %2 N",
                      joint.name, figure(load)));
}

}  // namespace trivet
