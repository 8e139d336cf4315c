// Look of a model's surface beyond its materials: textures, vertex colours, transparency,
// light of its own. Start here; renderers take it, the importer checks it.
#pragma once

#include <memory>

#include "core/io/textures/texture_image.h"
#include "core/model/model.h"

namespace trivet {

enum class TextureWrap { Repeat, Clamp, Mirror };

/// A texture as a material uses it: looked up at `transform` * (u, v, 1); u runs to the right and v
/// down the image, which fills 0 to 1 each way.
struct TextureUse {
  int image = -1;  // of SurfaceLook::images; -1: none
  int set = 0;     // of texture coordinates, 0 or 1
  TextureWrap wrap_u = TextureWrap::Repeat, wrap_v = TextureWrap::Repeat;
  bool nearest = false;  // magnified without filtering
  std::array<std::array<float, 3>, 2> transform{{{1, 0, 0}, {0, 1, 0}}};

  explicit operator bool() const { return image >= 0; }
};

/// Which parts of a surface are there.
enum class Transparency {
  None,
  Cut,   // those whose alpha reaches the cutoff, wholly
  Blend  // by alpha, which varies over the surface
};

/// Light that a material lets into the object (KHR_materials_transmission, _ior, _volume). Its
/// alpha is then small, for renderers without rays.
struct Glass {
  float share = 0;                                        // of the light that is not mirrored
  float index = 1.5f;                                     // of refraction
  std::optional<std::array<float, 3>> absorbed_per_unit;  // of length of the model; none: by the
                                                          // base colour
};

/// Textures and modes of a material beside the numbers of Material: colours of textures multiply
/// those.
struct SurfaceFinish {
  TextureUse base_colour;          // sRGB and alpha
  TextureUse metallic_roughness;   // blue and green
  TextureUse normal;               // x to the right of the image, y up, z off the surface
  TextureUse emission;             // sRGB
  std::array<float, 3> emitted{};  // radiance, linear RGB; white floors in the open have 1
  float normal_scale = 1;
  float cutoff = 0.5f;
  Transparency transparency = Transparency::None;
  Glass glass;

  bool has_texture() const { return base_colour || metallic_roughness || normal || emission; }
};

struct SurfaceLook {
  std::vector<Material> materials;      // at least one
  std::vector<SurfaceFinish> finishes;  // parallel to the materials
  std::vector<Index> face_material;     // #F, triangles in the model's order
  // #F x 3 corners; empty: no texture uses the set.
  std::array<std::vector<std::array<Eigen::Vector2f, 3>>, 2> coordinates;
  std::vector<std::array<Eigen::Vector4f, 3>> colours;  // #F x 3, linear RGBA; empty: white
  // #F: direction of the image of normals to the right, object frame, not unit, and 1 or -1 where
  // the image is mirrored. Empty: no material has a normal map.
  std::vector<Eigen::Vector4f> tangents;
  std::vector<std::shared_ptr<const TextureImage>> images;

  size_t image_bytes() const;
};

/// Texels of all images of a model together; beyond that all of them are halved until they fit.
inline constexpr size_t kMaxTextureBytes = size_t{256} << 20;

/// Look of a model, decoded. Images that cannot be drawn are left out. @return null: the model's
/// materials and normals say all.   Cost: decoding of all images.   Thread-safe.
/// @param max_bytes  of all texels and their smaller copies.
std::shared_ptr<const SurfaceLook> surface_look(const Model& model,
                                                size_t max_bytes = kMaxTextureBytes);

/// An image of a model's appearance.
struct ImageSummary {
  std::string name, kind;     // image_kind()
  size_t bytes = 0;           // encoded
  int width = 0, height = 0;  // texels; 0: it cannot be decoded
};

/// All images that come with a model. Decodes each of them.
std::vector<ImageSummary> images_of(const Model& model);

/// Notes on what surface_look() will leave out, a line each. Decodes every image once.
std::vector<Sentence> undrawn_textures(const Model& model);

}  // namespace trivet
