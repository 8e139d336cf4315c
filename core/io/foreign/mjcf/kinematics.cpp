// Places of bodies and joints, and which bodies are rigid with each other.
#include <Eigen/Geometry>
#include <numbers>

#include "core/io/foreign/mjcf/model.h"

namespace trivet::mjcf {
namespace {

constexpr double kRadians = std::numbers::pi / 180;

// The joint's displacement, applied to the pose of its body. @param qpos  null: none.
Pose moved_by(const Joint& joint, const Pose& pose, const Qpos* qpos) {
  // Without numbers the body stays where its element puts it.
  if (!qpos) return pose;
  const auto at = [&](size_t i) { return (*qpos)[joint.first_number + i]; };
  // A free joint's numbers are the pose itself, in the world.
  if (joint.kind == Joint::Kind::Free)
    return {Rotation{at(3), at(4), at(5), at(6)}.normalized(), {at(0), at(1), at(2)}};
  const Mat3 r = pose.rotation.matrix();
  if (joint.kind == Joint::Kind::Slide)
    return {pose.rotation, pose.translation + r * joint.axis * (at(0) - joint.reference)};
  const Rotation turn = joint.kind == Joint::Kind::Ball
                            ? Rotation{at(0), at(1), at(2), at(3)}.normalized()
                            : turn_about(joint.axis, at(0) / kRadians - joint.reference);
  // The anchor stays where it is; the body turns about it.
  const Vec3 anchor = pose.translation + r * joint.anchor;
  const Rotation rotation = pose.rotation * turn;
  return {rotation, anchor - rotation.matrix() * joint.anchor};
}

}  // namespace

Kinematics kinematics_of(const Model& model, const Qpos* qpos) {
  Kinematics out;
  out.bodies.resize(model.bodies.size());
  out.joints.resize(model.bodies.size());
  // Parents come before their children, so that one pass places all bodies.
  for (size_t i = 1; i < model.bodies.size(); ++i) {
    const Body& body = model.bodies[i];
    Pose pose = composed(out.bodies[static_cast<size_t>(body.parent)], body.local);
    // Each joint is told where it is before it moves the body, and after those in front of it.
    for (const Joint& joint : body.joints) {
      const Mat3 r = pose.rotation.matrix();
      out.joints[i].push_back({r * joint.axis, pose.translation + r * joint.anchor});
      pose = moved_by(joint, pose, qpos);
    }
    // Turns multiply: the rotation is made unit again before rounding adds up.
    out.bodies[i] = {pose.rotation.normalized(), pose.translation};
  }
  return out;
}

Qpos reference_numbers(const Model& model) {
  Qpos out;
  // Without displacements free bodies stand where the file puts them.
  const Kinematics at = kinematics_of(model, nullptr);
  for (size_t i = 0; i < model.bodies.size(); ++i)
    for (const Joint& joint : model.bodies[i].joints) {
      const Rotation& r = at.bodies[i].rotation;
      const Vec3& p = at.bodies[i].translation;
      if (joint.kind == Joint::Kind::Free)
        out.insert(out.end(), {p.x(), p.y(), p.z(), r.w, r.x, r.y, r.z});
      else if (joint.kind == Joint::Kind::Ball)
        out.insert(out.end(), {1, 0, 0, 0});
      else
        out.push_back(joint.kind == Joint::Kind::Hinge ? joint.reference * kRadians
                                                       : joint.reference);
    }
  return out;
}

Groups::Groups(const Model& model) : m_model(model), m_weld(model.bodies.size(), 0) {
  // A body without a joint is rigid with its parent, and so with the first body above that has one.
  for (size_t i = 1; i < model.bodies.size(); ++i) {
    const Body& body = model.bodies[i];
    m_weld[i] =
        body.joints.empty() ? m_weld[static_cast<size_t>(body.parent)] : static_cast<int>(i);
  }
  for (size_t i = 1; i < model.bodies.size(); ++i)
    if (m_weld[i] == static_cast<int>(i)) m_has_links.insert(parent_weld(static_cast<int>(i)));
}

int Groups::parent_weld(int weld) const {
  return weld == 0 ? -1 : m_weld[static_cast<size_t>(m_model.bodies[weld].parent)];
}

bool Groups::is_base(int weld) const {
  const std::vector<Joint>& joints = m_model.bodies[weld].joints;
  return weld != 0 && joints.size() == 1 && joints[0].kind == Joint::Kind::Free &&
         parent_weld(weld) == 0;
}

}  // namespace trivet::mjcf
