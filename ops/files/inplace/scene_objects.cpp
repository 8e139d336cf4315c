#include "ops/files/inplace/scene_objects.h"

#include <Eigen/Geometry>
#include <cmath>
#include <cstring>
#include <map>

#include "core/base/error.h"
#include "core/base/float32.h"
#include "core/base/hash.h"
#include "core/base/printable.h"
#include "core/io/gltf/copy.h"
#include "core/io/gltf/extensions.h"
#include "core/io/mesh/node_product.h"
#include "core/io/process/sandboxed_import.h"
#include "ops/base/names.h"
#include "ops/files/inplace/scene_copy.h"
#include "ops/files/inplace/scene_document.h"
#include "ops/files/report/temporary_file.h"

namespace trivet {
namespace {

// The file's y up, turned to z up: (x, y, z) -> (x, -z, y).
Vec3 z_up(const Vec3& p) { return {p.x(), -p.z(), p.y()}; }
Vec3 y_up(const Vec3& p) { return {p.x(), p.z(), -p.y()}; }

Affine z_up(const Affine& a) {
  Affine out;
  for (int c = 0; c < 3; ++c) out.linear.col(c) = z_up(Vec3(a.linear.col(c)));
  out.translation = z_up(a.translation);
  return out;
}

Affine y_up(const Affine& a) {
  Affine out;
  for (int c = 0; c < 3; ++c) out.linear.col(c) = y_up(Vec3(a.linear.col(c)));
  out.translation = y_up(a.translation);
  return out;
}

// Gram and Schmidt: right-handed and orthonormal, with the columns' directions as far as they go.
std::optional<Mat3> rotation_of(const Mat3& m) {
  Mat3 out;
  out.col(0) = m.col(0).normalized();
  out.col(1) = (m.col(1) - out.col(0).dot(m.col(1)) * out.col(0)).normalized();
  out.col(2) = out.col(0).cross(out.col(1));
  if (!out.allFinite() || std::abs(out.col(0).dot(out.col(1))) > 1e-9) return std::nullopt;
  return out;
}

// A scene's node without a place, for the importer: with all below it, or its own mesh alone.
GltfJson bare_node(const GltfJson& root, int node, SceneRule rule) {
  const GltfJson& from = element(root, "nodes", GltfJson(static_cast<unsigned>(node)));
  GltfJson out = GltfJson::object();
  for (const char* key : {"mesh", "children"})
    if (from.contains(key) && (rule != SceneRule::Meshes || std::strcmp(key, "mesh") == 0))
      out[key] = from[key];
  const GltfJson& instances = member(member(from, "extensions"), gltf::kInstancing);
  if (!instances.is_null()) out["extensions"][gltf::kInstancing] = instances;
  return out;
}

// All that the geometry below a node depends on.
std::string geometry_key(const GltfJson& root, const GltfJson& bare) {
  GltfJson out = GltfJson::object();
  for (const char* key : {"mesh", "matrix", "translation", "rotation", "scale"})
    if (bare.contains(key)) out[key] = bare[key];
  out["instances"] = member(member(bare, "extensions"), gltf::kInstancing);
  std::string text = out.dump();
  for (const GltfJson& child : member(bare, "children"))
    text += "(" + geometry_key(root, element(root, "nodes", child)) + ")";
  return text;
}

std::string stretch_key(const Mat3& stretch) {
  Hash hash;
  for (int i = 0; i < 9; ++i) hash.add(stretch(i / 3, i % 3));
  return hash.text();
}

void drop_appearance(GltfJson& root) {
  for (const char* list : {"images", "textures", "samplers", "materials"}) root.erase(list);
  if (!root.contains("meshes")) return;
  for (GltfJson& mesh : root["meshes"])
    for (GltfJson& primitive : mesh["primitives"]) primitive.erase("material");
}

Model stretched(Model model, const Mat3& stretch) {
  std::vector<Triangle> triangles;
  triangles.reserve(model.mesh.triangles.size());
  const Affine affine{stretch, Vec3::Zero()};
  const bool mirrored = mirrors(affine);
  for (size_t f = 0; f < model.mesh.triangles.size(); ++f) {
    Triangle t = model.mesh.triangle(static_cast<Index>(f));
    for (Vec3& p : t) p = affine.apply(p);
    if (mirrored) std::swap(t[1], t[2]);  // inside and outside are turned round
    triangles.push_back(t);
  }
  model.mesh = weld(triangles);
  Mat3 cofactors;  // transforms normals
  for (int i = 0; i < 3; ++i)
    cofactors.row(i) = stretch.row((i + 1) % 3).cross(stretch.row((i + 2) % 3));
  if (mirrored) cofactors = -cofactors;
  for (auto& face : model.corner_normals) {
    if (mirrored) std::swap(face[1], face[2]);
    for (Eigen::Vector3f& n : face) n = (cofactors * n.cast<double>()).normalized().cast<float>();
  }
  return model;
}

bool same(const Pose& a, const Pose& b) {
  return a.translation == b.translation && a.rotation.w == b.rotation.w &&
         a.rotation.x == b.rotation.x && a.rotation.y == b.rotation.y &&
         a.rotation.z == b.rotation.z;
}

}  // namespace

struct GltfScene::Document {
  std::string path;
  SceneRule rule;
  ImportLimits limits;
  GltfJson original, json;  // as in the file, and with new transforms
  GltfDocument resolved;    // with its buffers and a bare node per object, for geometry
  std::vector<int> bare;    // those nodes
  NodeTree tree;
  std::vector<SceneNode> objects;
  std::vector<std::string> keys;  // model_name() of each
  std::map<std::string, size_t> first_of_key;
  std::vector<bool> moved;

  void find_objects();
  std::string unique_name(int node, std::map<std::string, int>& taken) const;
  Sentence why_immovable(int node, const std::set<int>& animated) const;
  bool has_skin_below(int node) const;
  Model read(size_t object) const;
};

std::string GltfScene::Document::unique_name(int node, std::map<std::string, int>& taken) const {
  std::string base = name_of(original["nodes"][static_cast<size_t>(node)]);
  if (!is_object_name(base)) base = "node " + std::to_string(node);
  std::string name = base;
  for (int i = 2; taken.count(name); ++i) name = base + "_" + std::to_string(i);
  taken[name] = node;
  return name;
}

// Deformed by a skeleton: such meshes are at its joints, not at their node.
bool GltfScene::Document::has_skin_below(int node) const {
  std::vector<int> stack{node};
  while (!stack.empty()) {
    const auto n = static_cast<size_t>(stack.back());
    stack.pop_back();
    if (original["nodes"][n].contains("skin")) return true;
    stack.insert(stack.end(), tree.nodes[n].children.begin(), tree.nodes[n].children.end());
  }
  return false;
}

Sentence GltfScene::Document::why_immovable(int node, const std::set<int>& animated) const {
  for (int n = node; n >= 0; n = tree.nodes[static_cast<size_t>(n)].parent)
    if (animated.count(n)) return TRIVET_SENTENCE("it is animated");
  if (has_skin_below(node)) return TRIVET_SENTENCE("it is deformed by a skeleton");
  if (tree.nodes[static_cast<size_t>(node)].parent >= 0 &&
      !inverse(tree.nodes[static_cast<size_t>(tree.nodes[static_cast<size_t>(node)].parent)].world))
    return "a node above it has a scale of zero";
  return {};
}

void GltfScene::Document::find_objects() {
  const std::set<int> animated = animated_nodes(original);
  std::map<std::string, int> taken;
  for (const int node : object_nodes(original, tree, rule)) {
    SceneNode object;
    object.node = node;
    object.name = unique_name(node, taken);
    object.immovable = why_immovable(node, animated);
    const Affine world = z_up(tree.nodes[static_cast<size_t>(node)].world);
    // world = translation + rotation x up x stretch, as objects with y up have it.
    Mat3 up;
    up << 1, 0, 0, 0, 0, -1, 0, 1, 0;
    const std::optional<Mat3> rotation = rotation_of(world.linear * up.transpose());
    if (rotation) object.pose.rotation = Rotation::from_matrix(*rotation);
    if (!rotation) object.immovable = TRIVET_SENTENCE("its transform flattens it");
    object.pose.translation = world.translation;
    object.stretch = (object.pose.rotation.matrix() * up).transpose() * world.linear;
    const GltfJson shown = bare_node(original, node, rule);
    keys.push_back(geometry_key(original, shown) + " " + stretch_key(object.stretch));
    bare.push_back(static_cast<int>(resolved.json["nodes"].size()));
    resolved.json["nodes"].push_back(shown);
    first_of_key.emplace(keys.back(), objects.size());
    objects.push_back(std::move(object));
  }
  if (objects.empty())
    throw Error(Error::Kind::BadInput, "%1: has no objects: no node of its scene has a mesh", path);
  moved.assign(objects.size(), false);
}

Model GltfScene::Document::read(size_t object) const {
  GltfPart part = copied_part(resolved, {bare[object]});
  part.document.json["scenes"] = GltfJson::array({{{"nodes", part.roots}}});
  const TemporaryFile file(glb_bytes(std::move(part.document)), ".glb");
  Model model = stretched(import_model(file.path(), limits), objects[object].stretch);
  model.path = path;
  return model;
}

GltfScene::GltfScene(const std::string& path, SceneRule rule, const ImportLimits& limits)
    : m_document(std::make_unique<Document>()) {
  Document& d = *m_document;
  d.path = path, d.rule = rule, d.limits = limits;
  try {
    d.original = d.json = parse_gltf_json(path, read_gltf_text(path));
    d.resolved = read_gltf_document(path, limits);
    d.tree = node_tree(d.original);
    drop_appearance(d.resolved.json);
    d.find_objects();
  } catch (const GltfJson::exception& e) {
    throw Error(Error::Kind::BadInput, "%1: is no valid glTF: %2", path, printable(e.what()));
  } catch (const Error& e) {
    if (std::string(e.what()).rfind(path, 0) == 0) throw;
    throw Error(e.kind(), "%1: %2", path, e.sentence());
  }
}

GltfScene::~GltfScene() = default;

const std::string& GltfScene::path() const { return m_document->path; }
const std::vector<SceneNode>& GltfScene::objects() const { return m_document->objects; }
const std::string& GltfScene::model_name(size_t object) const { return m_document->keys[object]; }
bool GltfScene::is_moved(size_t object) const { return m_document->moved[object]; }

ModelSource GltfScene::models() const {
  return [this](const std::string& name, const Tessellation&) {
    return m_document->read(m_document->first_of_key.at(name));
  };
}

void GltfScene::move(const std::vector<Pose>& poses) {
  Document& d = *m_document;
  std::map<int, size_t> object_of;
  for (size_t i = 0; i < d.objects.size(); ++i) object_of[d.objects[i].node] = i;
  d.json = d.original;
  std::vector<Affine> world(d.tree.nodes.size());  // as wanted
  std::vector<bool> changed(d.tree.nodes.size(), false);
  for (const int node : d.tree.order) {
    const auto n = static_cast<size_t>(node);
    const TreeNode& entry = d.tree.nodes[n];
    const auto parent = static_cast<size_t>(std::max(entry.parent, 0));
    const bool parent_changed = entry.parent >= 0 && changed[parent];
    const auto it = object_of.find(node);
    const bool stays = it == object_of.end() || same(poses[it->second], d.objects[it->second].pose);
    GltfJson& json = d.json["nodes"][n];
    world[n] = entry.world;
    if (stays && !parent_changed) continue;
    changed[n] = true;
    if (it == object_of.end()) {  // goes along
      world[n] = composed(world[parent], local_transform(json));
      continue;
    }
    const SceneNode& object = d.objects[it->second];
    if (!stays) {
      const Affine pose = world_from_object(poses[it->second], UpAxis::Y, 1);
      world[n] = y_up(composed(pose, {object.stretch, Vec3::Zero()}));
    }
    const auto refuse = [&](const Sentence& why) {
      throw Error(Error::Kind::BadInput, "%1: \"%2\" cannot be moved: %3", d.path, object.name,
                  why);
    };
    if (!object.immovable.empty()) refuse(object.immovable);
    const auto parent_inverse =
        entry.parent >= 0 ? inverse(world[parent]) : std::optional<Affine>(Affine());
    if (!parent_inverse) refuse("a node above it has a scale of zero");
    if (!set_transform(composed(*parent_inverse, world[n]), json))
      refuse("below a node that is not scaled evenly it would have shear, which glTF has not");
    d.moved[it->second] = true;
  }
}

std::vector<Vec3> GltfScene::written_positions(size_t object, const Mesh& mesh) const {
  const Document& d = *m_document;
  const SceneNode& found = d.objects[object];
  Affine world = local_transform(d.json["nodes"][static_cast<size_t>(found.node)]);
  for (int n = d.tree.nodes[static_cast<size_t>(found.node)].parent; n >= 0;
       n = d.tree.nodes[static_cast<size_t>(n)].parent)
    world = composed(local_transform(d.json["nodes"][static_cast<size_t>(n)]), world);
  std::vector<Vec3> out;
  out.reserve(mesh.vertices.size());
  const auto unstretch = inverse({found.stretch, Vec3::Zero()});
  if (unstretch) world = composed(world, *unstretch);
  for (const Vec3& v : mesh.vertices) out.push_back(z_up(as_float32(world.apply(v))));
  return out;
}

void GltfScene::write(const std::string& path) const {
  write_scene_copy(m_document->path, m_document->original, m_document->json, path);
}

}  // namespace trivet
