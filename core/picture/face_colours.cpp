#include "core/picture/face_colours.h"

#include <cmath>

#include "core/picture/mesh_values.h"

namespace trivet {
namespace {

using Colour = std::array<float, 4>;  // linear RGB, alpha

std::uint8_t colour_byte(float x, bool srgb) {
  const float held = unit_or(x, 0);
  const float y = !srgb                ? held
                  : held <= 0.0031308f ? 12.92f * held
                                       : 1.055f * std::pow(held, 1 / 2.4f) - 0.055f;
  return static_cast<std::uint8_t>(std::lround(y * 255));
}

// The last level of a texture is a single texel, the mean of all.
Colour mean_texel(const SurfaceLook& look, std::size_t material) {
  const TextureUse& use = look.finishes[material].base_colour;
  if (!use || !look.images[use.image]) return {1, 1, 1, 1};
  const TextureImage& image = *look.images[use.image];
  const std::uint8_t* texel = image.levels.back().rgba.data();
  Colour out{0, 0, 0,
             look.finishes[material].transparency == Transparency::None ? 1 : texel[3] / 255.0f};
  for (int k = 0; k < 3; ++k)
    out[k] = image.srgb ? linear_from_srgb_byte(texel[k]) : texel[k] / 255.0f;
  return out;
}

std::vector<Colour> material_colours(const DrawnMesh& mesh) {
  std::vector<Colour> out;
  out.reserve(mesh.materials.size() + 1);
  for (const Material& material : mesh.materials) out.push_back(material.base_colour);
  if (out.empty()) out.push_back(Material().base_colour);
  if (mesh.has_details())
    for (std::size_t i = 0; i < mesh.materials.size(); ++i) {
      const Colour texel = mean_texel(*mesh.surface, i);
      for (int k = 0; k < 4; ++k) out[i][k] *= texel[k];
    }
  return out;
}

}  // namespace

std::vector<std::array<std::uint8_t, 4>> face_colours(const PictureMesh& mesh) {
  const DrawnMesh drawn(mesh, kMaxTextureBytes);
  const std::vector<Colour> materials = material_colours(drawn);
  const bool painted = drawn.surface && !drawn.surface->colours.empty();
  std::vector<std::array<std::uint8_t, 4>> out;
  out.reserve(drawn.triangles.size());
  for (std::size_t face = 0; face < drawn.triangles.size(); ++face) {
    Colour colour = materials[material_of(drawn, face)];
    if (painted) {
      const auto& corners = drawn.surface->colours[face];
      for (int k = 0; k < 4; ++k) colour[k] *= (corners[0][k] + corners[1][k] + corners[2][k]) / 3;
    }
    out.push_back({colour_byte(colour[0], true), colour_byte(colour[1], true),
                   colour_byte(colour[2], true), colour_byte(colour[3], false)});
  }
  return out;
}

}  // namespace trivet
