#include "ops/files/report/glb_nodes.h"

#include <map>

#include "core/base/error.h"
#include "core/io/gltf/builder.h"

namespace trivet {
namespace {

const GltfJson& node_of(const GltfJson& root, int node) {
  return element(root, "nodes", GltfJson(static_cast<unsigned>(node)));
}

// A node that objects of a wide scene are below.
bool is_place(const GltfJson& node) {
  return name_of(node) == "place" && !node.contains("extras") && node.contains("translation");
}

// The root that all objects of a scene far from the world's origin are below; else null. Objects'
// own nodes have Trivet's extras.
const GltfJson* origin_node(const GltfJson& root, const std::vector<int>& roots) {
  if (roots.size() != 1) return nullptr;
  const GltfJson& node = node_of(root, roots.front());
  return node.contains("extras") || !node.contains("translation") || is_place(node) ? nullptr
                                                                                    : &node;
}

std::vector<int> children_of(const GltfJson& node) {
  std::vector<int> out;
  for (const GltfJson& child : member(node, "children"))
    out.push_back(static_cast<int>(index_from(child)));
  return out;
}

Vec3 translation_of(const GltfJson& node) {
  std::vector<double> t;
  for (const GltfJson& entry : node["translation"])
    t.push_back(entry.is_number() ? entry.get<double>() : 0);
  t.resize(3);
  return {t[0], 0.0 - t[2], t[1]};
}

struct ObjectNode {
  int node;
  Vec3 place;
};

// Names of the objects' nodes; a model's nodes below them may be called the same.
std::map<std::string, ObjectNode> objects_by_name(const GltfJson& root) {
  std::map<std::string, ObjectNode> out;
  if (member(root, "nodes").empty()) return out;
  std::vector<int> nodes = scene_roots(root);
  if (const GltfJson* origin = origin_node(root, nodes)) nodes = children_of(*origin);
  const auto add = [&](int node, const Vec3& place) {
    out.emplace(name_of(node_of(root, node)), ObjectNode{node, place});
  };
  for (const int id : nodes) {
    const GltfJson& node = node_of(root, id);
    if (!is_place(node))
      add(id, Vec3::Zero());
    else
      for (const int child : children_of(node)) add(child, translation_of(node));
  }
  return out;
}

Vec3 origin_of(const GltfJson& root) {
  if (member(root, "nodes").empty()) return Vec3::Zero();
  const GltfJson* node = origin_node(root, scene_roots(root));
  return node ? translation_of(*node) : Vec3(Vec3::Zero());
}

// A node like the object's own, but with nothing of its pose and of Trivet's data.
GltfJson bare_node(const GltfJson& root, const GltfJson& node, const ModelNode& wanted) {
  GltfJson out = GltfJson::object();
  if (const GltfJson& mesh = member(node, "mesh"); !mesh.is_null()) {
    out["mesh"] = mesh;
    const std::string name = name_of(element(root, "meshes", mesh));
    if (wanted.own_nodes && !name.empty()) out["name"] = name;
  }
  const GltfJson* children = &member(node, "children");
  if (wanted.pivot && children->size() == 1)
    children = &member(element(root, "nodes", children->front()), "children");
  if (wanted.own_nodes && !children->empty()) out["children"] = *children;
  return out;
}

// Roots of the model's appearance: the nodes below, or the mesh alone.
std::vector<int> look_roots(const GltfJson& node, int id) {
  std::vector<int> out = children_of(node);
  if (out.empty()) out.push_back(id);
  return out;
}

std::vector<double> matrix_of(const GltfJson& node) {
  std::vector<double> matrix;
  const GltfJson& given = member(node, "matrix");
  if (given.is_array()) {
    for (const GltfJson& entry : given)
      matrix.push_back(entry.is_number() ? entry.get<double>() : 0);
  } else if (!node.contains("translation") && !node.contains("rotation") &&
             !node.contains("scale")) {
    for (int i = 0; i < 16; ++i) matrix.push_back(i % 5 == 0 ? 1 : 0);
  }
  return matrix;
}

}  // namespace

NodeModels::NodeModels(const std::string& path, const std::vector<ModelNode>& nodes,
                       const ImportLimits& limits) {
  GltfDocument document = read_gltf_document(path, limits);
  const std::map<std::string, ObjectNode> roots = objects_by_name(document.json);
  GltfJson ids = GltfJson::array();
  std::vector<Sentence> notes;
  for (const ModelNode& wanted : nodes) {
    const auto found = roots.find(wanted.name);
    const GltfJson bare =
        found == roots.end()
            ? GltfJson::object()
            : bare_node(document.json, document.json["nodes"][found->second.node], wanted);
    if (bare.empty())
      throw Error(Error::Kind::BadInput,
                  "%1: has no mesh for \"%2\"; another program has changed it", path, wanted.name);
    const size_t id = document.json["nodes"].size();
    ids.push_back(id);
    document.json["nodes"].push_back(bare);
    m_looks.push_back(
        wanted.own_nodes
            ? appearance_of_gltf(document, look_roots(bare, static_cast<int>(id)), notes)
            : nullptr);
  }
  for (const auto& [name, of] : roots) document.json["nodes"][of.node].erase("children");
  document.json["scenes"] = GltfJson::array({{{"nodes", std::move(ids)}}});
  document.json["scene"] = 0;
  m_file = std::make_unique<TemporaryFile>(glb_bytes(std::move(document)), ".glb");
}

NodePoses read_node_poses(const std::string& path) {
  const GltfJson root = parse_gltf_json(path, read_gltf_text(path));
  NodePoses poses;
  poses.origin = origin_of(root);
  for (const auto& [name, of] : objects_by_name(root))
    poses.nodes.push_back({name, matrix_of(root["nodes"][of.node]), of.place});
  return poses;
}

}  // namespace trivet
