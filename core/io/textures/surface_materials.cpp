#include "core/io/textures/surface_materials.h"

#include <algorithm>
#include <cmath>

#include "core/io/gltf/materials.h"

namespace trivet {
namespace {

constexpr int kClampToEdge = 33071, kMirroredRepeat = 33648,
              kNearest = 9728;            // of the specification
constexpr float kMostSeenThrough = 0.9f;  // of glass, where it is drawn without rays
constexpr float kLeastIndex = 1.01f, kMostIndex = 3;
constexpr float kLeastLeft = 1e-3f;  // of light after the distance of attenuation

float share_or(const GltfJson& value, float otherwise) {
  return std::clamp(number_or(value, otherwise), 0.0f, 1.0f);
}

const GltfJson& item(const GltfJson& list, size_t i) {
  static const GltfJson none;
  return list.is_array() && i < list.size() ? list[i] : none;
}

TextureWrap wrap_from(const GltfJson& mode) {
  if (mode == kClampToEdge) return TextureWrap::Clamp;
  return mode == kMirroredRepeat ? TextureWrap::Mirror : TextureWrap::Repeat;
}

// Offset * rotation * scale; the rotation is counter-clockwise as the image is seen, v runs down.
void read_transform(const GltfJson& given, TextureUse& use) {
  const float x = number_or(item(member(given, "offset"), 0), 0);
  const float y = number_or(item(member(given, "offset"), 1), 0);
  const float sx = number_or(item(member(given, "scale"), 0), 1);
  const float sy = number_or(item(member(given, "scale"), 1), 1);
  const float angle = number_or(member(given, "rotation"), 0);
  const float c = std::cos(angle), s = std::sin(angle);
  use.transform = {{{c * sx, s * sy, x}, {-s * sx, c * sy, y}}};
}

// Images of how much passes, and of how thick it is, are left out.
Glass glass_from(const GltfJson& extensions, float metallic) {
  Glass out;
  const GltfJson& passes = member(extensions, "KHR_materials_transmission");
  out.share = share_or(member(passes, "transmissionFactor"), 0) * (1 - metallic);
  const float index = number_or(member(member(extensions, "KHR_materials_ior"), "ior"), 1.5f);
  out.index = std::clamp(index, kLeastIndex, kMostIndex);
  const GltfJson& volume = member(extensions, "KHR_materials_volume");
  const float reach = number_or(member(volume, "attenuationDistance"), 0);
  if (!(out.share > 0 && reach > 0)) return out;
  out.absorbed_per_unit.emplace();
  for (size_t i = 0; i < 3; ++i) {
    const float left = share_or(item(member(volume, "attenuationColor"), i), 1);
    (*out.absorbed_per_unit)[i] = -std::log(std::max(left, kLeastLeft)) / reach;
  }
  return out;
}

}  // namespace

const GltfJson& image_of_texture(const GltfJson& texture) {
  const auto source = [&](const char* extension) -> const GltfJson& {
    return member(member(member(texture, "extensions"), extension), "source");
  };
  const GltfJson& plain = member(texture, "source");
  if (const GltfJson& webp = source("EXT_texture_webp"); !webp.is_null()) return webp;
  if (!plain.is_null()) return plain;
  for (const char* const other : {"KHR_texture_basisu", "MSFT_texture_dds", "EXT_texture_avif"})
    if (const GltfJson& image = source(other); !image.is_null()) return image;
  return plain;
}

Index SurfaceMaterials::add(const GltfJson& primitive, const Material& plain) {
  const GltfJson& id = member(primitive, "material");
  if (id.is_null()) {
    if (m_plain >= 0) return m_plain;
    m_plain = static_cast<Index>(materials.size());
    materials.push_back(plain);
    finishes.emplace_back();
    return m_plain;
  }
  const auto [entry, is_new] = m_known.try_emplace(index_from(id), 0);
  if (is_new) {
    entry->second = static_cast<Index>(materials.size());
    read(element(m_document.json, "materials", id));
  }
  return entry->second;
}

void SurfaceMaterials::read(const GltfJson& json) {
  Material material = gltf_material(json);
  SurfaceFinish finish;
  const GltfJson& pbr = member(json, "pbrMetallicRoughness");
  finish.base_colour = use_of(member(pbr, "baseColorTexture"), true);
  finish.metallic_roughness = use_of(member(pbr, "metallicRoughnessTexture"), false);
  finish.normal = use_of(member(json, "normalTexture"), false);
  finish.normal_scale = number_or(member(member(json, "normalTexture"), "scale"), 1);
  finish.emission = use_of(member(json, "emissiveTexture"), true);
  const float strength =
      number_or(member(member(member(json, "extensions"), "KHR_materials_emissive_strength"),
                       "emissiveStrength"),
                1);
  for (size_t i = 0; i < 3; ++i)
    finish.emitted[i] =
        share_or(item(member(json, "emissiveFactor"), i), 0) * std::clamp(strength, 0.0f, 1e4f);
  const GltfJson& mode = member(json, "alphaMode");
  if (mode == "MASK") finish.transparency = Transparency::Cut;
  if (mode == "BLEND") finish.transparency = Transparency::Blend;
  if (finish.transparency == Transparency::None) material.base_colour[3] = 1;
  finish.cutoff = number_or(member(json, "alphaCutoff"), 0.5f);
  finish.glass = glass_from(member(json, "extensions"), material.metallic);
  material.base_colour[3] *= 1 - kMostSeenThrough * finish.glass.share;
  materials.push_back(std::move(material));
  finishes.push_back(finish);
}

TextureUse SurfaceMaterials::use_of(const GltfJson& info, bool srgb) {
  TextureUse use;
  const GltfJson& id = member(info, "index");
  if (id.is_null()) return use;
  const GltfJson& texture = element(m_document.json, "textures", id);
  const GltfJson& source = image_of_texture(texture);
  if (source.is_null()) return use;
  const std::pair<size_t, bool> image{index_from(source), srgb};
  const auto known = std::find(images.begin(), images.end(), image);
  use.image = static_cast<int>(known - images.begin());
  if (known == images.end()) images.push_back(image);
  const GltfJson& transform = member(member(info, "extensions"), "KHR_texture_transform");
  if (!transform.is_null()) read_transform(transform, use);
  const GltfJson& other = member(transform, "texCoord");
  const GltfJson& set = other.is_null() ? member(info, "texCoord") : other;
  use.set = set.is_null() ? 0 : static_cast<int>(std::min<size_t>(index_from(set), 2));
  if (use.set > 1) return {};
  read_sampler(texture, use);
  return use;
}

void SurfaceMaterials::read_sampler(const GltfJson& texture, TextureUse& use) const {
  const GltfJson& id = member(texture, "sampler");
  if (id.is_null()) return;
  const GltfJson& sampler = element(m_document.json, "samplers", id);
  use.wrap_u = wrap_from(member(sampler, "wrapS"));
  use.wrap_v = wrap_from(member(sampler, "wrapT"));
  use.nearest = member(sampler, "magFilter") == kNearest;
}

}  // namespace trivet
