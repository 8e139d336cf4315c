#include "core/io/foreign/joint_tree.h"

#include <algorithm>
#include <map>
#include <numbers>
#include <set>

#include "core/base/bad_input.h"
#include "core/io/foreign/joint_loads.h"

namespace trivet {
namespace {

constexpr int kMostMimicsInARow = 32;
constexpr size_t kMostMoves = 1'000'000;  // of all joints together
constexpr double kDegrees = 180 / std::numbers::pi;

bool is_hinge(const TreeJoint& joint) { return joint.kind == ForeignJoint::Kind::Hinge; }

// By what a value moves the link from zero; in the world. @param value  metres or radians.
Pose displacement(const TreeJoint& joint, double value) {
  // A turn about an axis beside the origin is a turn and a shift.
  if (!is_hinge(joint)) return {{}, value * joint.axis};
  const Rotation turn = turn_about(joint.axis, value * kDegrees).normalized();
  return {turn, joint.anchor - turn.matrix() * joint.anchor};
}

class TreeOfJoints {
 public:
  TreeOfJoints(std::vector<TreeJoint> joints, const JointValues& given, ForeignScene& scene)
      : m_joints(std::move(joints)), m_given(given), m_scene(scene), m_held(m_joints.size()) {
    for (size_t j = 0; j < m_joints.size(); ++j) {
      m_named.emplace(m_joints[j].name, j);
      m_of_child[m_joints[j].child].push_back(j);
      if (m_joints[j].lower > m_joints[j].upper)  // engines then take it as unlimited
        m_joints[j].lower = -kInfinity, m_joints[j].upper = kInfinity;
    }
  }

  void add_all() {
    check_given();
    hang_bodies();
    for (const size_t j : m_order) move_to_value(j);
    mark_bases();
    hold_what_mimics();
    for (size_t j = 0; j < m_joints.size(); ++j)
      if (m_joints[j].kind) add(j);
  }

 private:
  void check_given() const {
    for (const auto& [name, value] : m_given) {
      const auto it = m_named.find(name);
      if (it == m_named.end() || !m_joints[it->second].kind)
        bad_file(m_scene.values_file, "\"%1\" is no slide or hinge of the scene", name);
      if (m_joints[it->second].mimic)
        bad_file(m_scene.values_file, "\"%1\" has no value of its own: it follows \"%2\"", name,
                 m_joints[it->second].mimic->joint);
    }
  }

  // From the bodies that hang in nothing downwards; what is not reached is in a circle.
  void hang_bodies() {
    // A body that hangs in several joints closes a circle: none of them can be moved alone.
    for (const auto& [child, of_it] : m_of_child)
      if (of_it.size() > 1)
        for (const size_t j : of_it) hold(j);
    std::map<size_t, std::vector<size_t>> below;  // joints, by parent
    for (const auto& [child, of_it] : m_of_child)
      if (of_it.size() == 1 && m_joints[of_it[0]].parent)
        below[*m_joints[of_it[0]].parent].push_back(of_it[0]);
    // The order begins with bodies that hang in nothing, or in the world.
    std::vector<size_t> bodies;
    for (size_t b = 0; b < m_scene.bodies.size(); ++b) {
      const auto it = m_of_child.find(b);
      if (it != m_of_child.end() && it->second.size() == 1 && m_joints[it->second[0]].parent)
        continue;
      bodies.push_back(b);
      if (it != m_of_child.end() && it->second.size() == 1) m_order.push_back(it->second[0]);
    }
    // The list grows while it is walked: joints come after those above them.
    for (size_t i = 0; i < bodies.size(); ++i)
      for (const size_t j : below[bodies[i]]) {
        m_order.push_back(j);
        bodies.push_back(m_joints[j].child);
        m_scene.bodies[m_joints[j].child].parent_weld = m_scene.bodies[bodies[i]].weld;
      }
    const std::set<size_t> reached(m_order.begin(), m_order.end());
    for (size_t j = 0; j < m_joints.size(); ++j)
      if (!reached.count(j)) hold(j);
    for (const size_t j : m_order)
      if (m_joints[j].parent) m_below[*m_joints[j].parent].push_back(j);
  }

  // With a closed chain it is not known what hangs in what.
  void mark_bases() {
    if (m_order.size() != m_joints.size()) return;
    for (size_t b = 0; b < m_scene.bodies.size(); ++b)
      m_scene.bodies[b].is_base = m_scene.bodies[b].is_link && !m_of_child.count(b);
  }

  void hold(size_t j) { m_held[j] = Sentence("it closes a chain of joints"); }

  // Bodies that go with this one, itself first; and the joints between them.
  std::vector<size_t> subtree(size_t body, std::vector<size_t>* joints = nullptr) const {
    std::vector<size_t> out = {body};
    for (size_t i = 0; i < out.size(); ++i)
      if (const auto it = m_below.find(out[i]); it != m_below.end())
        for (const size_t j : it->second) {
          out.push_back(m_joints[j].child);
          if (joints) joints->push_back(j);
        }
    return out;
  }

  double value_of(size_t j, int depth = 0) const {
    const TreeJoint& joint = m_joints[j];
    // The value of a joint that mimics follows from the other's; circles of them end by the bound.
    if (joint.mimic && depth < kMostMimicsInARow)
      if (const auto other = m_named.find(joint.mimic->joint); other != m_named.end())
        return joint.mimic->multiplier * value_of(other->second, depth + 1) + joint.mimic->offset;
    const auto given = m_given.find(joint.name);
    return given == m_given.end() ? joint.value : given->second;
  }

  void move_to_value(size_t j) {
    TreeJoint& joint = m_joints[j];
    if (!joint.kind || !m_held[j].empty()) return;
    joint.value = value_of(j);
    if (joint.value == joint.stands_at) return;
    const Pose by = displacement(joint, joint.value - joint.stands_at);
    // All that hangs in the link goes with it, joints included: these are in the world.
    std::vector<size_t> joints;
    for (const size_t b : subtree(joint.child, &joints)) {
      const Pose pose = composed(by, m_scene.bodies[b].pose);
      m_scene.bodies[b].pose = {pose.rotation.normalized(), pose.translation};
    }
    const Mat3 turn = by.rotation.matrix();
    for (const size_t below : joints) {
      m_joints[below].axis = (turn * m_joints[below].axis).normalized();
      m_joints[below].anchor = by.translation + turn * m_joints[below].anchor;
    }
  }

  void hold_what_mimics() {
    for (size_t j = 0; j < m_joints.size(); ++j) {
      // A joint that mimics, and the one that it follows, would have to move together.
      if (!m_joints[j].mimic) continue;
      m_held[j] = say("it follows \"%1\"", m_joints[j].mimic->joint);
      const auto other = m_named.find(m_joints[j].mimic->joint);
      if (other != m_named.end() && m_held[other->second].empty())
        m_held[other->second] = say("\"%1\" follows it", m_joints[j].name);
    }
  }

  void add(size_t j) {
    const TreeJoint& joint = m_joints[j];
    // The scene has degrees where the file has radians.
    const double unit = is_hinge(joint) ? kDegrees : 1;
    ForeignJoint out;
    out.kind = *joint.kind, out.name = joint.name;
    out.axis = joint.axis, out.anchor = joint.anchor;
    out.value = unit * joint.value;
    out.lower = unit * joint.lower, out.upper = unit * joint.upper;
    out.friction = joint.friction, out.held = m_held[j];
    // Links without a collider are no objects: nothing would be seen to move.
    std::vector<const ForeignBody*> bodies;
    for (const size_t b : subtree(joint.child)) {
      bodies.push_back(&m_scene.bodies[b]);
      if (!bodies.back()->colliders.empty()) out.moves.push_back(bodies.back()->name);
    }
    m_num_moves += out.moves.size();
    if (m_num_moves > kMostMoves)
      bad_file(m_scene.files.at(0).path, "has too many links in joints of joints");
    if (out.moves.empty()) return;
    if (const auto frame = frame_of(j)) out.frames.push_back(m_scene.bodies[*frame].name);
    if (!joint.driven && !joint.mimic) note_if_gravity_moves(out, bodies, m_scene.notes);
    out.number = m_scene.joints.size();
    m_scene.joints.push_back(std::move(out));
  }

  // The next body upwards that collides.
  std::optional<size_t> frame_of(size_t j) const {
    std::optional<size_t> body = m_joints[j].parent;
    for (size_t steps = 0; body && steps < m_joints.size(); ++steps) {
      if (!m_scene.bodies[*body].colliders.empty()) return body;
      const auto above = m_of_child.find(*body);
      body = above == m_of_child.end() ? std::nullopt : m_joints[above->second[0]].parent;
    }
    return std::nullopt;
  }

  std::vector<TreeJoint> m_joints;
  const JointValues& m_given;
  ForeignScene& m_scene;
  std::vector<Sentence> m_held;  // by joint
  std::map<std::string, size_t> m_named;
  std::map<size_t, std::vector<size_t>> m_of_child, m_below;  // joints, by body
  std::vector<size_t> m_order;                                // joints, those above first
  size_t m_num_moves = 0;
};

}  // namespace

void add_tree_joints(std::vector<TreeJoint> joints, const JointValues& values,
                     ForeignScene& scene) {
  TreeOfJoints(std::move(joints), values, scene).add_all();
}

}  // namespace trivet
