#include "core/io/assimp/materials.h"

#include <assimp/material.h>
#include <assimp/scene.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "core/io/appearance.h"
#include "core/io/colour.h"
#include "core/io/writers.h"

namespace trivet {
namespace {

namespace fs = std::filesystem;

constexpr int kRepeat = 10497, kClamp = 33071, kMirror = 33648;  // of the glTF specification

int wrap_of(const aiMaterial& material, const char* key, unsigned kind, unsigned index) {
  int mode = aiTextureMapMode_Wrap;
  material.Get(key, kind, index, mode);
  return mode == aiTextureMapMode_Mirror ? kMirror
         : mode == aiTextureMapMode_Wrap ? kRepeat
                                         : kClamp;
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
    : m_scene(scene), m_limits(limits), m_model(model), m_builder(builder), m_folder(model.path) {}

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
    // OBJ multiplies by its colour, so black is an exporter's error; in other formats the texture
    // replaces the colour.
    GltfJson& factor = pbr["baseColorFactor"];
    const bool black = factor[0] == 0 && factor[1] == 0 && factor[2] == 0;
    if (black || m_model.format != "obj")
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
    if (material.GetTextureCount(kind)) note(say("left out: %1", Sentence(what)));
  return out;
}

GltfJson MaterialConverter::texture(const aiMaterial& material, int kind_number) {
  const auto kind = static_cast<aiTextureType>(kind_number);
  aiString path;
  if (!material.GetTextureCount(kind) || material.GetTexture(kind, 0, &path) != aiReturn_SUCCESS)
    return {};
  const SharedBytes bytes = image_bytes(path.C_Str());
  if (!bytes) return {};
  const GltfJson sampler = {{"wrapS", wrap_of(material, AI_MATKEY_MAPPINGMODE_U(kind, 0))},
                            {"wrapT", wrap_of(material, AI_MATKEY_MAPPINGMODE_V(kind, 0))}};
  const auto add_once = [&](std::map<GltfJson, size_t>& known, const char* list,
                            const GltfJson& item) {
    const auto [entry, is_new] = known.try_emplace(item, 0);
    if (is_new) entry->second = m_builder.add(list, item);
    return entry->second;
  };
  std::string name = path.C_Str();
  std::replace(name.begin(), name.end(), '\\', '/');
  const size_t image = m_builder.add_image(
      {{"name", fs::path(name).stem().string()}, {"mimeType", image_type(*bytes)}}, bytes);
  GltfJson shown = {{"sampler", add_once(m_samplers, "samplers", sampler)}};
  if (image_type(*bytes) == "image/webp") {
    shown["extensions"]["EXT_texture_webp"]["source"] = image;
    m_builder.use_extension("EXT_texture_webp", true);
  } else {
    shown["source"] = image;
  }
  GltfJson out = {{"index", add_once(m_textures, "textures", shown)}};
  int coordinates = 0;
  if (material.Get(AI_MATKEY_UVWSRC(kind, 0), coordinates) == aiReturn_SUCCESS && coordinates > 0 &&
      coordinates < AI_MAX_NUMBER_OF_TEXTURECOORDS)
    out["texCoord"] = coordinates;
  if (GltfJson transform = transform_of(material, kind); !transform.is_null()) {
    out["extensions"]["KHR_texture_transform"] = std::move(transform);
    m_builder.use_extension("KHR_texture_transform", false);
  }
  return out;
}

SharedBytes MaterialConverter::image_bytes(const std::string& path) {
  const auto [entry, is_new] = m_images.try_emplace(path, nullptr);
  if (!is_new) return entry->second;
  if (const aiTexture* embedded = m_scene.GetEmbeddedTexture(path.c_str())) {
    // Height 0: a complete, encoded image file.
    if (embedded->mHeight == 0 && embedded->pcData)
      entry->second = std::make_shared<const std::string>(
          reinterpret_cast<const char*>(embedded->pcData), embedded->mWidth);
    if (entry->second && image_type(*entry->second).empty()) entry->second = nullptr;
  } else {
    entry->second = file_bytes(path);
  }
  if (!entry->second)
    note(say(
        "left out: the texture \"%1\", missing, outside the model's folder, or neither PNG, JPEG "
        "nor WebP",
        path));
  return entry->second;
}

// Looked up at the stated path, else beside the model: models get moved, and their paths break.
SharedBytes MaterialConverter::file_bytes(const std::string& path) const {
  std::string relative = path;
  std::replace(relative.begin(), relative.end(), '\\', '/');
  const fs::path folder = fs::path(m_model.path).parent_path();
  for (const fs::path& candidate : {folder / relative, folder / fs::path(relative).filename(),
                                    folder / "textures" / fs::path(relative).filename()}) {
    std::error_code error;
    if (!m_folder.has(candidate)) continue;
    const std::uintmax_t size = fs::file_size(candidate, error);
    if (error || size == 0 || size > m_limits.max_file_bytes) continue;
    std::string bytes(size, '\0');
    std::ifstream file(candidate, std::ios::binary);
    if (!file.read(bytes.data(), static_cast<std::streamsize>(size))) continue;
    // Passes on images only, whatever an untrusted file's path points to.
    if (!image_type(bytes).empty()) return std::make_shared<const std::string>(std::move(bytes));
  }
  return nullptr;
}

void MaterialConverter::note(const Sentence& note) {
  auto& notes = m_model.notes;
  const std::string text = in_english(note);
  const auto says_it = [&](const Sentence& other) { return in_english(other) == text; };
  if (std::none_of(notes.begin(), notes.end(), says_it)) notes.push_back(note);
}

}  // namespace trivet
