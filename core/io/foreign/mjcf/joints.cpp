// Slides and hinges: what they move, their limits, and whether gravity would move them.
#include <initializer_list>
#include <map>
#include <numbers>

#include "core/io/foreign/joint_loads.h"
#include "core/io/foreign/mjcf/model.h"

namespace trivet::mjcf {
namespace {

// Names that elements of a section give by these attributes.
std::set<std::string> names_in(const XmlNode& root, const char* section,
                               std::initializer_list<const char*> attributes) {
  std::set<std::string> out;
  for (const XmlNode& one : root.children)
    if (one.tag == section)
      for (const XmlNode& node : one.children)
        for (const char* attribute : attributes)
          if (const std::string* const name = node.find(attribute)) out.insert(*name);
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
        m_driven(names_in(root, "actuator", {"joint", "jointinparent"})),
        m_tied(names_in(root, "equality", {"joint1", "joint2"})),
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
        if (m_tied.count(joint.name)) out.held = Sentence("an equality of the file holds it");
        if (!m_driven.count(joint.name) && !m_tied.count(joint.name))
          note_if_gravity_moves(out, bodies_of(out), m_scene.notes);
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
    out.lower = joint.lower, out.upper = joint.upper, out.friction = joint.friction;
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

  std::vector<const ForeignBody*> bodies_of(const ForeignJoint& joint) const {
    std::vector<const ForeignBody*> out;
    for (const std::string& name : joint.moves) out.push_back(m_bodies.at(name));
    return out;
  }

  const Model& m_model;
  const Groups& m_groups;
  const Kinematics& m_at;
  const std::vector<std::string>& m_names;
  std::set<std::string> m_driven, m_tied;
  std::map<std::string, const ForeignBody*> m_bodies;
  ForeignScene& m_scene;
};

}  // namespace

void add_joints(const XmlNode& root, const Model& model, const Groups& groups, const Kinematics& at,
                const std::vector<std::string>& names, ForeignScene& scene) {
  JointAdder(root, model, groups, at, names, scene).add_all(scene.numbers);
}

}  // namespace trivet::mjcf
