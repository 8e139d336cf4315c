// Conversion of an assimp scene's materials and textures to glTF. Private: exposes the JSON
// library.
#pragma once

#include "core/base/sentence.h"
#include "core/io/gltf/builder.h"
#include "core/io/model_folder.h"

struct aiScene;
struct aiMaterial;

namespace trivet {

/// Adds materials to a glTF asset, each on first use.
class MaterialConverter {
 public:
  MaterialConverter(const aiScene& scene, const ImportLimits& limits, Model& model,
                    GltfBuilder& builder);
  size_t material(unsigned id);

 private:
  GltfJson converted(unsigned id);
  /// Reference to a texture of that kind (aiTextureType); null if there is none.
  GltfJson texture(const aiMaterial& material, int kind);
  SharedBytes image_bytes(const std::string& path);
  SharedBytes file_bytes(const std::string& path) const;
  void note(const Sentence& note);

  const aiScene& m_scene;
  const ImportLimits& m_limits;
  Model& m_model;
  GltfBuilder& m_builder;
  const ModelFolder m_folder;
  std::map<unsigned, size_t> m_materials;
  std::map<std::string, SharedBytes> m_images;
  std::map<GltfJson, size_t> m_samplers, m_textures;
};

}  // namespace trivet
