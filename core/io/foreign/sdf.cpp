#include "core/io/foreign/sdf.h"

#include <filesystem>
#include <map>

#include "core/base/bad_input.h"
#include "core/io/foreign/numbers.h"
#include "core/io/foreign/sdf_joints.h"
#include "core/io/foreign/sdf_links.h"
#include "core/io/foreign/sdf_text.h"
#include "core/io/foreign/uri.h"

namespace trivet {
namespace {

constexpr int kMostNestedModels = 64;
constexpr size_t kMostSdfFiles = 2000, kMostFrames = 20'000'000, kMostLinks = 5000;
constexpr int kMostFramesInARow = 1000;

/// Names that poses may be relative to, inside a model or a world.
struct Frame {
  const XmlNode* node = nullptr;  // null: the origin of the scope
  std::string base;               // that its pose counts from; empty: the origin
  Pose extra;                     // of the model that an <include> brings, where it gives none
  int state = 0;                  // 0: not computed, 1: on the way, 2: done
  Pose pose;                      // in the scope
};

class SdfReader {
 public:
  SdfReader(const std::string& path, const ForeignOptions& options, const MeshSource& meshes)
      : m_options(options), m_allowed(path, options.roots), m_meshes{meshes, m_allowed} {
    m_scene.format = "SDF";
    m_scene.friction_rule = FrictionRule::Smaller;
    m_roots.push_back(
        std::make_unique<XmlNode>(read_xml_tree(path, 0, options.limits, m_scene.files)));
  }

  ForeignScene read() {
    const XmlNode& root = *m_roots[0];
    if (root.tag != "sdf")
      bad_file(m_scene.files[0].path, "begins with <%1>; accepted: <sdf>", root.tag);
    for (const XmlNode& node : root.children) {
      if (node.tag == "world") read_world(node);
      if (node.tag == "model") read_model_in(node, Pose{}, "", {&node, Pose{}, {}}, 0);
    }
    m_scene.values_file = joint_values_path(m_scene.files[0].path);
    const JointValues values = read_joint_values(m_scene.values_file);
    if (values.empty()) m_scene.values_file.clear();
    add_tree_joints(std::move(m_joints), values, m_scene);
    std::erase_if(m_scene.bodies, [](const ForeignBody& b) { return b.colliders.empty(); });
    return std::move(m_scene);
  }

 private:
  using Scope = std::map<std::string, Frame>;
  /// Where the pose of a model stands.
  struct Place {
    const XmlNode* node = nullptr;  // the element that has or gets <pose>
    Pose base;                      // world pose that it counts from
    Sentence why_not;
  };

  XmlPlace place(const XmlNode& node) const { return {m_scene.files, node}; }

  Pose own_pose(const XmlNode& node) const { return sdf_pose(m_scene.files, node); }

  std::string relative_to(const XmlNode& node) const {
    const XmlNode* const pose = node.child("pose");
    const std::string* const name = pose ? pose->find("relative_to") : nullptr;
    return name ? *name : "";
  }

  // All that poses of this scope may name, by where each is defined.
  Scope scope_of(const XmlNode& owner, const char* origin) {
    m_num_frames += owner.children.size();
    if (m_num_frames > kMostFrames) bad_input("%1: too many frames", place(owner).text());
    Scope scope;
    scope[origin].state = 2;
    for (const XmlNode& node : owner.children) {
      const bool frame = node.tag == "frame";
      if (!frame && node.tag != "link" && node.tag != "model" && node.tag != "include" &&
          node.tag != "joint")
        continue;
      Frame entry;
      entry.node = &node;
      entry.base = relative_to(node);
      if (frame && entry.base.empty())
        if (const std::string* const attached = node.find("attached_to")) entry.base = *attached;
      if (node.tag == "joint" && entry.base.empty()) entry.base = child_text(node, "child", "");
      if (node.tag == "include") {
        const XmlNode* const model = included(node);
        if (model && !node.child("pose")) entry.extra = own_pose(*model);
        scope[child_text(node, "name", model ? sdf_name(*model) : "")] = entry;
      } else if (node.tag == "joint") {
        scope.emplace(sdf_name(node), entry);  // old files have links of the same name
      } else {
        scope[sdf_name(node)] = entry;
      }
    }
    return scope;
  }

  Pose resolve(const XmlNode& asking, const std::string& name, Scope& scope) {
    if (name.empty()) return {};
    const auto it = scope.find(name);
    if (it == scope.end()) return scoped(asking, name, scope);
    Frame& frame = it->second;
    if (frame.state == 1) place(asking).refuse("relative_to", name, "frames without a circle");
    if (frame.state == 2) return frame.pose;
    frame.state = 1;
    if (++m_resolving > kMostFramesInARow)
      bad_input("%1: too many frames in a row; accepted: %2", place(asking).text(),
                kMostFramesInARow);
    const Pose base = resolve(*frame.node, frame.base, scope);
    --m_resolving;
    frame.pose = composed(base, composed(own_pose(*frame.node), frame.extra));
    frame.state = 2;
    return frame.pose;
  }

  // "model::link": the pose inside a nested model.
  Pose scoped(const XmlNode& asking, const std::string& name, Scope& scope) {
    const size_t colons = name.find("::");
    const auto it = colons == name.npos ? scope.end() : scope.find(name.substr(0, colons));
    if (it == scope.end() || !it->second.node)
      place(asking).refuse("relative_to", name, "the name of a frame, a link or a model");
    const XmlNode* const inner =
        it->second.node->tag == "include" ? included(*it->second.node) : it->second.node;
    if (!inner) return {};
    Scope inside = scope_of(*inner, "__model__");
    return composed(resolve(asking, it->first, scope),
                    resolve(asking, name.substr(colons + 2), inside));
  }

  void read_world(const XmlNode& world) {
    Scope scope = scope_of(world, "world");
    if (const XmlNode* const gravity = world.child("gravity")) {
      const Vec3 g = sdf_vec3(m_scene.files, world, "gravity", Vec3::Zero());
      if (g[0] != 0 || g[1] != 0 || !(g[2] < 0))
        note_once(m_scene.unread,
                  say("gravity is \"%1\"; judged as if it acted along -z", trimmed_text(*gravity)));
    }
    if (world.child("state"))
      note_once(m_scene.notes,
                "the state of the world (<state>) is not read: models stand where "
                "they are defined");
    read_models(world, Pose{}, "", false, scope, 0);
  }

  // @param is_static  what they are in is.
  void read_models(const XmlNode& owner, const Pose& world, const std::string& prefix,
                   bool is_static, Scope& scope, int depth) {
    for (const XmlNode& node : owner.children) {
      if (node.tag != "model" && node.tag != "include") continue;
      const XmlNode* const model = node.tag == "include" ? included(node) : &node;
      if (!model) continue;
      std::string name = sdf_name(*model);
      if (node.tag == "include") name = child_text(node, "name", name);
      const Pose base = composed(world, resolve(node, relative_to(node), scope));
      const Pose at = composed(world, resolve(node, name, scope));
      Place where{&node, base, {}};
      if (depth > 0) where = {nullptr, {}, Sentence("it is part of another model")};
      if (node.tag == "include" && !node.child("pose"))
        where.why_not = Sentence("its <include> has no <pose>");
      const bool fixed = is_static || is_true(child_text(*model, "static", "0")) ||
                         (node.tag == "include" && is_true(child_text(node, "static", "0")));
      read_model_in(*model, at, prefix + name, where, depth, fixed);
    }
  }

  void read_model_in(const XmlNode& model, const Pose& given, const std::string& given_name,
                     const Place& where, int depth, bool is_static = false) {
    if (depth > kMostNestedModels) bad_input("%1: nested too deeply", place(model).text());
    const bool top = given_name.empty();
    const Pose world = top ? own_pose(model) : given;
    const std::string name = top ? sdf_name(model) : given_name;
    is_static = is_static || is_true(child_text(model, "static", "0"));
    Scope scope = scope_of(model, "__model__");
    const std::map<std::string, std::string> group = rigid_groups(model);
    const bool joints = hangs_in_joints(model);
    std::map<std::string, size_t> body_of;  // by group
    for (const XmlNode& link : model.children) {
      if (link.tag != "link") continue;
      const std::string key = group.at(sdf_name(link));
      if (!body_of.count(key)) {
        body_of[key] = m_scene.bodies.size();
        m_scene.bodies.push_back(new_body(name, link, world, where, is_static, joints));
      }
      add_link(link, composed(world, resolve(link, sdf_name(link), scope)), world, scope,
               m_scene.bodies[body_of[key]]);
    }
    if (joints && !is_static) {
      const SdfLinks links{name,
                           world,
                           has_model_axes(model),
                           group,
                           body_of,
                           [&](const XmlNode& asking, const std::string& frame) {
                             return composed(world, resolve(asking, frame, scope));
                           },
                           [&](const XmlNode& joint) { return joint_pose(joint, world, scope); }};
      add_sdf_joints(model, links, m_scene, m_joints);
    }
    read_models(model, world, name + "::", is_static, scope, depth + 1);
  }

  // Links that fixed joints connect have one name; several groups hang in joints.
  std::map<std::string, std::string> rigid_groups(const XmlNode& model) const {
    std::map<std::string, std::string> out;
    for (const XmlNode& node : model.children)
      if (node.tag == "link") out[sdf_name(node)] = sdf_name(node);
    if (out.size() > kMostLinks)
      bad_input("%1: too many links; accepted: %2", place(model).text(), kMostLinks);
    for (const XmlNode& joint : model.children) {
      const std::string* const type = joint.tag == "joint" ? joint.find("type") : nullptr;
      if (!type || *type != "fixed") continue;
      const auto a = out.find(child_text(joint, "parent", "")),
                 b = out.find(child_text(joint, "child", ""));
      if (a == out.end() || b == out.end()) continue;
      const std::string from = b->second, to = a->second;
      for (auto& [link, key] : out)
        if (key == from) key = to;
    }
    return out;
  }

  bool hangs_in_joints(const XmlNode& model) const {
    for (const XmlNode& joint : model.children) {
      if (joint.tag != "joint") continue;
      const std::string* const type = joint.find("type");
      if (!type || *type != "fixed" || child_text(joint, "parent", "") == "world") return true;
    }
    return false;
  }

  Pose joint_pose(const XmlNode& joint, const Pose& world, Scope& scope) {
    const std::string base = relative_to(joint);
    const Pose from = resolve(joint, base.empty() ? child_text(joint, "child", "") : base, scope);
    return composed(world, composed(from, own_pose(joint)));
  }

  // Up to version 1.4 axes of joints are in the model's frame.
  bool has_model_axes(const XmlNode& node) const {
    for (const auto& root : m_roots)
      if (root->file == node.file)
        if (const std::string* const version = root->find("version"))
          return *version == "1.0" || *version == "1.2" || *version == "1.3" || *version == "1.4";
    return false;
  }

  // @param joints  the model has some.
  ForeignBody new_body(const std::string& name, const XmlNode& link, const Pose& world,
                       const Place& where, bool is_static, bool joints) {
    ForeignBody out;
    out.name = m_unique(joints ? name + "::" + sdf_name(link) : name);
    out.fixed = is_static || joints;
    out.is_link = joints && !is_static;
    out.pose = world;
    out.weld = static_cast<int>(m_scene.bodies.size()) + 1;
    if (out.fixed || !where.node || !where.why_not.empty()) {
      out.place.why_not = where.why_not.empty() ? Sentence("it does not move") : where.why_not;
      return out;
    }
    out.place.kind = PosePlace::Kind::Element;
    out.place.file = where.node->file;
    out.place.begin = where.node->begin;
    out.place.world_from_place = where.base;
    if (const XmlNode* const pose = where.node->child("pose")) out.place.element = *pose;
    out.place.content = where.node->content;
    return out;
  }

  void add_link(const XmlNode& link, const Pose& at, const Pose& world, Scope& scope,
                ForeignBody& body) {
    const Pose in_body = composed(inverse(world), at);
    for (const XmlNode& node : link.children) {
      if (node.tag != "collision") continue;
      const std::string base = relative_to(node);
      const Pose from = base.empty() ? in_body : resolve(node, base, scope);
      add_sdf_collision(node, composed(from, own_pose(node)), m_meshes, m_scene, body);
    }
    if (!body.fixed || body.is_link) add_sdf_mass(link, in_body, m_scene.files, body);
  }

  // The model of an <include>; null: it cannot be had, which is told.
  const XmlNode* included(const XmlNode& include) {
    const auto known = m_included.find(&include);
    if (known != m_included.end()) return known->second;
    return m_included[&include] = read_included(include);
  }

  const XmlNode* read_included(const XmlNode& include) {
    const std::string uri = child_text(include, "uri", "");
    try {
      if (m_scene.files.size() >= kMostSdfFiles) bad_input("more than %1 files", kMostSdfFiles);
      const std::string path =
          sdf_in(path_of_uri(uri, m_scene.files[include.file].path, m_allowed));
      m_roots.push_back(std::make_unique<XmlNode>(
          read_xml_tree(path, m_scene.files.size(), m_options.limits, m_scene.files)));
      if (const XmlNode* const model = m_roots.back()->child("model")) return model;
      bad_file(path, "has no model");
    } catch (const Error& error) {
      skip_sdf(include, error.sentence(), m_scene);
      return nullptr;
    }
  }

  // The file of a model's folder.
  static std::string sdf_in(const std::string& path) {
    std::error_code error;
    return std::filesystem::is_directory(path, error) ? path + "/model.sdf" : path;
  }

  ForeignOptions m_options;
  SceneRoots m_allowed;
  SdfMeshes m_meshes;
  ForeignScene m_scene;
  std::vector<std::unique_ptr<XmlNode>> m_roots;
  std::map<const XmlNode*, const XmlNode*> m_included;
  UniqueNames m_unique;
  std::vector<TreeJoint> m_joints;
  size_t m_num_frames = 0;  // in all scopes that were made
  int m_resolving = 0;      // frames on the way
};

}  // namespace

ForeignScene read_sdf(const std::string& path, const ForeignOptions& options,
                      const MeshSource& meshes) {
  return SdfReader(path, options, meshes).read();
}

}  // namespace trivet
