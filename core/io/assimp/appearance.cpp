#include "core/io/assimp/appearance.h"

#include <assimp/material.h>
#include <assimp/metadata.h>
#include <assimp/scene.h>

#include <algorithm>
#include <cmath>

#include "core/io/colour.h"

namespace trivet {
namespace {

// Version 1; glTF 2 has a reader of its own.
bool is_gltf(const Model& model) { return model.format == "gltf"; }

bool get(const aiMaterial& material, const char* key, unsigned type, unsigned index, float& out) {
  return material.Get(key, type, index, out) == aiReturn_SUCCESS;
}

bool get(const aiMaterial& material, const char* key, unsigned type, unsigned index,
         aiColor4D& out) {
  return material.Get(key, type, index, out) == aiReturn_SUCCESS;
}

// Stated by PBR formats; else derived from the highlight's exponent (alpha = roughness squared),
// provided the highlight has a colour.
float roughness_of(const aiMaterial& material, float otherwise) {
  float value = 0;
  if (get(material, AI_MATKEY_ROUGHNESS_FACTOR, value)) return unit_interval(value, otherwise);
  aiColor4D specular;
  if (!get(material, AI_MATKEY_SHININESS, value) || !(value > 1)) return otherwise;
  if (!get(material, AI_MATKEY_COLOR_SPECULAR, specular) || specular.IsBlack()) return otherwise;
  return unit_interval(std::pow(2.0f / (value + 2.0f), 0.25f), otherwise);
}

Material material_of(const aiMaterial& material, bool linear_colours) {
  Material out;
  aiString name;
  if (material.Get(AI_MATKEY_NAME, name) == aiReturn_SUCCESS) out.name = name.C_Str();

  aiColor4D colour;
  if (get(material, AI_MATKEY_BASE_COLOR, colour) ||
      get(material, AI_MATKEY_COLOR_DIFFUSE, colour)) {
    const float rgb[3] = {colour.r, colour.g, colour.b};
    for (int i = 0; i < 3; ++i) {
      const float value = unit_interval(rgb[i], out.base_colour[i]);
      out.base_colour[i] = linear_colours ? value : linear_from_srgb(value);
    }
    if (linear_colours) out.base_colour[3] = unit_interval(colour.a, 1.0f);
  }
  // Opacity 0 is a common exporter's error about the meaning of `d`, not an invisible object.
  float opacity = 1;
  if (!linear_colours && get(material, AI_MATKEY_OPACITY, opacity) && opacity > 0)
    out.base_colour[3] = unit_interval(opacity, 1.0f);

  float metallic = 0;
  if (get(material, AI_MATKEY_METALLIC_FACTOR, metallic))
    out.metallic = unit_interval(metallic, out.metallic);
  out.roughness = roughness_of(material, out.roughness);
  return out;
}

// FBX: assimp 5.2 passes the settings as metadata and leaves the coordinates unchanged.
void read_fbx_frame(const aiScene& scene, Model& model) {
  if (!scene.mMetaData) return;
  std::int32_t axis = 1, sign = 1;
  if (scene.mMetaData->Get("UpAxis", axis)) {
    scene.mMetaData->Get("UpAxisSign", sign);
    if (sign > 0 && (axis == 1 || axis == 2)) {
      model.up = axis == 1 ? UpAxis::Y : UpAxis::Z;
      model.up_from_format = true;
    } else {
      model.notes.push_back("the file's up axis is neither +y nor +z; z is assumed");
    }
  }
  float centimetres = 0;
  if (!scene.mMetaData->Get("UnitScaleFactor", centimetres)) return;
  // Most state 1, 2.54 or 100: float32 digits behind these are none of the file's.
  const double metres = std::round(static_cast<double>(centimetres) * 1e6) / 1e8;
  if (metres >= 1e-8 && metres <= 1e8)
    model.metres_per_unit = metres;
  else
    model.notes.push_back("the unit of the file is out of range, and left out");
}

}  // namespace

void read_materials(const aiScene& scene, Model& model) {
  for (unsigned i = 0; i < scene.mNumMaterials; ++i)
    model.materials.push_back(material_of(*scene.mMaterials[i], is_gltf(model)));
  if (model.materials.empty()) model.materials.emplace_back();
}

// Conventions of assimp 5.2 (observed; test_import_frames guards them): glTF is y up and in metres
// by its standard; the Collada importer turns any up_axis to y and scales <unit> to metres in the
// root node's matrix; the 3DS importer turns z to y in the root node's matrix; FBX is left as in
// the file. The other formats state no frame: z is assumed, and the user decides.
void read_frame(const aiScene& scene, Model& model) {
  if (is_gltf(model) || model.format == "dae") {
    model.up = UpAxis::Y;
    model.up_from_format = true;
    model.metres_per_unit = 1.0;
  } else if (model.format == "3ds") {
    model.up = UpAxis::Y;
    model.up_from_format = true;
  } else if (model.format == "fbx") {
    read_fbx_frame(scene, model);
  }
}

}  // namespace trivet
