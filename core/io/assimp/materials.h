// Conversion of an assimp scene's materials and textures to glTF. Private: exposes the JSON
// library.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/io/gltf/builder.h"
#include "core/io/textures/texture_adder.h"

struct aiScene;
struct aiMaterial;

namespace trivet {

/// Where a texture may lie that a model names: at the stated path, else beside the model, as models
/// get moved, and their paths break.
std::vector<std::filesystem::path> places_of_texture(const std::string& model,
                                                     const std::string& texture);
/// Notes all textures that the materials name, whether they are shown or not.
void note_textures(const aiScene& scene, const std::string& model);

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

  const aiScene& m_scene;
  GltfBuilder& m_builder;
  Model& m_model;
  TextureAdder m_textures;
  std::map<unsigned, size_t> m_materials;
  std::map<std::string, SharedBytes> m_embedded;
};

}  // namespace trivet
