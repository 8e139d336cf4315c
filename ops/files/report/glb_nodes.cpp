#include "ops/files/report/glb_nodes.h"

#include <map>

#include "core/base/error.h"
#include "core/io/gltf/gltf_builder.h"

namespace trivet {
namespace {

// Names of the scene's own nodes; a model's nodes below them may be called the same.
std::map<std::string, int> roots_by_name(const GltfJson& root) {
  std::map<std::string, int> out;
  if (member(root, "nodes").empty()) return out;
  for (const int node : scene_roots(root))
    out.emplace(name_of(element(root, "nodes", GltfJson(static_cast<unsigned>(node)))), node);
  return out;
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

// What the model's look begins with: the nodes below, or the mesh alone.
std::vector<int> look_roots(const GltfJson& node, int id) {
  std::vector<int> out;
  for (const GltfJson& child : member(node, "children"))
    out.push_back(static_cast<int>(index_from(child)));
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
  const std::map<std::string, int> roots = roots_by_name(document.json);
  GltfJson ids = GltfJson::array();
  std::vector<std::string> notes;
  for (const ModelNode& wanted : nodes) {
    const auto found = roots.find(wanted.name);
    const GltfJson bare =
        found == roots.end()
            ? GltfJson::object()
            : bare_node(document.json, document.json["nodes"][found->second], wanted);
    if (bare.empty())
      throw Error(Error::Kind::BadInput, path + ": has no mesh for \"" + wanted.name +
                                             "\"; another program has changed it");
    const size_t id = document.json["nodes"].size();
    ids.push_back(id);
    document.json["nodes"].push_back(bare);
    m_looks.push_back(
        wanted.own_nodes
            ? appearance_of_gltf(document, look_roots(bare, static_cast<int>(id)), notes)
            : nullptr);
  }
  for (const auto& [name, node] : roots) document.json["nodes"][node].erase("children");
  document.json["scenes"] = GltfJson::array({{{"nodes", std::move(ids)}}});
  document.json["scene"] = 0;
  m_file = std::make_unique<TemporaryFile>(glb_bytes(std::move(document)), ".glb");
}

std::vector<NodePose> read_node_poses(const std::string& path) {
  const GltfJson root = parse_gltf_json(path, read_gltf_text(path));
  std::vector<NodePose> poses;
  for (const auto& [name, node] : roots_by_name(root))
    poses.push_back({name, matrix_of(root["nodes"][node])});
  return poses;
}

}  // namespace trivet
