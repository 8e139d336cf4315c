// Joints, filtered pairs and collision groups of USD.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "core/io/foreign/joint_tree.h"
#include "core/io/foreign/usd/usda_bodies.h"
#include "core/io/foreign/usd/usda_shapes.h"
#include "core/motion/motion.h"

namespace trivet {
namespace {

constexpr double kUsdaRadians = std::numbers::pi / 180;
constexpr double kNoValue = 1e-12;  // metres or radians
constexpr size_t kMostFilteredPairs = 1'000'000;

/// A joint and what it connects; nothing: the world.
struct JointEnds {
  const UsdaPrim* prim;
  std::optional<size_t> body[2];
  Pose frame[2];  // world

  bool is_fixed() const { return prim->type == "PhysicsFixedJoint"; }
};

class JointConnector {
 public:
  JointConnector(UsdaBodies& all, ForeignScene& scene)
      : m_all(all), m_scene(scene), m_root(scene.bodies.size()) {
    for (size_t i = 0; i < m_root.size(); ++i) m_root[i] = i;
  }

  void connect() {
    for (const UsdaPrim* prim : m_all.joints) add_ends(*prim);
    std::set<size_t> held;  // pieces that more than fixed joints between free bodies hold
    for (const JointEnds& joint : m_joints)
      if (!joint.is_fixed() || !is_free(joint.body[0]) || !is_free(joint.body[1]))
        for (const auto& body : joint.body)
          if (is_free(body)) held.insert(root_of(*body));
    std::vector<TreeJoint> tree;
    for (const JointEnds& joint : m_joints) {
      const size_t free_one = is_free(joint.body[1]) ? *joint.body[1] : *joint.body[0];
      if (held.count(root_of(free_one)))
        tree.push_back(tree_joint(joint));
      else
        m_merged.insert(root_of(free_one));
    }
    for (size_t i = 0; i < m_scene.bodies.size(); ++i) {
      if (!is_free(i)) continue;
      if (m_merged.count(root_of(i)) && root_of(i) != i) merge(root_of(i), i);
      if (held.count(root_of(i))) m_links.push_back(i);
    }
    for (auto& [path, body] : m_all.body_of_path)
      if (m_merged.count(root_of(body))) body = root_of(body);
    for (const size_t i : m_links) m_scene.bodies[i].fixed = m_scene.bodies[i].is_link = true;
    add_tree_joints(std::move(tree), {}, m_scene);
  }

 private:
  bool is_free(const std::optional<size_t>& body) const {
    return body && !m_scene.bodies[*body].fixed;
  }

  // The first of the bodies that are connected.
  size_t root_of(size_t body) {
    while (m_root[body] != body) body = m_root[body] = m_root[m_root[body]];
    return body;
  }

  void add_ends(const UsdaPrim& prim) {
    if (!usda_flag(prim, "physics:jointEnabled", true)) return;
    JointEnds joint{&prim, {}, {}};
    for (int k = 0; k < 2; ++k) joint.frame[k] = end_of(prim, k, joint.body[k]);
    if (!is_free(joint.body[0]) && !is_free(joint.body[1])) return;
    if (joint.body[0] == joint.body[1]) return;
    if (is_free(joint.body[0]) && is_free(joint.body[1])) {
      const auto [low, high] = std::minmax({root_of(*joint.body[0]), root_of(*joint.body[1])});
      m_root[high] = low;
    }
    m_joints.push_back(joint);
    if (!joint.is_fixed()) ++m_scene.num_joints;
  }

  // The joint's frame at one of its ends.
  Pose end_of(const UsdaPrim& prim, int k, std::optional<size_t>& body) const {
    const std::string number = std::to_string(k);
    const std::vector<std::string> targets = prim.targets("physics:body" + number);
    UsdaFrame frame = m_all.units.root;
    if (!targets.empty()) {
      frame = m_all.frame_at(targets[0]);
      const std::vector<size_t> bodies = m_all.bodies_at(targets[0]);
      if (bodies.size() == 1) body = bodies[0];
    }
    const Vec3 at = usda_vector(prim, "physics:localPos" + number).value_or(Vec3::Zero());
    const Rotation turn = usda_turn(prim, "physics:localRot" + number).value_or(Rotation{});
    return {(frame.pose.rotation * turn).normalized(), frame.apply(at)};
  }

  TreeJoint tree_joint(const JointEnds& joint) const {
    const UsdaPrim& prim = *joint.prim;
    TreeJoint out;
    out.name = usda_name(prim);
    // The second body hangs in the first, unless only the first can move.
    const bool swapped = !is_free(joint.body[1]);
    out.child = swapped ? *joint.body[0] : *joint.body[1];
    out.parent = swapped ? joint.body[1] : joint.body[0];
    if (joint.is_fixed()) return out;
    if (prim.type == "PhysicsPrismaticJoint") out.kind = ForeignJoint::Kind::Slide;
    if (prim.type == "PhysicsRevoluteJoint") out.kind = ForeignJoint::Kind::Hinge;
    if (!out.kind)
      note_once(m_scene.notes, say("the joint \"%1\" is of type %2: its link stays where it is",
                                   out.name, prim.type));
    const std::string axis = usda_word(prim.find("physics:axis"));
    const Vec3 along = Vec3::Unit(axis == "Y" ? 1 : axis == "Z" ? 2 : 0);
    out.axis = (joint.frame[0].rotation.matrix() * along).normalized();
    out.anchor = joint.frame[0].translation;
    set_value(joint, along, out);
    if (swapped) out.axis = -out.axis;
    out.driven = is_driven(prim);
    return out;
  }

  void set_value(const JointEnds& joint, const Vec3& along, TreeJoint& out) const {
    const bool turns = out.kind == ForeignJoint::Kind::Hinge;
    const double unit = turns ? kUsdaRadians : m_all.units.metres;
    if (const auto lower = usda_number(*joint.prim, "physics:lowerLimit"))
      out.lower = unit * *lower;
    if (const auto upper = usda_number(*joint.prim, "physics:upperLimit"))
      out.upper = unit * *upper;
    const Vec3 way = joint.frame[1].translation - joint.frame[0].translation;
    out.value = turns ? turn_about_axis(joint, along) : out.axis.dot(way);
    if (std::abs(out.value) < kNoValue) out.value = 0;  // rounding of the frames
    out.stands_at = out.value;
  }

  // Radians from the first end's frame to the second's.
  static double turn_about_axis(const JointEnds& joint, const Vec3& along) {
    const Rotation turn =
        inverse({joint.frame[0].rotation, Vec3::Zero()}).rotation * joint.frame[1].rotation;
    const double sine = along.dot(Vec3(turn.x, turn.y, turn.z));
    if (std::abs(turn.w) < 1e-12) return std::numbers::pi;
    return kUsdaRadians * turned_deg(sine / turn.w);
  }

  static bool is_driven(const UsdaPrim& prim) {
    for (const char* kind : {"linear", "angular"}) {
      const std::string name(kind);
      if (prim.has_api("PhysicsDriveAPI:" + name) &&
          usda_number(prim, "drive:" + name + ":physics:stiffness").value_or(0) > 0)
        return true;
    }
    return false;
  }

  // Both are one body: the other's colliders, mass and place become the first one's.
  void merge(size_t into, size_t other) {
    ForeignBody &a = m_scene.bodies[into], &b = m_scene.bodies[other];
    const Pose in_body = composed(inverse(a.pose), b.pose);
    for (ForeignCollider& collider : b.colliders) {
      collider.pose = composed(in_body, collider.pose);
      a.colliders.push_back(std::move(collider));
    }
    b.colliders.clear();
    if (a.mass && b.mass) {
      MassSum sum;
      sum.add(a.mass->kilograms, moments_of(*a.mass), Pose{});
      sum.add(b.mass->kilograms, moments_of(*b.mass), in_body);
      a.mass = sum.total();
    } else {
      a.mass.reset();
    }
    for (UsdaPlace& place : m_all.places[other]) {
      place.in_body = composed(in_body, place.in_body);
      m_all.places[into].push_back(std::move(place));
    }
    if (b.place.kind == PosePlace::Kind::Nowhere) a.place = b.place;
  }

  UsdaBodies& m_all;
  ForeignScene& m_scene;
  std::vector<size_t> m_root;  // by body
  std::vector<JointEnds> m_joints;
  std::set<size_t> m_merged;
  std::vector<size_t> m_links;
};

class PairFilter {
 public:
  PairFilter(const UsdaBodies& all, ForeignScene& scene) : m_all(all), m_scene(scene) {}

  void add_all() {
    for (const UsdaPrim* prim : m_all.filters)
      for (const std::string& target : prim->targets("physics:filteredPairs"))
        keep_apart(whole_bodies(prim->path), whole_bodies(target));
    for (const UsdaPrim* prim : m_all.groups) {
      if (usda_flag(*prim, "physics:invertFilteredGroups", false))
        note_once(m_scene.unread, say("%1: inverted groups are not read", prim->path));
      const std::vector<size_t> mine = members(*prim);
      for (const std::string& target : prim->targets("physics:filteredGroups"))
        if (const UsdaPrim* const other = m_all.prim_at(target)) keep_apart(mine, members(*other));
    }
  }

 private:
  // Bodies pass each other as wholes: a filter of one collider among several is named.
  std::vector<size_t> whole_bodies(const std::string& path) {
    const std::vector<size_t> out = m_all.bodies_at(path);
    if (out.size() == 1 && !m_all.body_of_path.count(path) &&
        m_scene.bodies[out[0]].colliders.size() > 1) {
      note_once(m_scene.unread, say("%1: filters of single colliders are not read", path));
      return {};
    }
    return out;
  }

  std::vector<size_t> members(const UsdaPrim& group) {
    std::set<size_t> out;
    for (const std::string& path : group.targets("collection:colliders:includes"))
      for (const size_t body : whole_bodies(path)) out.insert(body);
    for (const std::string& path : group.targets("collection:colliders:excludes"))
      for (const size_t body : whole_bodies(path)) out.erase(body);
    return {out.begin(), out.end()};
  }

  void keep_apart(const std::vector<size_t>& a, const std::vector<size_t>& b) {
    for (const size_t i : a)
      for (const size_t j : b) {
        if (i == j || m_scene.excluded.size() >= kMostFilteredPairs) continue;
        if (m_pairs.insert(std::minmax(i, j)).second)
          m_scene.excluded.emplace_back(m_scene.bodies[i].name, m_scene.bodies[j].name);
      }
    if (m_scene.excluded.size() >= kMostFilteredPairs)
      note_once(m_scene.unread, Sentence("filtered pairs beyond a million are not read"));
  }

  const UsdaBodies& m_all;
  ForeignScene& m_scene;
  std::set<std::pair<size_t, size_t>> m_pairs;
};

}  // namespace

void connect_usda_bodies(UsdaBodies& all, ForeignScene& scene) {
  JointConnector(all, scene).connect();
  PairFilter(all, scene).add_all();
}

}  // namespace trivet
