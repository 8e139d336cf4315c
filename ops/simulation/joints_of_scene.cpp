#include "ops/simulation/joints_of_scene.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/scene/joint_load.h"
#include "ops/operations/carried_with.h"

namespace trivet {
namespace {

constexpr double kHoldingShare = 1.5;  // of the load that friction bears
constexpr double kRadiansOfDegree = std::numbers::pi / 180;

class JointMaker {
 public:
  JointMaker(const Scene& scene, const std::vector<SceneJoint>& joints,
             const std::map<ObjectId, size_t, SlotOrder>& body_of,
             const std::vector<SimulationBody>& bodies)
      : m_scene(scene),
        m_joints(joints),
        m_body_of(body_of),
        m_bodies(bodies),
        m_hangs(bodies.size()) {}

  SimulationJoints make() {
    for (const SceneJoint& joint : m_joints)
      if (joint.held.empty()) add(joint);
    for (const SceneJoint& joint : m_joints)
      if (!joint.held.empty())
        m_out.notes.push_back(
            say("the joint \"%1\" is written as fixed: %2", joint.name, joint.held));
    fix_what_follows();
    return std::move(m_out);
  }

 private:
  bool has(ObjectId id) const { return m_body_of.count(id) != 0; }

  void add(const SceneJoint& joint) {
    if (!has(joint.links[0])) return;
    const size_t child = m_body_of.at(joint.links[0]);
    if (m_hangs[child]) {
      m_out.notes.push_back(
          say("the joint \"%1\" is not written: its link hangs in another one, too", joint.name));
      return;
    }
    m_hangs[child] = true;
    SimulationJoint out;
    out.kind = joint.turns ? SimulationJoint::Kind::Hinge : SimulationJoint::Kind::Slide;
    out.name = joint.name, out.child = child;
    for (const ObjectId frame : joint.frames)
      if (has(frame)) out.apart.push_back(m_body_of.at(frame));
    if (!out.apart.empty()) out.parent = out.apart[0];
    const Pose& pose = m_bodies[child].world_from_link;
    const Mat3 back = pose.rotation.matrix().transpose();
    out.axis = (back * joint.axis).normalized();
    if (joint.turns) out.anchor = back * (joint.anchor - pose.translation);
    const double unit = joint.turns ? kRadiansOfDegree : 1;
    out.value = unit * joint.value;
    out.lower = unit * joint.lower, out.upper = unit * joint.upper;
    out.friction = holding(joint);
    m_out.joints.push_back(std::move(out));
  }

  // Force along the axis, or torque about it, of the weights of all links and their contents.
  double load_on(const SceneJoint& joint) const {
    double out = 0;
    for (const ObjectId id :
         carried_with(m_scene, joint.links[0], std::span(joint.links).subspan(1))) {
      if (!has(id)) continue;
      const SimulationBody& body = m_bodies[m_body_of.at(id)];
      const Vec3 centre =
          body.world_from_link.translation + body.world_from_link.rotation.matrix() * body.centre;
      out += joint_load(joint, centre, kGravity * body.mass);
    }
    return out;
  }

  double holding(const SceneJoint& joint) {
    const double load = load_on(joint);
    if (!moves_joint(joint, joint.friction, load)) return joint.friction;
    const double friction = kHoldingShare * std::abs(load);
    m_out.notes.push_back(joint.turns
                              ? say("the joint \"%1\" would swing: friction of %2 N m holds it",
                                    joint.name, figure(friction))
                              : say("the joint \"%1\" would slide: friction of %2 N holds it",
                                    joint.name, figure(friction)));
    return friction;
  }

  // Links that go along, but hang in no joint of their own.
  void fix_what_follows() {
    std::vector<const SceneJoint*> smallest(m_bodies.size());
    for (const SceneJoint& joint : m_joints) {
      if (!joint.held.empty() || !has(joint.links[0])) continue;
      for (const ObjectId id : joint.links) {
        if (!has(id) || m_hangs[m_body_of.at(id)]) continue;
        const SceneJoint*& best = smallest[m_body_of.at(id)];
        if (!best || joint.links.size() < best->links.size()) best = &joint;
      }
    }
    for (size_t i = 0; i < m_bodies.size(); ++i) {
      if (!smallest[i]) continue;
      SimulationJoint out;
      out.name = "joint of " + m_bodies[i].name;
      out.child = i;
      out.parent = m_body_of.at(smallest[i]->links[0]);
      out.apart = {*out.parent};
      m_out.joints.push_back(std::move(out));
    }
  }

  const Scene& m_scene;
  const std::vector<SceneJoint>& m_joints;
  const std::map<ObjectId, size_t, SlotOrder>& m_body_of;
  const std::vector<SimulationBody>& m_bodies;
  std::vector<bool> m_hangs;  // by body: in a joint of its own
  SimulationJoints m_out;
};

}  // namespace

SimulationJoints simulation_joints(const Scene& scene, const std::vector<SceneJoint>& joints,
                                   const std::map<ObjectId, size_t, SlotOrder>& body_of,
                                   const std::vector<SimulationBody>& bodies) {
  return JointMaker(scene, joints, body_of, bodies).make();
}

}  // namespace trivet
