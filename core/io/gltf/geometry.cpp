#include "core/io/gltf/geometry.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/bad_input.h"
#include "core/base/error.h"
#include "core/base/printable.h"
#include "core/io/gltf/instances.h"
#include "core/io/gltf/materials.h"
#include "core/io/gltf/values.h"
#include "core/io/mesh/assembly.h"

namespace trivet {
namespace {

/// Counts of file contents that the model omits, or has otherwise.
struct Counts {
  std::uint64_t points = 0, lines = 0, left_over = 0, without_positions = 0, other_normals = 0,
                skinned = 0, morphed = 0, mirrored = 0, hidden = 0;
};

std::span<const Eigen::Vector3f> rows(const GltfValues& values) {
  if (values.num_components != 3) bad_input("positions and normals that are no vectors of 3");
  static_assert(sizeof(Eigen::Vector3f) == 3 * sizeof(float));
  return {reinterpret_cast<const Eigen::Vector3f*>(values.values.data()), values.size()};
}

class GeometryReader {
 public:
  GeometryReader(const GltfDocument& document, const std::vector<int>& roots,
                 const ImportLimits& limits, Model& model)
      : m_document(document),
        m_limits(limits),
        m_model(model),
        m_tree(gltf_tree(document.json, roots)),
        m_materials(document.json, roots),
        m_assembly(model, limits) {}

  void read() {
    m_model.num_nodes = static_cast<int>(m_tree.nodes.size());
    m_assembly.expect(num_triangles());
    for (const GltfInstance& instance : m_tree.instances) read(instance);
    for (const int node : m_tree.nodes) m_counts.hidden += is_hidden(node);
    m_model.materials = m_materials.take();
    note_counts();
    m_assembly.finish(true);
    note_rounded_places();
  }

 private:
  const GltfJson& node_of(const GltfInstance& instance) const {
    return m_document.json["nodes"][static_cast<size_t>(instance.node)];
  }
  const GltfJson& mesh_of(const GltfInstance& instance) const {
    return element(m_document.json, "meshes", node_of(instance)["mesh"]);
  }

  bool is_hidden(int node) const {
    const GltfJson& json = m_document.json["nodes"][static_cast<size_t>(node)];
    const GltfJson& extension = member(member(json, "extensions"), "KHR_node_visibility");
    return member(extension, "visible") == false;
  }

  static bool has_positions(const GltfJson& primitive) {
    return !member(member(primitive, "attributes"), "POSITION").is_null();
  }

  // Stops beyond the limit, so that sums of hostile counts cannot overflow.
  std::uint64_t num_triangles() const {
    std::uint64_t sum = 0;
    for (const GltfInstance& instance : m_tree.instances)
      for (const GltfJson& primitive : member(mesh_of(instance), "primitives")) {
        if (has_positions(primitive)) sum += count_faces(m_document.json, primitive).triangles;
        if (sum > static_cast<std::uint64_t>(m_limits.max_triangles)) return sum;
      }
    return sum;
  }

  std::string name_of_mesh(const GltfInstance& instance) const {
    const GltfJson& node = node_of(instance);
    for (const std::string& name : {name_of(mesh_of(instance)), name_of(node)})
      if (!name.empty()) return printable(name, 100);
    return "number " + std::to_string(index_from(node["mesh"]));
  }

  void read(const GltfInstance& instance) {
    const std::string name = name_of_mesh(instance);
    m_counts.skinned += node_of(instance).contains("skin");
    m_counts.mirrored += mirrors(instance.object_from_mesh);
    size_t number = 0;
    bool morphed = false;
    for (const GltfJson& primitive : member(mesh_of(instance), "primitives")) {
      try {
        read_primitive(instance, name, primitive);
      } catch (const Error& e) {
        const std::string what = e.what();
        if (what.rfind("mesh '", 0) == 0) throw;
        bad_input("mesh '%1', primitive %2: %3", name, number, what);
      }
      morphed |= !member(primitive, "targets").empty();
      ++number;
    }
    m_counts.morphed += morphed;
  }

  void read_primitive(const GltfInstance& instance, const std::string& name,
                      const GltfJson& primitive) {
    if (!has_positions(primitive)) {
      ++m_counts.without_positions;
      return;
    }
    const GltfFaces faces = count_faces(m_document.json, primitive);
    m_counts.points += faces.points;
    m_counts.lines += faces.lines;
    m_counts.left_over += faces.left_over;
    if (faces.triangles == 0) return;
    const GltfJson& attributes = primitive["attributes"];
    MeshVertices vertices{name, rows(values_of(attributes["POSITION"])), {}};
    if (const GltfJson& id = member(attributes, "NORMAL"); !id.is_null())
      vertices.normals = rows(values_of(id));
    if (vertices.normals.size() != vertices.positions.size()) {
      m_counts.other_normals += !vertices.normals.empty();
      vertices.normals = {};
    }
    m_assembly.place(vertices, instance.object_from_mesh);
    const Index material = m_materials.of(primitive);
    for (const auto& corners : gltf_triangles(m_document, primitive, vertices.positions.size()))
      m_assembly.add(corners, material);
  }

  // Primitives share accessors, and nodes share meshes.
  const GltfValues& values_of(const GltfJson& accessor) {
    const auto [found, is_new] = m_values.try_emplace(index_from(accessor));
    if (is_new) found->second = gltf_values(m_document, accessor);
    return found->second;
  }

  void note(const Sentence& what, std::uint64_t count) {
    if (count > 0) m_model.notes.push_back(say("%1: %2", what, count));
  }

  void note_counts() {
    note("points left out", m_counts.points);
    note("lines left out", m_counts.lines);
    note("vertices left out, too few for another triangle", m_counts.left_over);
    note("primitives left out, as they have no positions", m_counts.without_positions);
    note("normals left out, as they are not one to each vertex", m_counts.other_normals);
    note("meshes with bones, read in bind pose", m_counts.skinned);
    note("meshes with morph targets, read without them", m_counts.morphed);
    note("mirrored meshes, winding turned round", m_counts.mirrored);
    note("hidden nodes, read like all others", m_counts.hidden);
  }

  // Places of nodes are numbers of text, which matrices of float32 cannot all hold.
  void note_rounded_places() {
    constexpr double kVisible = 1e-6;  // of the model's size
    double most = 0;
    for (const int node : m_tree.nodes)
      for (const GltfJson& number :
           member(m_document.json["nodes"][static_cast<size_t>(node)], "translation"))
        most = std::max(most,
                        std::abs(number.get<double>() - static_cast<double>(number.get<float>())));
    if (most > kVisible * m_model.mesh.box().diagonal())
      m_model.notes.push_back(
          say("places of nodes are read as float32: digits are lost, up to %1", figure(most, 2)));
  }

  const GltfDocument& m_document;
  const ImportLimits& m_limits;
  Model& m_model;
  const GltfTree m_tree;
  GltfMaterials m_materials;
  ModelAssembly m_assembly;
  Counts m_counts;
  std::map<size_t, GltfValues> m_values;
};

}  // namespace

void read_gltf_geometry(const GltfDocument& document, const std::vector<int>& roots,
                        const ImportLimits& limits, Model& model) {
  GeometryReader(document, roots, limits, model).read();
}

}  // namespace trivet
