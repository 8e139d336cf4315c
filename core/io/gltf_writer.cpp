#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <unordered_map>

#include "core/base/error.h"
#include "core/io/appearance.h"
#include "core/io/float_export.h"
#include "core/io/glb_container.h"
#include "core/io/writers.h"

namespace trivet {
namespace {

using Json = nlohmann::ordered_json;

// Numbers of the glTF 2.0 specification.
constexpr int kFloat = 5126, kUnsignedInt = 5125;
constexpr int kArrayBuffer = 34962, kElementArrayBuffer = 34963;

/// One vertex of a primitive: glTF has one index for position and normal together.
struct CornerKey {
  Index vertex;
  Eigen::Vector3f normal;

  bool operator==(const CornerKey& b) const { return vertex == b.vertex && normal == b.normal; }
};

struct CornerHash {
  size_t operator()(const CornerKey& key) const {
    size_t hash = static_cast<size_t>(key.vertex);
    for (int i = 0; i < 3; ++i)
      hash = hash * 0x9E3779B97F4A7C15u + std::bit_cast<std::uint32_t>(key.normal[i] + 0.0f);
    return hash ^ (hash >> 29);
  }
};

struct PrimitiveData {
  std::vector<Eigen::Vector3f> positions, normals;
  std::vector<std::uint32_t> indices;
};

// Corners in the order of the faces, so that the same model gives the same bytes.
PrimitiveData primitive_data(const Mesh& mesh, const std::vector<Index>& faces,
                             const std::vector<Eigen::Vector3f>& positions,
                             const CornerNormals& normals) {
  PrimitiveData out;
  std::unordered_map<CornerKey, std::uint32_t, CornerHash> ids;
  ids.reserve(faces.size());
  for (Index f : faces)
    for (int k = 0; k < 3; ++k) {
      const CornerKey key{mesh.triangles[f][k], normals[f][k]};
      const auto next = static_cast<std::uint32_t>(out.positions.size());
      const auto [entry, is_new] = ids.try_emplace(key, next);
      if (is_new) {
        out.positions.push_back(positions[key.vertex]);
        out.normals.push_back(key.normal);
      }
      out.indices.push_back(entry->second);
    }
  return out;
}

Json array_of(const Eigen::Vector3f& v) { return {v.x(), v.y(), v.z()}; }

Json parsed_extras(const std::string& text, const std::string& whose) {
  try {
    return Json::parse(text);
  } catch (const Json::exception& e) {
    throw Error(Error::Kind::BadInput, "the extras of " + whose + " are no JSON: " + e.what());
  }
}

class GlbWriter {
 public:
  std::string write(const ExportScene& scene) {
    Json scene_json = Json::object();
    for (const ExportObject& object : scene.objects) add_object(object);
    if (!m_nodes.empty()) {
      scene_json["nodes"] = Json::array();
      for (size_t i = 0; i < m_nodes.size(); ++i) scene_json["nodes"].push_back(i);
    }
    if (!scene.extras_json.empty())
      scene_json["extras"] = parsed_extras(scene.extras_json, "the scene");

    Json root = {{"asset", {{"version", "2.0"}, {"generator", "Trivet"}}}, {"scene", 0}};
    root["scenes"] = Json::array({std::move(scene_json)});
    add_list(root, "nodes", m_nodes);
    add_list(root, "meshes", m_meshes);
    add_list(root, "materials", m_materials);
    add_list(root, "accessors", m_accessors);
    add_list(root, "bufferViews", m_views);
    if (!m_binary.empty()) root["buffers"] = Json::array({{{"byteLength", m_binary.size()}}});
    // Names may come from files in any encoding; glTF wants UTF-8.
    return pack_glb(root.dump(-1, ' ', false, Json::error_handler_t::replace), m_binary);
  }

 private:
  // glTF forbids empty lists.
  static void add_list(Json& root, const char* key, std::vector<Json>& list) {
    if (!list.empty()) root[key] = std::move(list);
  }

  void add_object(const ExportObject& object) {
    const StoredMesh& stored = stored_mesh(object);
    const NodeMatrix rows = node_matrix(object, stored.centre);
    Json node = {{"name", object.name}};
    if (stored.id >= 0) node["mesh"] = stored.id;
    Json matrix = Json::array();
    bool identity = true;
    for (int c = 0; c < 4; ++c)
      for (int r = 0; r < 4; ++r) {
        const float entry = r < 3 ? rows[r][c] : (c == 3 ? 1.0f : 0.0f);
        matrix.push_back(entry);
        identity &= entry == (r == c ? 1.0f : 0.0f);
      }
    if (!identity) node["matrix"] = std::move(matrix);
    if (!object.extras_json.empty())
      node["extras"] = parsed_extras(object.extras_json, "object '" + object.name + "'");
    m_nodes.push_back(std::move(node));
  }

  struct StoredMesh {
    int id = -1;  // -1: no triangle, and glTF has no empty mesh
    Vec3 centre = Vec3::Zero();
  };

  const StoredMesh& stored_mesh(const ExportObject& object) {
    const auto [entry, is_new] = m_stored.try_emplace(object.model.get());
    if (is_new && !object.model->mesh.triangles.empty()) {
      const LocalVertices local = local_vertices(object.model->mesh);
      entry->second = {static_cast<int>(m_meshes.size()), local.centre};
      add_mesh(*object.model, object.name, local.positions);
    }
    return entry->second;
  }

  void add_mesh(const Model& model, const std::string& name,
                const std::vector<Eigen::Vector3f>& positions) {
    const CornerNormals normals = shading_normals(model);
    Json primitives = Json::array();
    for (const MaterialFaces& group : faces_by_material(model)) {
      const PrimitiveData data = primitive_data(model.mesh, group.faces, positions, normals);
      const size_t position = add_positions(data.positions);
      const size_t normal = add_vectors(data.normals);
      primitives.push_back(
          {{"attributes", {{"POSITION", position}, {"NORMAL", normal}}},
           {"indices", add_indices(data.indices)},
           {"material", add_material(material_or_default(model, group.material))}});
    }
    m_meshes.push_back({{"name", name}, {"primitives", std::move(primitives)}});
  }

  size_t add_material(const Material& material) {
    const auto unit = [](float x) { return std::clamp(x, 0.0f, 1.0f); };
    const auto& c = material.base_colour;
    Json out = Json::object();
    if (!material.name.empty()) out["name"] = material.name;
    out["pbrMetallicRoughness"] = {
        {"baseColorFactor", {unit(c[0]), unit(c[1]), unit(c[2]), unit(c[3])}},
        {"metallicFactor", unit(material.metallic)},
        {"roughnessFactor", unit(material.roughness)}};
    if (c[3] < 1) out["alphaMode"] = "BLEND";
    out["doubleSided"] = true;  // raw meshes are open, and wound as it happens
    m_materials.push_back(std::move(out));
    return m_materials.size() - 1;
  }

  // Every element is a multiple of 4 bytes, so that all views are aligned.
  template <class T>
  size_t add_accessor(const std::vector<T>& values, int target, int component, const char* type) {
    const size_t bytes = values.size() * sizeof(T);
    m_views.push_back({{"buffer", 0},
                       {"byteOffset", m_binary.size()},
                       {"byteLength", bytes},
                       {"target", target}});
    m_binary.append(reinterpret_cast<const char*>(values.data()), bytes);
    m_accessors.push_back({{"bufferView", m_views.size() - 1},
                           {"componentType", component},
                           {"count", values.size()},
                           {"type", type}});
    return m_accessors.size() - 1;
  }

  size_t add_vectors(const std::vector<Eigen::Vector3f>& values) {
    static_assert(sizeof(Eigen::Vector3f) == 12);
    return add_accessor(values, kArrayBuffer, kFloat, "VEC3");
  }

  size_t add_indices(const std::vector<std::uint32_t>& values) {
    return add_accessor(values, kElementArrayBuffer, kUnsignedInt, "SCALAR");
  }

  size_t add_positions(const std::vector<Eigen::Vector3f>& values) {
    Eigen::Vector3f lower = values.front(), upper = values.front();
    for (const Eigen::Vector3f& p : values) lower = lower.cwiseMin(p), upper = upper.cwiseMax(p);
    const size_t id = add_vectors(values);
    m_accessors[id]["min"] = array_of(lower);
    m_accessors[id]["max"] = array_of(upper);
    return id;
  }

  std::vector<Json> m_nodes, m_meshes, m_materials, m_accessors, m_views;
  std::string m_binary;
  std::map<const Model*, StoredMesh> m_stored;
};

}  // namespace

std::string glb_bytes(const ExportScene& scene) { return GlbWriter().write(scene); }

}  // namespace trivet
