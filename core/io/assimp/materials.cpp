#include "core/io/assimp/materials.h"

#include <assimp/material.h>
#include <assimp/scene.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/io/appearance.h"
#include "core/io/colour.h"
#include "core/io/model_folder.h"
#include "core/io/opened_files.h"
#include "core/io/writers.h"

namespace trivet {
namespace {

namespace fs = std::filesystem;

int wrap_of(const aiMaterial& material, const char* key, unsigned kind, unsigned index) {
  int mode = aiTextureMapMode_Wrap;
  material.Get(key, kind, index, mode);
  return mode == aiTextureMapMode_Mirror ? gltf::kMirror
         : mode == aiTextureMapMode_Wrap ? gltf::kRepeat
                                         : gltf::kClamp;
}

// v runs up in assimp and down in glTF.
GltfJson transform_of(const aiMaterial& material, aiTextureType kind) {
  aiUVTransform t;
  if (material.Get(AI_MATKEY_UVTRANSFORM(kind, 0), t) != aiReturn_SUCCESS || t.mRotation != 0)
    return {};
  const bool identity = t.mScaling == aiVector2D(1, 1) && t.mTranslation == aiVector2D(0, 0);
  if (identity || !std::isfinite(t.mScaling.x + t.mScaling.y + t.mTranslation.x + t.mTranslation.y))
    return {};
  return {{"offset", {t.mTranslation.x, 1 - t.mScaling.y - t.mTranslation.y}},
          {"scale", {t.mScaling.x, t.mScaling.y}}};
}

bool has_base_texture(const aiMaterial& material) {
  return material.GetTextureCount(aiTextureType_BASE_COLOR) ||
         material.GetTextureCount(aiTextureType_DIFFUSE);
}

GltfJson emissive_of(const aiMaterial& material, bool textured) {
  aiColor3D colour(0, 0, 0);
  material.Get(AI_MATKEY_COLOR_EMISSIVE, colour);
  if (textured && colour.IsBlack()) colour = {1, 1, 1};
  GltfJson out = GltfJson::array();
  bool black = true;
  for (const float c : {colour.r, colour.g, colour.b}) {
    out.push_back(std::isfinite(c) ? linear_from_srgb(c) : 0.0f);
    black &= !(c > 0);
  }
  return black ? GltfJson() : out;
}

}  // namespace

MaterialConverter::MaterialConverter(const aiScene& scene, const ImportLimits& limits, Model& model,
                                     GltfBuilder& builder)
    : m_scene(scene),
      m_builder(builder),
      m_model(model),
      m_textures(model.path, limits, builder, model.notes) {}

size_t MaterialConverter::material(unsigned id) {
  if (id >= m_scene.mNumMaterials) id = 0;
  const auto [entry, is_new] = m_materials.try_emplace(id, 0);
  if (is_new) entry->second = m_builder.add("materials", converted(id));
  return entry->second;
}

GltfJson MaterialConverter::converted(unsigned id) {
  GltfJson out = material_json(material_or_default(m_model, static_cast<Index>(id)));
  if (id >= m_scene.mNumMaterials) return out;
  const aiMaterial& material = *m_scene.mMaterials[id];
  GltfJson& pbr = out["pbrMetallicRoughness"];
  const auto put = [&](GltfJson& where, const char* key, std::initializer_list<int> kinds) {
    for (const int kind : kinds)
      if (GltfJson found = texture(material, kind); !found.is_null()) {
        where[key] = std::move(found);
        return;
      }
  };
  put(pbr, "baseColorTexture", {aiTextureType_BASE_COLOR, aiTextureType_DIFFUSE});
  if (pbr.contains("baseColorTexture")) {
    GltfJson& factor = pbr["baseColorFactor"];  // which the texture replaces
    for (int i = 0; i < 3; ++i) factor[i] = 1;
  }
  put(out, "normalTexture", {aiTextureType_NORMALS, aiTextureType_NORMAL_CAMERA});
  put(out, "occlusionTexture", {aiTextureType_AMBIENT_OCCLUSION, aiTextureType_LIGHTMAP});
  put(out, "emissiveTexture", {aiTextureType_EMISSION_COLOR, aiTextureType_EMISSIVE});
  if (GltfJson emissive = emissive_of(material, out.contains("emissiveTexture"));
      !emissive.is_null())
    out["emissiveFactor"] = std::move(emissive);
  if (material.GetTextureCount(aiTextureType_OPACITY) && has_base_texture(material))
    out["alphaMode"] = "BLEND";
  for (const auto& [kind, what] :
       {std::pair(aiTextureType_HEIGHT, TRIVET_SENTENCE("bump maps")),
        std::pair(aiTextureType_METALNESS, TRIVET_SENTENCE("maps of metalness")),
        std::pair(aiTextureType_DIFFUSE_ROUGHNESS, TRIVET_SENTENCE("maps of roughness")),
        std::pair(aiTextureType_SPECULAR, TRIVET_SENTENCE("maps of specular colour"))})
    if (material.GetTextureCount(kind)) m_textures.note(say("left out: %1", Sentence(what)));
  return out;
}

GltfJson MaterialConverter::texture(const aiMaterial& material, int kind_number) {
  const auto kind = static_cast<aiTextureType>(kind_number);
  aiString path;
  if (!material.GetTextureCount(kind) || material.GetTexture(kind, 0, &path) != aiReturn_SUCCESS)
    return {};
  const SharedBytes bytes = image_bytes(path.C_Str());
  if (!bytes) return {};
  AddedTexture added{path.C_Str(),
                     bytes,
                     wrap_of(material, AI_MATKEY_MAPPINGMODE_U(kind, 0)),
                     wrap_of(material, AI_MATKEY_MAPPINGMODE_V(kind, 0)),
                     0,
                     transform_of(material, kind)};
  int coordinates = 0;
  if (material.Get(AI_MATKEY_UVWSRC(kind, 0), coordinates) == aiReturn_SUCCESS && coordinates > 0 &&
      coordinates < AI_MAX_NUMBER_OF_TEXTURECOORDS)
    added.set = coordinates;
  return m_textures.add(added);
}

std::vector<fs::path> places_of_texture(const std::string& model, const std::string& texture) {
  std::string relative = texture;
  std::replace(relative.begin(), relative.end(), '\\', '/');
  const fs::path folder = fs::path(model).parent_path(), name = fs::path(relative).filename();
  return {folder / relative, folder / name, folder / "textures" / name};
}

void note_textures(const aiScene& scene, const std::string& model) {
  const ModelFolder folder(model);
  for (unsigned i = 0; i < scene.mNumMaterials; ++i)
    for (int kind = aiTextureType_NONE; kind <= AI_TEXTURE_TYPE_MAX; ++kind) {
      const auto type = static_cast<aiTextureType>(kind);
      for (unsigned k = 0; k < scene.mMaterials[i]->GetTextureCount(type); ++k) {
        aiString name;
        if (scene.mMaterials[i]->GetTexture(type, k, &name) != aiReturn_SUCCESS) continue;
        for (const fs::path& place : places_of_texture(model, name.C_Str()))
          if (folder.has(place)) note_opened(model, {place.string()});
      }
    }
}

SharedBytes MaterialConverter::image_bytes(const std::string& path) {
  const aiTexture* const embedded = m_scene.GetEmbeddedTexture(path.c_str());
  if (!embedded) return m_textures.file(path);
  const auto [entry, is_new] = m_embedded.try_emplace(path, nullptr);
  if (!is_new) return entry->second;
  // Height 0: a complete, encoded image file.
  if (embedded->mHeight == 0 && embedded->pcData)
    entry->second = std::make_shared<const std::string>(
        reinterpret_cast<const char*>(embedded->pcData), embedded->mWidth);
  if (entry->second && image_type(*entry->second).empty()) entry->second = nullptr;
  if (!entry->second) m_textures.note_missing(path);
  return entry->second;
}

}  // namespace trivet
