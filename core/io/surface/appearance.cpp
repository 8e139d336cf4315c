#include "core/io/surface/appearance.h"

#include <cmath>

#include "core/base/error.h"
#include "core/io/appearance.h"
#include "core/io/colour.h"
#include "core/io/gltf/row_set.h"
#include "core/io/textures/texture_adder.h"
#include "core/io/writers.h"
#include "core/model/exported_floats.h"

namespace trivet {
namespace {

// v runs up in files and down in glTF.
GltfJson transform_of(const FileTexture& t) {
  const bool identity = t.scale == std::array<float, 2>{1, 1} && t.offset == std::array<float, 2>{};
  if (identity || !std::isfinite(t.scale[0] + t.scale[1] + t.offset[0] + t.offset[1])) return {};
  return {{"offset", {t.offset[0], 1 - t.scale[1] - t.offset[1]}},
          {"scale", {t.scale[0], t.scale[1]}}};
}

class AppearanceMaker {
 public:
  AppearanceMaker(const FileSurface& surface, const std::vector<Index3>& triangles,
                  const ImportLimits& limits, Model& model)
      : m_surface(surface),
        m_triangles(triangles),
        m_model(model),
        m_textures(surface.path, limits, m_builder, model.notes) {}

  std::shared_ptr<const Appearance> make(const std::vector<std::pair<Index, size_t>>& part_ends) {
    const Aabb box = m_model.mesh.box();
    // As export_centre() of a model with an appearance.
    m_model.appearance = std::make_shared<const Appearance>();
    m_centre = export_centre(&m_model, box);
    m_normals = shading_normals(m_model);
    size_t begin = 0;
    for (size_t i = 0; i < part_ends.size(); ++i) {
      const FilePart& part = m_surface.parts()[part_ends[i].first];
      add_primitive(part.material, begin, part_ends[i].second);
      begin = part_ends[i].second;
      const bool last =
          i + 1 == part_ends.size() || m_surface.parts()[part_ends[i + 1].first].node != part.node;
      if (last) add_node(part.node);
    }
    m_look.document = std::make_shared<const GltfDocument>(m_builder.take(GltfJson::object()));
    return std::make_shared<const Appearance>(std::move(m_look));
  }

 private:
  void add_primitive(Index material, size_t begin, size_t end) {
    const bool mapped = any(begin, end, &FileCorner::coordinate);
    const bool coloured = any(begin, end, &FileCorner::colour);
    RowSet rows(6 + (mapped ? 2 : 0) + (coloured ? 4 : 0));
    std::vector<std::uint32_t> indices;
    std::vector<float> row;
    for (size_t f = begin; f < end; ++f)
      for (int k = 0; k < 3; ++k) {
        fill(row, f, k, mapped, coloured);
        indices.push_back(rows.add(row));
      }
    GltfJson attributes = {{"POSITION", m_builder.add_positions(rows.columns(0, 3))},
                           {"NORMAL", m_builder.add_floats(rows.columns(3, 3), 3)}};
    if (mapped) attributes["TEXCOORD_0"] = m_builder.add_floats(rows.columns(6, 2), 2);
    if (coloured) attributes["COLOR_0"] = m_builder.add_floats(rows.columns(mapped ? 8 : 6, 4), 4);
    m_primitives.push_back({{"attributes", std::move(attributes)},
                            {"indices", m_builder.add_indices(indices)},
                            {"material", material_id(material)}});
  }

  bool any(size_t begin, size_t end, Index FileCorner::*member) const {
    for (size_t f = begin; f < end; ++f)
      for (const Index corner : m_triangles[f])
        if (m_surface.corners[corner].*member >= 0) return true;
    return false;
  }

  void fill(std::vector<float>& row, size_t f, int k, bool mapped, bool coloured) const {
    const FileCorner& corner = m_surface.corners[m_triangles[f][k]];
    const Eigen::Vector3f& n = m_normals[f][static_cast<size_t>(k)];
    const Vec3 p = m_surface.positions[corner.position] - m_centre;
    row.clear();
    for (int i = 0; i < 3; ++i) row.push_back(static_cast<float>(p[i]) + 0.0f);
    for (int i = 0; i < 3; ++i) row.push_back(n[i]);
    if (mapped) {
      const Eigen::Vector2f at = corner.coordinate < 0 ? Eigen::Vector2f(Eigen::Vector2f::Zero())
                                                       : m_surface.coordinates[corner.coordinate];
      row.push_back(finite_or_zero(at.x()));
      row.push_back(finite_or_zero(1 - at.y()));
    }
    if (!coloured) return;
    const Eigen::Vector4f c = corner.colour < 0 ? Eigen::Vector4f(Eigen::Vector4f::Ones())
                                                : m_surface.colours[corner.colour];
    for (int i = 0; i < 3; ++i) row.push_back(linear_from_srgb(finite_or_zero(c[i])));
    row.push_back(std::isfinite(c[3]) ? std::clamp(c[3], 0.0f, 1.0f) : 1.0f);
  }

  void add_node(Index node) {
    const std::string& name = m_surface.nodes[node];
    GltfJson mesh = {{"primitives", std::exchange(m_primitives, GltfJson::array())}};
    GltfJson json = GltfJson::object();
    if (!name.empty()) mesh["name"] = json["name"] = name;
    if (!m_centre.isZero(0)) json["translation"] = {m_centre.x(), m_centre.y(), m_centre.z()};
    json["mesh"] = m_builder.add("meshes", std::move(mesh));
    m_look.roots.push_back(static_cast<int>(m_builder.add("nodes", std::move(json))));
  }

  size_t material_id(Index material) {
    const auto [entry, is_new] = m_materials.try_emplace(material, 0);
    if (is_new) entry->second = m_builder.add("materials", converted(material));
    return entry->second;
  }

  GltfJson converted(Index id) {
    GltfJson out = material_json(material_or_default(m_model, id));
    if (static_cast<size_t>(id) >= m_surface.materials.size()) return out;
    const FileMaterial& material = m_surface.materials[id];
    GltfJson& pbr = out["pbrMetallicRoughness"];
    put(pbr, "baseColorTexture", material.base_colour);
    if (pbr.contains("baseColorTexture")) {
      // The colour multiplies the texture: black is an exporter's error.
      GltfJson& factor = pbr["baseColorFactor"];
      if (factor[0] == 0 && factor[1] == 0 && factor[2] == 0)
        for (int i = 0; i < 3; ++i) factor[i] = 1;
    }
    put(out, "normalTexture", material.normal);
    put(out, "emissiveTexture", material.emissive);
    std::array<float, 3> emission = material.emission;
    if (out.contains("emissiveTexture") && emission == std::array<float, 3>{}) emission = {1, 1, 1};
    if (emission != std::array<float, 3>{}) out["emissiveFactor"] = emission;
    if (material.cut_by_texture && material.base_colour) out["alphaMode"] = "BLEND";
    return out;
  }

  void put(GltfJson& where, const char* key, const std::optional<FileTexture>& texture) {
    if (!texture) return;
    const SharedBytes bytes = m_textures.file(texture->name, texture->folder);
    if (!bytes) return;
    const int wrap = texture->clamps ? gltf::kClamp : gltf::kRepeat;
    where[key] = m_textures.add({texture->name, bytes, wrap, wrap, 0, transform_of(*texture)});
  }

  const FileSurface& m_surface;
  const std::vector<Index3>& m_triangles;
  Model& m_model;
  GltfBuilder m_builder;
  TextureAdder m_textures;
  CornerNormals m_normals;
  Vec3 m_centre = Vec3::Zero();
  Appearance m_look;
  GltfJson m_primitives = GltfJson::array();
  std::map<Index, size_t> m_materials;
};

bool has_more(const FileSurface& surface, const std::vector<Index3>& triangles) {
  for (const FilePart& part : surface.parts())
    if (part.node != surface.parts().front().node) return true;
  for (const Index3& t : triangles)
    for (const Index corner : t)
      if (surface.corners[corner].coordinate >= 0 || surface.corners[corner].colour >= 0)
        return true;
  return false;
}

}  // namespace

std::shared_ptr<const Appearance> appearance_of_surface(
    const FileSurface& surface, const std::vector<Index3>& triangles,
    const std::vector<std::pair<Index, size_t>>& part_ends, const ImportLimits& limits,
    Model& model) {
  if (!has_more(surface, triangles)) return nullptr;
  try {
    return AppearanceMaker(surface, triangles, limits, model).make(part_ends);
  } catch (const Error& e) {
    model.appearance = nullptr;
    model.notes.push_back(say("hierarchy and textures left out: %1", e.sentence()));
    return nullptr;
  }
}

}  // namespace trivet
