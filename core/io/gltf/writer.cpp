#include <algorithm>
#include <map>
#include <set>
#include <unordered_map>

#include "core/base/error.h"
#include "core/io/appearance.h"
#include "core/io/export.h"
#include "core/io/gltf/copy.h"
#include "core/io/look.h"
#include "core/io/writers.h"
#include "core/model/exported_floats.h"

namespace trivet {
namespace {

constexpr const char* kPivotName = "pivot";
constexpr const char* kOriginName = "origin";
constexpr const char* kPlaceName = "place";

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

// Numbers corners in the order of the faces, so that equal models give equal bytes.
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

std::span<const float> floats_of(const std::vector<Eigen::Vector3f>& values) {
  static_assert(sizeof(Eigen::Vector3f) == 12);
  return {values.front().data(), 3 * values.size()};
}

GltfJson parsed_extras(const std::string& text, const std::string& whose) {
  try {
    return GltfJson::parse(text);
  } catch (const GltfJson::exception& e) {
    throw Error(Error::Kind::BadInput, "the extras of %1 are not valid JSON: %2", whose, e.what());
  }
}

bool is_identity(const GltfJson& node) {
  for (const char* key : {"matrix", "translation", "rotation", "scale"})
    if (node.contains(key)) return false;
  return true;
}

// The only node, if it adds nothing to its mesh: the object's own node can then replace it.
const GltfJson* only_mesh(const Appearance& look) {
  if (look.roots.size() != 1) return nullptr;
  const GltfJson root(static_cast<unsigned>(look.roots.front()));
  const GltfJson& node = element(look.document->json, "nodes", root);
  if (!node.contains("mesh") || !is_identity(node)) return nullptr;
  for (const auto& [key, value] : node.items())
    if (key != "mesh" && key != "name") return nullptr;
  const GltfJson& mesh = element(look.document->json, "meshes", node["mesh"]);
  const std::string name = name_of(node);
  return name.empty() || name == name_of(mesh) ? &node["mesh"] : nullptr;
}

class SceneWriter {
 public:
  SceneWriter() : m_copier(m_builder) {}

  GltfDocument write(const ExportScene& scene) {
    reserve(scene);
    GltfJson roots = GltfJson::array();
    std::map<std::array<double, 3>, GltfJson> at_places;
    for (const ExportObject& object : scene.objects) {
      const ExportObject near = relative_to(scene.origin, object);
      const Vec3 place = export_place(near.world_from_object, near.model->mesh.box());
      GltfJson& siblings = place.isZero(0) ? roots : at_places[{place.x(), place.y(), place.z()}];
      siblings.push_back(add_object(relative_to(place, near)));
    }
    for (const auto& [place, nodes] : at_places)
      roots.push_back(add_origin(kPlaceName, {place[0], place[1], place[2]}, nodes));
    if (!roots.empty() && !scene.origin.isZero(0))
      roots = {add_origin(kOriginName, scene.origin, roots)};
    GltfJson scene_json = GltfJson::object();
    if (!roots.empty()) scene_json["nodes"] = std::move(roots);
    if (!scene.extras_json.empty())
      scene_json["extras"] = parsed_extras(scene.extras_json, "the scene");
    return m_builder.take(std::move(scene_json));
  }

 private:
  // Buffers of megabytes are not moved again and again.
  void reserve(const ExportScene& scene) {
    std::set<const GltfDocument*> seen;
    size_t bytes = 0;
    for (const ExportObject& object : scene.objects)
      if (const auto& look = object.model->appearance;
          look && seen.insert(look->document.get()).second)
        bytes += look->document->binary.size();
    m_builder.reserve(bytes);
  }

  // In double, as JSON's numbers are: readers that compute so lose nothing.
  size_t add_origin(const char* name, const Vec3& origin, const GltfJson& children) {
    const Vec3 y_up(origin.x(), origin.z(), 0.0 - origin.y());
    return m_builder.add(
        "nodes",
        {{"name", name}, {"translation", {y_up.x(), y_up.y(), y_up.z()}}, {"children", children}});
  }

  size_t add_object(const ExportObject& object) {
    const Model& model = *object.model;
    GltfJson node = {{"name", object.name}};
    const Vec3 centre = export_centre(&model, model.mesh.box());
    if (model.appearance)
      add_look(*model.appearance, centre, node);
    else if (const int mesh = stored_mesh(object); mesh >= 0)
      node["mesh"] = mesh;
    add_matrix(node_matrix(object, centre), node);
    if (!object.extras_json.empty())
      node["extras"] = parsed_extras(object.extras_json, "object '" + object.name + "'");
    return m_builder.add("nodes", std::move(node));
  }

  static void add_matrix(const NodeMatrix& rows, GltfJson& node) {
    GltfJson matrix = GltfJson::array();
    bool identity = true;
    for (int c = 0; c < 4; ++c)
      for (int r = 0; r < 4; ++r) {
        const float entry = r < 3 ? rows[r][c] : (c == 3 ? 1.0f : 0.0f);
        matrix.push_back(entry);
        identity &= entry == (r == c ? 1.0f : 0.0f);
      }
    if (!identity) node["matrix"] = std::move(matrix);
  }

  // Places the model's own nodes below the object's; each object gets copies, as a node has one
  // parent.
  void add_look(const Appearance& look, const Vec3& centre, GltfJson& node) {
    if (const GltfJson* mesh = only_mesh(look); mesh && centre.isZero()) {
      node["mesh"] = m_copier.copy_mesh(*look.document, *mesh);
      return;
    }
    GltfJson children = GltfJson::array();
    for (const int root : look.roots) children.push_back(m_copier.copy_tree(*look.document, root));
    if (!centre.isZero()) {
      GltfJson pivot = {{"name", kPivotName},
                        {"translation", {-centre.x(), -centre.y(), -centre.z()}}};
      if (!children.empty()) pivot["children"] = std::move(children);
      children = GltfJson::array({m_builder.add("nodes", std::move(pivot))});
    }
    if (!children.empty()) node["children"] = std::move(children);
  }

  // -1: no triangle; glTF has no empty mesh.
  int stored_mesh(const ExportObject& object) {
    const auto [entry, is_new] = m_stored.try_emplace(object.model.get(), -1);
    if (is_new && !object.model->mesh.triangles.empty())
      entry->second = add_mesh(*object.model, object.name);
    return entry->second;
  }

  int add_mesh(const Model& model, const std::string& name) {
    const std::vector<Eigen::Vector3f> positions = local_vertices(model).positions;
    const CornerNormals normals = shading_normals(model);
    GltfJson primitives = GltfJson::array();
    for (const MaterialFaces& group : faces_by_material(model)) {
      const PrimitiveData data = primitive_data(model.mesh, group.faces, positions, normals);
      const size_t position = m_builder.add_positions(floats_of(data.positions));
      const size_t normal = m_builder.add_floats(floats_of(data.normals), 3);
      primitives.push_back(
          {{"attributes", {{"POSITION", position}, {"NORMAL", normal}}},
           {"indices", m_builder.add_indices(data.indices)},
           {"material", m_builder.add("materials",
                                      material_json(material_or_default(model, group.material)))}});
    }
    return static_cast<int>(
        m_builder.add("meshes", {{"name", name}, {"primitives", std::move(primitives)}}));
  }

  GltfBuilder m_builder;
  GltfCopier m_copier;
  std::map<const Model*, int> m_stored;
};

}  // namespace

GltfJson material_json(const Material& material) {
  const auto unit = [](float x) { return std::clamp(x, 0.0f, 1.0f); };
  const auto& c = material.base_colour;
  GltfJson out = GltfJson::object();
  if (!material.name.empty()) out["name"] = material.name;
  out["pbrMetallicRoughness"] = {
      {"baseColorFactor", {unit(c[0]), unit(c[1]), unit(c[2]), unit(c[3])}},
      {"metallicFactor", unit(material.metallic)},
      {"roughnessFactor", unit(material.roughness)}};
  if (c[3] < 1) out["alphaMode"] = "BLEND";
  out["doubleSided"] = true;  // raw meshes are open, and wound as it happens
  return out;
}

GltfDocument gltf_document(const ExportScene& scene) { return SceneWriter().write(scene); }

}  // namespace trivet
