#include "core/io/assimp/appearance.h"

#include <assimp/material.h>
#include <assimp/metadata.h>
#include <assimp/scene.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstring>

#include "core/base/bad_input.h"
#include "core/io/assimp/stated_units.h"
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

// The digits that a float32 has of a number in a text.
double decimal_from(float value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.7g", static_cast<double>(value));
  double out = 0;
  std::from_chars(text, text + std::strlen(text), out);
  return out;
}

void set_unit(double metres, Model& model) {
  if (metres >= 1e-8 && metres <= 1e8)
    model.metres_per_unit = metres;
  else
    model.notes.push_back("the unit of the file is out of range, and left out");
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
  set_unit(decimal_from(centimetres) / 100, model);
}

// Collada: assimp 5.2 multiplies the unit into the root, whose matrix turns the up axis to y. It is
// taken out again: then it is applied where units of other formats are, or another one is given.
void read_collada_frame(aiScene& scene, Model& model) {
  model.up = UpAxis::Y;
  model.up_from_format = true;
  aiMatrix4x4& root = scene.mRootNode->mTransformation;
  if (!(root.Determinant() > 0)) bad_file(model.path, "its unit is not above 0 metres");
  float unit = 0;
  for (unsigned r = 0; r < 3; ++r) unit = std::max(unit, std::abs(root[r][0]));
  const auto is_turn = [&](float entry) { return entry == 0 || std::abs(entry) == unit; };
  for (unsigned r = 0; r < 3; ++r)
    for (unsigned c = 0; c < 3; ++c)
      if (!is_turn(root[r][c])) return set_unit(1, model);
  for (unsigned r = 0; r < 3; ++r)
    for (unsigned c = 0; c < 3; ++c) root[r][c] /= unit;
  set_unit(decimal_from(unit), model);
}

}  // namespace

void read_materials(const aiScene& scene, Model& model) {
  for (unsigned i = 0; i < scene.mNumMaterials; ++i)
    model.materials.push_back(material_of(*scene.mMaterials[i], is_gltf(model)));
  if (model.materials.empty()) model.materials.emplace_back();
}

// Conventions of assimp 5.2 (observed; test_import_frames guards them): glTF is y up and in metres
// by its standard; the Collada importer turns any up_axis to y and scales <unit> to metres in the
// root node's matrix, which read_collada_frame() undoes; the 3DS importer turns z to y in the root
// node's matrix; FBX is left as in the file; X3D is y up and AMF z up by their standards. The other
// formats state no frame: z is assumed, and the user decides.
void read_frame(aiScene& scene, std::string_view head, Model& model) {
  if (model.format == "dae") {
    read_collada_frame(scene, model);
  } else if (is_gltf(model)) {
    model.up = UpAxis::Y;
    model.up_from_format = true;
    model.metres_per_unit = 1.0;
  } else if (model.format == "3ds") {
    model.up = UpAxis::Y;
    model.up_from_format = true;
  } else if (model.format == "fbx") {
    read_fbx_frame(scene, model);
  } else if (const auto unit = stated_unit(model.format, head)) {
    set_unit(*unit, model);
    model.up = model.format == "x3d" ? UpAxis::Y : UpAxis::Z;
    model.up_from_format = model.format != "dxf";
  }
}

}  // namespace trivet
