// Materials of glTF as numbers. Private: exposes the JSON library.
#pragma once

#include <map>
#include <vector>

#include "core/io/gltf/document.h"
#include "core/model/model.h"

namespace trivet {

/// Factors without textures; colours are linear.
Material gltf_material(const GltfJson& material);

/// The materials that are used below some nodes, numbered by their first use on the way up
/// (children before their parents), and one of primitives that have none.
class GltfMaterials {
 public:
  GltfMaterials(const GltfJson& root, const std::vector<int>& roots);

  std::vector<Material> take() { return std::move(m_materials); }
  /// @throws Error (BadInput): no such material.
  Index of(const GltfJson& primitive) const;

 private:
  void add_mesh(const GltfJson& mesh);

  const GltfJson& m_root;
  std::vector<Material> m_materials;
  std::map<size_t, Index> m_ids;
  Index m_plain = 0;
};

}  // namespace trivet
