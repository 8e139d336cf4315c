#include "core/io/gltf/materials.h"

#include <algorithm>
#include <set>

#include "core/io/gltf/values.h"

namespace trivet {
namespace {

float share_or_one(const GltfJson& value) { return std::clamp(number_or(value, 1.0f), 0.0f, 1.0f); }

// Children in order, then their parent.
std::vector<int> nodes_upwards(const GltfJson& root, const std::vector<int>& roots) {
  std::vector<int> out, open = roots;
  while (!open.empty()) {
    const int node = open.back();
    open.pop_back();
    out.push_back(node);
    for (const GltfJson& child :
         member(element(root, "nodes", GltfJson(static_cast<unsigned>(node))), "children"))
      open.push_back(static_cast<int>(index_from(child)));
  }
  std::reverse(out.begin(), out.end());
  return out;
}

}  // namespace

Material gltf_material(const GltfJson& json) {
  Material out;
  out.name = name_of(json);
  const GltfJson& pbr = member(json, "pbrMetallicRoughness");
  const GltfJson& colour = member(pbr, "baseColorFactor");
  for (size_t i = 0; i < 4; ++i)
    out.base_colour[i] = colour.is_array() && i < colour.size() ? share_or_one(colour[i]) : 1.0f;
  out.metallic = share_or_one(member(pbr, "metallicFactor"));
  out.roughness = share_or_one(member(pbr, "roughnessFactor"));
  return out;
}

GltfMaterials::GltfMaterials(const GltfJson& root, const std::vector<int>& roots) : m_root(root) {
  std::set<size_t> seen;
  for (const int node : nodes_upwards(root, roots)) {
    const GltfJson& mesh = member(root["nodes"][static_cast<size_t>(node)], "mesh");
    if (!mesh.is_null() && seen.insert(index_from(mesh)).second)
      add_mesh(element(root, "meshes", mesh));
  }
  m_plain = static_cast<Index>(m_materials.size());
  m_materials.push_back(gltf_material(GltfJson::object()));
}

void GltfMaterials::add_mesh(const GltfJson& mesh) {
  for (const GltfJson& primitive : member(mesh, "primitives")) {
    const GltfJson& id = member(primitive, "material");
    if (id.is_null()) continue;
    const auto next = static_cast<Index>(m_materials.size());
    if (m_ids.try_emplace(index_from(id), next).second)
      m_materials.push_back(gltf_material(element(m_root, "materials", id)));
  }
}

Index GltfMaterials::of(const GltfJson& primitive) const {
  const GltfJson& id = member(primitive, "material");
  return id.is_null() ? m_plain : m_ids.at(index_from(id));
}

}  // namespace trivet
