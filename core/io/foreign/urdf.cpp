#include "core/io/foreign/urdf.h"

#include <algorithm>
#include <map>
#include <numbers>
#include <set>

#include "core/base/bad_input.h"
#include "core/io/foreign/joint_tree.h"
#include "core/io/foreign/mass_sum.h"
#include "core/io/foreign/numbers.h"
#include "core/io/foreign/primitives.h"
#include "core/io/foreign/uri.h"

namespace trivet {
namespace {

constexpr size_t kMostUrdfLinks = 10'000;
constexpr int kMostInARow = 1000;  // links from the root
// URDF states no friction: what engines take then.
double usual_friction(EngineRules rules) {
  return rules == EngineRules::Mujoco || rules == EngineRules::Gazebo ? 1 : 0.5;
}

double degrees(double radians) { return radians * (180 / std::numbers::pi); }

class UrdfReader {
 public:
  UrdfReader(const std::string& path, const ForeignOptions& options, const MeshSource& meshes)
      : m_path(path), m_options(options), m_meshes(meshes), m_roots(path, options.roots) {
    m_scene.format = "URDF";
    m_scene.friction_rule = FrictionRule::Product;
  }

  ForeignScene read() {
    const XmlNode root = read_xml_tree(m_path, 0, m_options.limits, m_scene.files);
    if (root.tag != "robot") bad_file(m_path, "begins with <%1>; accepted: <robot>", root.tag);
    refuse_xacro();
    collect(root);
    for (const auto& [name, link] : m_links)
      if (!m_joint_of.count(name)) walk(name);
    if (m_num_placed != m_links.size())
      bad_file(m_path, "has joints in a circle; accepted: trees of links");
    m_scene.values_file = joint_values_path(m_path);
    const JointValues values = read_joint_values(m_scene.values_file);
    if (values.empty()) m_scene.values_file.clear();
    add_tree_joints(std::move(m_tree), values, m_scene);
    std::erase_if(m_scene.bodies, [](const ForeignBody& b) { return b.colliders.empty(); });
    return std::move(m_scene);
  }

 private:
  struct JointNode {
    const XmlNode* node;
    std::string parent, child, type;
  };

  XmlPlace place(const XmlNode& node) const { return {m_scene.files, node}; }

  void refuse_xacro() const {
    if (m_scene.files[0].bytes.find("<xacro:") != std::string::npos)
      bad_file(m_path, "is a macro file; expand it first: xacro %1 > robot.urdf", m_path);
  }

  std::string attribute(const XmlNode& node, const char* name) const {
    const std::string* const value = node.find(name);
    if (!value) place(node).refuse(name, "", "a value");
    return *value;
  }

  void collect(const XmlNode& root) {
    for (const XmlNode& node : root.children) {
      if (node.tag == "link" && !m_links.emplace(attribute(node, "name"), &node).second)
        place(node).refuse("name", attribute(node, "name"), "a name that no other link has");
      if (m_links.size() > kMostUrdfLinks)
        bad_file(m_path, "has too many links; accepted: %1", kMostUrdfLinks);
      if (node.tag != "joint") continue;
      const XmlNode *const parent = node.child("parent"), *const child = node.child("child");
      if (!parent || !child) bad_input("%1: has no parent or no child", place(node).text());
      const JointNode joint{&node, attribute(*parent, "link"), attribute(*child, "link"),
                            attribute(node, "type")};
      if (!m_joint_of.emplace(joint.child, joint).second)
        place(*child).refuse("link", joint.child, "a link that no other joint has as its child");
      m_children[joint.parent].push_back(joint.child);
    }
    for (const XmlNode& node : root.children)
      if (node.tag == "transmission")
        for (const XmlNode& one : node.children)
          if (const std::string* const name = one.tag == "joint" ? one.find("name") : nullptr)
            m_driven.insert(*name);
    for (const XmlNode& node : root.children)
      if (const std::string* const link = node.tag == "gazebo" ? node.find("reference") : nullptr)
        if (const XmlNode* const mu = node.child("mu1"))
          m_gazebo_friction[*link] = number_of_gazebo(*mu);
    for (const auto& [child, joint] : m_joint_of)
      for (const std::string& name : {child, joint.parent})
        if (!m_links.count(name)) place(*joint.node).refuse("link", name, "the name of a link");
  }

  // Gazebo reads an attribute, too, and that first.
  double number_of_gazebo(const XmlNode& node) const {
    const std::string* const value = node.find("value");
    return numbers_in(value ? *value : node.text, node.tag, place(node), 1, 1)[0];
  }

  struct Child {
    const JointNode* joint;
    Pose parent;
    int target;  // the body of the parent
    int depth;   // of the parent
  };

  void walk(const std::string& root) {
    // Without recursion: rows of links may be long.
    std::vector<Child> open;
    enter(root, Pose{}, -1, {}, 0, open);
    while (!open.empty()) {
      const Child next = open.back();
      open.pop_back();
      enter_child(next, open);
    }
  }

  // @param target  the body that the link is part of; -1: one of its own.
  void enter(const std::string& name, const Pose& pose, int target, const PosePlace& where,
             int depth, std::vector<Child>& open) {
    if (depth > kMostInARow)
      bad_file(m_path, "has too many links in a row; accepted: %1", kMostInARow);
    if (++m_num_placed > m_links.size()) bad_file(m_path, "has joints in a circle");
    const bool own = target < 0;
    if (own) {
      target = static_cast<int>(m_scene.bodies.size());
      m_scene.bodies.push_back(new_body(name, pose, where));
    }
    add_content(*m_links.at(name), pose, m_scene.bodies[static_cast<size_t>(target)]);
    const std::vector<std::string>& children = m_children[name];
    for (size_t k = children.size(); k-- > 0;)
      open.push_back({&m_joint_of.at(children[k]), pose, target, depth});
  }

  void enter_child(const Child& child, std::vector<Child>& open) {
    const JointNode& joint = *child.joint;
    const Pose at = composed(child.parent, origin_of(*joint.node));
    const Pose its = {at.rotation.normalized(), at.translation};
    const int depth = child.depth + 1;
    if (joint.type == "fixed") return enter(joint.child, its, child.target, {}, depth, open);
    const auto parent = static_cast<size_t>(child.target);
    if (joint.type == "floating" && m_hangs.count(parent) == 0)
      return enter(joint.child, its, -1, place_of(joint.node->child("origin"), child.parent), depth,
                   open);
    m_hangs.insert(m_scene.bodies.size());
    ++m_scene.num_joints;
    m_tree.push_back(tree_joint(joint, its, parent));
    enter(joint.child, its, -1, {}, depth, open);
  }

  TreeJoint tree_joint(const JointNode& joint, const Pose& at, size_t parent) {
    TreeJoint out;
    const std::string* const name = joint.node->find("name");
    out.name = name ? *name : "joint of " + joint.child;
    out.child = m_scene.bodies.size();
    out.parent = parent;
    if (joint.type == "prismatic") out.kind = ForeignJoint::Kind::Slide;
    if (joint.type == "revolute" || joint.type == "continuous")
      out.kind = ForeignJoint::Kind::Hinge;
    if (!out.kind)
      note_once(m_scene.notes, say("the joint \"%1\" is of type %2: its link stays where it is",
                                   out.name, joint.type));
    out.axis = at.rotation.matrix() * axis_of(joint);
    out.anchor = at.translation;
    set_limits(joint, out);
    out.mimic = mimic_of(joint);
    out.driven = m_driven.count(out.name) != 0;
    if (const XmlNode* const dynamics = joint.node->child("dynamics"))
      out.friction = number_in(*dynamics, "friction", 0);
    return out;
  }

  ForeignBody new_body(const std::string& name, const Pose& pose, const PosePlace& where) {
    ForeignBody out;
    out.name = name == "floor" ? "floor (link)" : name;
    const bool root = !m_joint_of.count(name);
    const bool hangs = m_hangs.count(m_scene.bodies.size()) != 0;
    const bool floats = root ? !m_options.fixed_base && name != "world" : !hangs;
    out.fixed = !floats || hangs_joints(name);
    out.is_link = out.fixed && (!root || floats);
    out.pose = pose;
    out.place = where;
    if (out.place.kind == PosePlace::Kind::Nowhere)
      out.place.why_not = Sentence("URDF has no pose for it");
    out.weld = static_cast<int>(m_scene.bodies.size()) + 1;
    return out;
  }

  bool hangs_joints(const std::string& name, int depth = 0) const {
    const auto children = m_children.find(name);
    if (children == m_children.end() || depth > kMostInARow) return false;
    return std::any_of(
        children->second.begin(), children->second.end(), [&](const std::string& child) {
          const std::string& type = m_joint_of.at(child).type;
          return type == "fixed" ? hangs_joints(child, depth + 1) : type != "floating";
        });
  }

  PosePlace place_of(const XmlNode* origin, const Pose& parent) const {
    PosePlace out;
    if (!origin) return out;
    out.kind = PosePlace::Kind::Tag;
    out.file = origin->file;
    out.begin = origin->begin;
    out.world_from_place = parent;
    return out;
  }

  Pose origin_of(const XmlNode& node) const {
    const XmlNode* const origin = node.child("origin");
    if (!origin) return {};
    Pose out;
    if (const std::string* const xyz = origin->find("xyz")) {
      const std::vector<double> n = numbers_in(*xyz, "xyz", place(*origin), 3, 3);
      out.translation = {n[0], n[1], n[2]};
    }
    if (const std::string* const rpy = origin->find("rpy")) {
      const std::vector<double> n = numbers_in(*rpy, "rpy", place(*origin), 3, 3);
      out.rotation =
          (turn_about(Vec3::UnitZ(), degrees(n[2])) * turn_about(Vec3::UnitY(), degrees(n[1])) *
           turn_about(Vec3::UnitX(), degrees(n[0])))
              .normalized();
    }
    return out;
  }

  double number_in(const XmlNode& node, const char* key, double otherwise) const {
    const std::string* const text = node.find(key);
    return text ? numbers_in(*text, key, place(node), 1, 1)[0] : otherwise;
  }

  // Without a file of values joints are at 0, or at the limit next to it.
  void set_limits(const JointNode& joint, TreeJoint& out) const {
    const XmlNode* const limit = joint.node->child("limit");
    if (!limit || joint.type == "continuous") return;
    out.lower = number_in(*limit, "lower", 0), out.upper = number_in(*limit, "upper", 0);
    out.value = std::max(out.lower, std::min(0.0, out.upper));
  }

  std::optional<MimicRule> mimic_of(const JointNode& joint) const {
    const XmlNode* const mimic = joint.node->child("mimic");
    if (!mimic) return std::nullopt;
    return MimicRule{attribute(*mimic, "joint"), number_in(*mimic, "multiplier", 1),
                     number_in(*mimic, "offset", 0)};
  }

  Vec3 axis_of(const JointNode& joint) const {
    const XmlNode* const node = joint.node->child("axis");
    if (!node) return Vec3::UnitX();
    const std::vector<double> n = numbers_in(attribute(*node, "xyz"), "xyz", place(*node), 3, 3);
    const Vec3 axis(n[0], n[1], n[2]);
    return axis.norm() > 1e-14 ? axis.normalized() : Vec3::UnitX();
  }

  void add_content(const XmlNode& link, const Pose& pose, ForeignBody& body) {
    const Pose in_body = composed(inverse(body.pose), pose);
    const double friction = friction_of(link);
    for (const XmlNode& node : link.children)
      if (node.tag == "collision") add_collision(node, in_body, friction, body);
    const XmlNode* const inertial = link.child("inertial");
    if (inertial && (!body.fixed || body.is_link)) add_mass(*inertial, in_body, body);
  }

  // Additions of Bullet and Gazebo to the format: a link's <contact>, and <gazebo> for it.
  double friction_of(const XmlNode& link) const {
    const EngineRules rules = m_options.rules;
    const double usual = usual_friction(rules);
    if (rules == EngineRules::Mujoco) return usual;
    if (rules == EngineRules::Gazebo) {
      const auto given = m_gazebo_friction.find(attribute(link, "name"));
      return given == m_gazebo_friction.end() ? usual : given->second;
    }
    const XmlNode* const contact = link.child("contact");
    const XmlNode* const lateral = contact ? contact->child("lateral_friction") : nullptr;
    return lateral ? number_in(*lateral, "value", usual) : usual;
  }

  void add_mass(const XmlNode& node, const Pose& in_body, ForeignBody& body) {
    const XmlNode* const mass = node.child("mass");
    if (!mass) return;
    const double kg = numbers_in(attribute(*mass, "value"), "value", place(*mass), 1, 1)[0];
    if (!(kg > 0)) return;
    SolidMoments moments;
    if (const XmlNode* const inertia = node.child("inertia")) {
      const auto at = [&](const char* key) {
        const std::string* const text = inertia->find(key);
        return text ? numbers_in(*text, key, place(*inertia), 1, 1)[0] / kg : 0.0;
      };
      const Mat3 m = inertia_of({at("ixx"), at("iyy"), at("izz"), at("ixy"), at("ixz"), at("iyz")});
      moments.spread = 0.5 * m.trace() * Mat3::Identity() - m;
    }
    MassSum sum;
    if (body.mass) sum.add(body.mass->kilograms, moments_of(*body.mass), Pose{});
    sum.add(kg, moments, composed(in_body, origin_of(node)));
    body.mass = sum.total();
  }

  void add_collision(const XmlNode& node, const Pose& in_body, double friction, ForeignBody& body) {
    const XmlNode* const geometry = node.child("geometry");
    if (!geometry || geometry->children.empty()) return;
    const XmlNode& shape = geometry->children.front();
    ForeignCollider collider;
    const std::string* const name = node.find("name");
    collider.name = name ? *name : "collision " + std::to_string(body.colliders.size() + 1);
    collider.pose = composed(in_body, origin_of(node));
    collider.bits.friction = friction;
    try {
      collider.mesh = std::make_shared<const Mesh>(mesh_of(shape));
      if (shape.tag == "sphere") collider.ball_radius = number(shape, "radius");
    } catch (const Error& error) {
      note_once(m_scene.unread, say("%1: %2", place(shape).text(), error.sentence()));
      return;
    }
    if (collider.mesh->triangles.empty())
      note_once(m_scene.unread, say("%1: is not read", place(shape).text()));
    else
      count_faces(*collider.mesh, m_scene), body.colliders.push_back(std::move(collider));
  }

  double number(const XmlNode& shape, const char* key) const {
    return numbers_in(attribute(shape, key), key, place(shape), 1, 1)[0];
  }

  Mesh mesh_of(const XmlNode& shape) const {
    if (shape.tag == "box") {
      const std::vector<double> n =
          numbers_in(attribute(shape, "size"), "size", place(shape), 3, 3);
      return box_mesh(0.5 * Vec3(n[0], n[1], n[2]));
    }
    if (shape.tag == "sphere") return ball_mesh(number(shape, "radius"));
    if (shape.tag == "cylinder")
      return cylinder_mesh(number(shape, "radius"), number(shape, "length") / 2);
    if (shape.tag == "capsule")
      return capsule_mesh(number(shape, "radius"), number(shape, "length") / 2);
    return shape.tag == "mesh" ? file_mesh(shape) : Mesh{};
  }

  Mesh file_mesh(const XmlNode& shape) const {
    Mesh mesh =
        mesh_in_metres(m_meshes(path_of_uri(attribute(shape, "filename"), m_path, m_roots)));
    if (const std::string* const text = shape.find("scale")) {
      const std::vector<double> n = numbers_in(*text, "scale", place(shape), 3, 3);
      scale({n[0], n[1], n[2]}, mesh);
    }
    return m_options.true_meshes ? mesh : hull_mesh(mesh.vertices);
  }

  std::string m_path;
  const ForeignOptions& m_options;
  const MeshSource& m_meshes;
  SceneRoots m_roots;
  ForeignScene m_scene;
  std::map<std::string, const XmlNode*> m_links;
  std::map<std::string, JointNode> m_joint_of;  // by child
  std::map<std::string, std::vector<std::string>> m_children;
  std::map<std::string, double> m_gazebo_friction;  // of links
  std::set<std::string> m_driven;                   // joints with a transmission
  std::set<size_t> m_hangs;                         // bodies that hang in joints
  std::vector<TreeJoint> m_tree;
  size_t m_num_placed = 0;
};

}  // namespace

ForeignScene read_urdf(const std::string& path, const ForeignOptions& options,
                       const MeshSource& meshes) {
  return UrdfReader(path, options, meshes).read();
}

}  // namespace trivet
