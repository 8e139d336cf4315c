#include "core/io/foreign/mjcf/read_mjcf.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>

#include "core/base/bad_input.h"
#include "core/io/foreign/mjcf/includes.h"
#include "core/io/foreign/mjcf/model.h"
#include "core/io/foreign/mjcf/qpos_array.h"

namespace trivet {
namespace {

using mjcf::Assets;
using mjcf::Body;
using mjcf::Groups;
using mjcf::Joint;
using mjcf::Qpos;
using mjcf::Settings;

/// The state that the poses are of: a keyframe, an array in a file, or the reference configuration.
struct Key {
  const XmlNode* node = nullptr;  // null: no keyframe
  std::string name;
  Qpos qpos;  // empty: the reference configuration
  const Qpos* numbers() const { return qpos.empty() ? nullptr : &qpos; }
};

std::vector<const XmlNode*> keys_of(const XmlNode& root) {
  std::vector<const XmlNode*> out;
  for (const XmlNode& section : root.children)
    if (section.tag == "keyframe")
      for (const XmlNode& key : section.children)
        if (key.tag == "key") out.push_back(&key);
  return out;
}

std::string name_of_key(const std::vector<const XmlNode*>& keys, size_t i) {
  const std::string* const name = keys[i]->find("name");
  return name ? *name : "key " + std::to_string(i);
}

Key key_of(const XmlNode& root, const mjcf::Model& model, const ForeignOptions& options,
           ForeignScene& scene) {
  if (options.key == "none") return {};
  if (options.key && is_qpos_array(*options.key)) {
    scene.numbers_file = *options.key;
    return {nullptr, *options.key, read_qpos_array(*options.key, model.num_numbers)};
  }
  const std::vector<const XmlNode*> keys = keys_of(root);
  std::string known;
  for (size_t i = 0; i < keys.size(); ++i) {
    const std::string name = name_of_key(keys, i);
    known += (i ? ", " : "") + name;
    if (options.key ? *options.key != name : i > 0) continue;
    const std::string* const qpos = keys[i]->find("qpos");
    if (!qpos) return {};
    const XmlPlace place{scene.files, *keys[i]};
    return {keys[i], name, numbers_in(*qpos, "qpos", place, model.num_numbers, model.num_numbers)};
  }
  if (options.key)
    bad_file(scene.files[0].path, "has no keyframe \"%1\"; accepted: %2", *options.key,
             known.empty() ? std::string("none, it has no keyframes") : known);
  return {};
}

class Assembler {
 public:
  Assembler(const XmlNode& root, const Settings& settings, const mjcf::Model& model, const Key& key,
            ForeignScene& scene)
      : m_root(root),
        m_settings(settings),
        m_model(model),
        m_key(key),
        m_at(mjcf::kinematics_of(model, key.numbers())),
        m_groups(model),
        m_scene(scene) {}

  void assemble() {
    std::map<int, size_t> index_of;  // of groups that move
    for (size_t i = 0; i < m_model.bodies.size(); ++i) {
      const int weld = m_groups.weld(i);
      m_body_named.emplace(m_model.bodies[i].name, i);
      if (i == 0) {
        m_name.push_back("");
        add_world_geoms();
        continue;
      }
      m_name.push_back(m_unique(name_of(i)));
      const auto known = weld == 0 ? index_of.end() : index_of.find(weld);
      if (known == index_of.end()) {
        if (weld != 0) index_of[weld] = m_scene.bodies.size();
        m_scene.bodies.push_back(new_body(i, weld));
      }
      const size_t target = known == index_of.end() ? m_scene.bodies.size() - 1 : known->second;
      add_content(i, m_scene.bodies[target]);
    }
    // Bodies may be empty: no colliders, and nothing to judge.
    std::erase_if(m_scene.bodies, [](const ForeignBody& b) { return b.colliders.empty(); });
    scale_masses();
    for (const Body& body : m_model.bodies)
      for (const Joint& joint : body.joints) m_scene.num_joints += joint.kind != Joint::Kind::Free;
    read_excludes();
    note_numbers();
    mjcf::add_joints(m_root, m_model, m_groups, m_at, m_name, m_scene);
  }

 private:
  std::string name_of(size_t i) const {
    const std::string& name = m_model.bodies[i].name;
    return name.empty() ? "body " + std::to_string(i) : name;
  }

  // A geom that belongs to no body is a body: a table, a wall, the floor.
  void add_world_geoms() {
    for (const mjcf::Geom& geom : m_model.bodies[0].geoms) {
      ForeignBody body;
      body.name = m_unique(geom.collider.name);
      body.fixed = true;
      body.colliders = {geom.collider};
      m_scene.bodies.push_back(std::move(body));
    }
  }

  ForeignBody new_body(size_t i, int weld) const {
    ForeignBody out;
    out.name = m_name[i];
    out.fixed = !m_groups.is_free(weld);
    out.is_link = weld != 0 && out.fixed;
    out.is_base = out.is_link && m_groups.is_base(weld);
    out.pose = m_at.bodies[i];
    out.weld = weld;
    out.parent_weld = m_groups.parent_weld(weld) == 0 ? -1 : m_groups.parent_weld(weld);
    if (!out.fixed) out.place = place_of(i);
    return out;
  }

  PosePlace place_of(size_t i) const {
    const Body& body = m_model.bodies[i];
    PosePlace out;
    out.number = body.joints[0].first_number;
    if (!m_key.node && body.is_copy) {
      out.why_not = Sentence(
          "its tag makes several bodies; accepted: an output NAME.npy, which "
          "has the numbers of all joints (qpos)");
      return out;
    }
    const XmlNode& node = m_key.node ? *m_key.node : *body.node;
    out.kind = m_key.node ? PosePlace::Kind::Key : PosePlace::Kind::Tag;
    out.file = node.file;
    out.begin = node.begin;
    if (!m_key.node)
      out.world_from_place = composed(m_at.bodies[static_cast<size_t>(body.parent)], body.frame);
    return out;
  }

  void add_content(size_t i, ForeignBody& target) {
    const Body& body = m_model.bodies[i];
    const Pose in_target =
        target.name == m_name[i] ? Pose{} : composed(inverse(target.pose), m_at.bodies[i]);
    for (const mjcf::Geom& geom : body.geoms) {
      if (geom.is_plane && m_groups.weld(i) != 0) {
        note_once(m_scene.unread, say("the plane of \"%1\", which moves, is not read", m_name[i]));
        continue;
      }
      ForeignCollider collider = geom.collider;
      collider.pose = composed(in_target, collider.pose);
      target.colliders.push_back(std::move(collider));
    }
    if (const auto mass = mjcf::mass_of(body, m_settings)) add_mass(*mass, in_target, target);
  }

  // A group weighs what its bodies weigh.
  void add_mass(const GivenMass& mass, const Pose& in_target, ForeignBody& target) {
    if (!target.mass && in_target.translation.isZero(0) && in_target.rotation.w == 1) {
      target.mass = mass;
      return;
    }
    MassSum sum;
    if (target.mass) sum.add(target.mass->kilograms, moments_of(*target.mass), Pose{});
    sum.add(mass.kilograms, moments_of(mass), in_target);
    target.mass = sum.total();
  }

  void scale_masses() {
    const double total = m_settings.compiler_number("settotalmass", -1);
    if (!(total > 0)) return;
    double now = 0;
    for (size_t i = 1; i < m_model.bodies.size(); ++i)
      if (const auto mass = mjcf::mass_of(m_model.bodies[i], m_settings)) now += mass->kilograms;
    if (!(now > 0)) return;
    for (ForeignBody& body : m_scene.bodies)
      if (body.mass) {
        body.mass->kilograms *= total / now;
        if (body.mass->inertia) *body.mass->inertia *= total / now;
      }
  }

  // A keyframe has numbers for all joints.
  void note_numbers() {
    m_scene.numbers = m_key.numbers() ? m_key.qpos : mjcf::reference_numbers(m_model);
    if (m_key.node) return;
    const auto is_copy = [](const Body& body) { return body.is_copy; };
    if (!keys_of(m_root).empty())
      m_scene.why_no_key = Sentence("its first keyframe has no positions");
    else if (std::any_of(m_model.bodies.begin(), m_model.bodies.end(), is_copy))
      m_scene.why_no_key = Sentence("MuJoCo reads no keyframe where a tag makes several bodies");
    else
      m_scene.new_key = m_root.end;
  }

  void read_excludes() {
    for (const XmlNode& section : m_root.children) {
      if (section.tag == "contact") read_contacts(section);
      if (section.tag == "equality" && !section.children.empty())
        note_once(m_scene.notes, "constraints (equality) are not read: bodies stand as they are");
      if (section.tag == "deformable" || section.tag == "extension")
        note_once(m_scene.unread, say("%1: is not read", XmlPlace{m_scene.files, section}.text()));
    }
  }

  void read_contacts(const XmlNode& section) {
    for (const XmlNode& node : section.children) {
      const std::string *const a = node.find("body1"), *const b = node.find("body2");
      if (node.tag == "exclude" && a && b)
        m_scene.excluded.emplace_back(group_of(*a), group_of(*b));
      else if (node.tag == "pair")
        note_once(m_scene.notes, "pairs (contact) are judged by the friction of their geoms");
    }
  }

  // Name of the body in the scene that has the body of this name in it.
  std::string group_of(const std::string& name) const {
    const auto found = m_body_named.find(name);
    if (found == m_body_named.end()) return name;
    const size_t i = found->second;
    return m_groups.weld(i) == 0 ? m_name[i] : m_name[static_cast<size_t>(m_groups.weld(i))];
  }

  const XmlNode& m_root;
  const Settings& m_settings;
  const mjcf::Model& m_model;
  const Key& m_key;
  mjcf::Kinematics m_at;
  Groups m_groups;
  ForeignScene& m_scene;
  UniqueNames m_unique;
  std::map<std::string, size_t> m_body_named;  // the first of a name
  std::vector<std::string> m_name;
};

void note_options(const XmlNode& root, ForeignScene& scene) {
  for (const XmlNode& node : root.children) {
    if (node.tag != "option") continue;
    const std::string* const gravity = node.find("gravity");
    if (!gravity) continue;
    const Qpos g = numbers_in(*gravity, "gravity", {scene.files, node}, 3, 3);
    if (g[0] != 0 || g[1] != 0 || !(g[2] < 0))
      note_once(scene.unread, say("gravity is \"%1\"; judged as if it acted along -z", *gravity));
  }
}

}  // namespace

ForeignScene read_mjcf(const std::string& path, const ForeignOptions& options,
                       const MeshSource& meshes) {
  ForeignScene scene;
  scene.format = "MJCF";
  scene.friction_rule = FrictionRule::Larger;
  const SceneRoots roots(path, options.roots);
  const XmlNode root = mjcf::read_with_includes(path, options.limits, roots, scene.files);
  if (root.tag != "mujoco") bad_file(path, "begins with <%1>; accepted: <mujoco>", root.tag);
  const Settings settings(root, scene.files);
  if (settings.compiler("coordinate", "local") == "global")
    bad_file(path, "has global coordinates, which MuJoCo no longer reads");
  Assets assets(root, settings, meshes, roots);
  const mjcf::Model model = mjcf::read_bodies(root, settings, assets, options, scene);
  const Key key = key_of(root, model, options, scene);
  scene.key = key.name;
  if (key.node) scene.key_file = key.node->file, scene.key_begin = key.node->begin;
  Assembler(root, settings, model, key, scene).assemble();
  note_options(root, scene);
  return scene;
}

}  // namespace trivet
