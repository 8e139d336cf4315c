// Slides and hinges: what they move, their limits, and whether gravity would move them.
#include <Eigen/Geometry>
#include <cmath>
#include <map>
#include <numbers>

#include "core/io/foreign/mjcf/model.h"

namespace trivet::mjcf {
namespace {

constexpr double kGravity = 9.81;    // m/s^2
constexpr double kLeastLoad = 1e-6;  // newtons or newton metres that count
constexpr double kAtLimit = 1e-9;    // metres or degrees

// Joints that something else drives or ties.
std::set<std::string> driven_joints(const XmlNode& root) {
  std::set<std::string> out;
  for (const XmlNode& section : root.children)
    if (section.tag == "actuator" || section.tag == "equality")
      for (const XmlNode& node : section.children)
        for (const char* key : {"joint", "joint1", "joint2", "jointinparent"})
          if (const std::string* const name = node.find(key)) out.insert(*name);
  return out;
}

class JointAdder {
 public:
  JointAdder(const XmlNode& root, const Model& model, const Groups& groups, const Kinematics& at,
             const std::vector<std::string>& names, ForeignScene& scene)
      : m_model(model),
        m_groups(groups),
        m_at(at),
        m_names(names),
        m_driven(driven_joints(root)),
        m_scene(scene) {
    for (const ForeignBody& body : scene.bodies) m_bodies[body.name] = &body;
  }

  void add_all(const Qpos& numbers) {
    for (size_t i = 1; i < m_model.bodies.size(); ++i)
      for (size_t k = 0; k < m_model.bodies[i].joints.size(); ++k) {
        const Joint& joint = m_model.bodies[i].joints[k];
        if (joint.kind != Joint::Kind::Slide && joint.kind != Joint::Kind::Hinge) continue;
        ForeignJoint out = made(i, joint, m_at.joints[i][k], numbers);
        if (out.moves.empty()) continue;
        note_motion(out, joint);
        m_scene.joints.push_back(std::move(out));
      }
  }

 private:
  ForeignJoint made(size_t body, const Joint& joint, const PosedJoint& at, const Qpos& numbers) {
    ForeignJoint out;
    const bool turns = joint.kind == Joint::Kind::Hinge;
    out.kind = turns ? ForeignJoint::Kind::Hinge : ForeignJoint::Kind::Slide;
    out.name = joint.name.empty() ? "joint of " + m_names[body] : joint.name;
    out.axis = at.axis, out.anchor = at.anchor;
    out.lower = joint.lower, out.upper = joint.upper;
    out.number = joint.first_number;
    const double number = numbers[joint.first_number];
    out.value = turns ? number * (180 / std::numbers::pi) : number;
    for (size_t i = body; i < m_model.bodies.size(); ++i)
      if (hangs_in(m_groups.weld(i), static_cast<int>(body)) &&
          m_groups.weld(i) == static_cast<int>(i) && m_bodies.count(m_names[i]))
        out.moves.push_back(m_names[i]);
    add_frames(body, out);
    return out;
  }

  bool hangs_in(int weld, int body) const {
    while (weld > body) weld = m_groups.parent_weld(weld);
    return weld == body;
  }

  // Bodies that the world holds are one each: all of the same piece of furniture.
  void add_frames(size_t body, ForeignJoint& out) const {
    const auto parent = static_cast<size_t>(m_model.bodies[body].parent);
    const int weld = m_groups.weld(parent);
    if (weld != 0) {
      out.frames.push_back(m_names[static_cast<size_t>(weld)]);
      return;
    }
    if (parent == 0) return;
    for (size_t i = 1; i < m_model.bodies.size(); ++i)
      if (m_groups.weld(i) == 0 && top_of(i) == top_of(parent)) out.frames.push_back(m_names[i]);
  }

  // The body of the world that it is part of.
  size_t top_of(size_t body) const {
    while (m_model.bodies[body].parent != 0)
      body = static_cast<size_t>(m_model.bodies[body].parent);
    return body;
  }

  // Force along the axis, or torque about it, of the weights of all that moves.
  double load_on(const ForeignJoint& joint) const {
    double out = 0;
    for (const std::string& name : joint.moves) {
      const ForeignBody& body = *m_bodies.at(name);
      if (!body.mass) continue;
      const Vec3 weight(0, 0, -kGravity * body.mass->kilograms);
      const Vec3 centre =
          composed(body.pose, {{}, body.mass->centre.value_or(Vec3::Zero())}).translation;
      out += joint.kind == ForeignJoint::Kind::Slide
                 ? joint.axis.dot(weight)
                 : joint.axis.dot((centre - joint.anchor).cross(weight));
    }
    return out;
  }

  void note_motion(const ForeignJoint& joint, const Joint& given) {
    if (m_driven.count(given.name)) return;
    const double load = load_on(joint);
    const bool stopped =
        load > 0 ? joint.value >= joint.upper - kAtLimit : joint.value <= joint.lower + kAtLimit;
    if (stopped || !(std::abs(load) > given.friction + kLeastLoad)) return;
    note_once(m_scene.notes,
              joint.kind == ForeignJoint::Kind::Hinge
                  ? say("the link in the joint \"%1\" would swing: its weight turns it with %2 N m",
                        joint.name, figure(load))
                  : say("the link in the joint \"%1\" would slide: its weight pulls it with %2 N",
                        joint.name, figure(load)));
  }

  const Model& m_model;
  const Groups& m_groups;
  const Kinematics& m_at;
  const std::vector<std::string>& m_names;
  std::set<std::string> m_driven;
  std::map<std::string, const ForeignBody*> m_bodies;
  ForeignScene& m_scene;
};

}  // namespace

void add_joints(const XmlNode& root, const Model& model, const Groups& groups, const Kinematics& at,
                const std::vector<std::string>& names, ForeignScene& scene) {
  JointAdder(root, model, groups, at, names, scene).add_all(scene.numbers);
}

}  // namespace trivet::mjcf
