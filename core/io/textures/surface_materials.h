// Materials of a glTF asset as renderers take them. Private: exposes the JSON library.
#pragma once

#include <map>

#include "core/io/gltf/values.h"
#include "core/io/textures/surface_look.h"

namespace trivet {

/// Collects the materials that primitives use, and their images, each once.
class SurfaceMaterials {
 public:
  explicit SurfaceMaterials(const GltfDocument& document) : m_document(document) {}

  /// Number of the material of a primitive; `plain` is the one of primitives without any.
  Index add(const GltfJson& primitive, const Material& plain);

  std::vector<Material> materials;
  std::vector<SurfaceFinish> finishes;
  /// Images by number in the asset, and whether they hold colours, in the order of
  /// TextureUse::image.
  std::vector<std::pair<size_t, bool>> images;

 private:
  void read(const GltfJson& material);
  TextureUse use_of(const GltfJson& info, bool srgb);
  void read_sampler(const GltfJson& texture, TextureUse& use) const;

  const GltfDocument& m_document;
  std::map<size_t, Index> m_known;
  Index m_plain = -1;
};

/// The image that a texture shows: WebP, PNG or JPEG; where there is none of these, the one that
/// cannot be decoded and has to be named. Null: none.
const GltfJson& image_of_texture(const GltfJson& texture);

}  // namespace trivet
