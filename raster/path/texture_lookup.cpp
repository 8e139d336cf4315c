#include "raster/path/texture_lookup.h"

#include <algorithm>
#include <cmath>

namespace trivet {
namespace {

using Vec2f = Eigen::Vector2f;
using Vec4f = Eigen::Vector4f;

// Beyond this, float32 has no fractions left worth looking up.
constexpr float kFarthest = 1e6f;

int texel_index(int i, int size, TextureWrap wrap) {
  if (wrap == TextureWrap::Clamp) return std::clamp(i, 0, size - 1);
  if (wrap == TextureWrap::Repeat) return ((i % size) + size) % size;
  // Mirrored images repeat every two sizes.
  const int twice = 2 * size, at = ((i % twice) + twice) % twice;
  return at < size ? at : twice - 1 - at;
}

Vec4f texel(const DecodedImage& level, int x, int y, bool srgb) {
  const std::uint8_t* const p = level.rgba.data() + 4 * (std::size_t(y) * level.width + x);
  if (srgb)
    return {linear_from_srgb_byte(p[0]), linear_from_srgb_byte(p[1]), linear_from_srgb_byte(p[2]),
            float(p[3]) / 255};
  return Vec4f(p[0], p[1], p[2], p[3]) / 255;
}

// Between the four texels whose centres are around it.
Vec4f bilinear(const DecodedImage& level, const TextureUse& use, const Vec2f& at, bool srgb) {
  const float x = at.x() * float(level.width) - 0.5f, y = at.y() * float(level.height) - 0.5f;
  const float fx = std::floor(x), fy = std::floor(y), s = x - fx, t = y - fy;
  const int x0 = texel_index(int(fx), level.width, use.wrap_u);
  const int x1 = texel_index(int(fx) + 1, level.width, use.wrap_u);
  const int y0 = texel_index(int(fy), level.height, use.wrap_v);
  const int y1 = texel_index(int(fy) + 1, level.height, use.wrap_v);
  const Vec4f above = (1 - s) * texel(level, x0, y0, srgb) + s * texel(level, x1, y0, srgb);
  const Vec4f below = (1 - s) * texel(level, x0, y1, srgb) + s * texel(level, x1, y1, srgb);
  return (1 - t) * above + t * below;
}

Vec4f nearest(const DecodedImage& level, const TextureUse& use, const Vec2f& at, bool srgb) {
  const int x = texel_index(int(std::floor(at.x() * float(level.width))), level.width, use.wrap_u);
  const int y =
      texel_index(int(std::floor(at.y() * float(level.height))), level.height, use.wrap_v);
  return texel(level, x, y, srgb);
}

}  // namespace

Vec2f texture_position(const TextureUse& use, const Vec2f& at) {
  Vec2f out;
  for (int r = 0; r < 2; ++r) {
    // The file's transform, within the range that float32 can look up.
    const auto& row = use.transform[static_cast<std::size_t>(r)];
    out[r] = std::clamp(row[0] * at.x() + row[1] * at.y() + row[2], -kFarthest, kFarthest);
  }
  return out.allFinite() ? out : Vec2f(Vec2f::Zero());
}

Vec4f looked_up(const TextureImage& image, const TextureUse& use, const Vec2f& position,
                float texels_across) {
  // Whole turns change nothing but take digits.
  const Vec2f at = position - 2 * (position / 2).array().floor().matrix();
  const Vec2f& from =
      use.wrap_u == TextureWrap::Clamp || use.wrap_v == TextureWrap::Clamp ? position : at;
  const auto last = static_cast<float>(image.levels.size() - 1);
  // The level is where a texel is about as wide as the ray's footprint.
  const float level = texels_across > 1 ? std::min(std::log2(texels_across), last) : 0;
  if (level <= 0)
    return use.nearest ? nearest(image.levels.front(), use, from, image.srgb)
                       : bilinear(image.levels.front(), use, from, image.srgb);
  // Two levels are blended, so that no border shows between them.
  const auto fine = static_cast<std::size_t>(level);
  const float share = level - float(fine);
  Vec4f out = bilinear(image.levels[fine], use, from, image.srgb);
  if (share <= 0) return out;
  return (1 - share) * out + share * bilinear(image.levels[fine + 1], use, from, image.srgb);
}

FaceLook::FaceLook(const SurfaceLook& look, const FacePoint& at)
    : m_look(look),
      m_at(at),
      m_material(look.materials[static_cast<std::size_t>(look.face_material[at.face])]),
      m_finish(look.finishes[static_cast<std::size_t>(look.face_material[at.face])]) {}

Vec4f FaceLook::lookup(const TextureUse& use) const {
  const auto& corners = m_look.coordinates[static_cast<std::size_t>(use.set)][m_at.face];
  std::array<Vec2f, 3> at;
  Vec2f position = Vec2f::Zero();
  for (std::size_t k = 0; k < 3; ++k) {
    at[k] = texture_position(use, corners[k]);
    position += m_at.weights[k] * at[k];
  }
  const TextureImage& image = *m_look.images[static_cast<std::size_t>(use.image)];
  // The face's area in texels, over its area in the scene, gives texels per width of the ray.
  const Vec2f a = at[1] - at[0], b = at[2] - at[0];
  const DecodedImage& finest = image.levels.front();
  const float texels = std::abs(a.x() * b.y() - a.y() * b.x()) * float(finest.width) *
                       float(finest.height);  // twice the face's, as its area is
  return looked_up(image, use, position, m_at.width * std::sqrt(texels));
}

Vec4f FaceLook::base_colour() const {
  Vec4f out(m_material.base_colour.data());
  if (m_finish.base_colour) out = out.cwiseProduct(lookup(m_finish.base_colour));
  if (m_look.colours.empty()) return out;
  Vec4f colour = Vec4f::Zero();
  for (std::size_t k = 0; k < 3; ++k) colour += m_at.weights[k] * m_look.colours[m_at.face][k];
  return out.cwiseProduct(colour);
}

float FaceLook::kept(float alpha) const {
  switch (m_finish.transparency) {
    case Transparency::None:
      return 1;
    case Transparency::Cut:
      return alpha >= m_finish.cutoff ? 1.0f : 0.0f;
    default:
      return std::clamp(alpha, 0.0f, 1.0f);
  }
}

FaceLook::Polish FaceLook::polish() const {
  Polish out{m_material.metallic, m_material.roughness};
  if (!m_finish.metallic_roughness) return out;
  const Vec4f texel = lookup(m_finish.metallic_roughness);
  return {out.metallic * texel[2], out.roughness * texel[1]};
}

Vec3f FaceLook::emitted() const {
  const Vec3f factor(m_finish.emitted.data());
  return m_finish.emission ? factor.cwiseProduct(Vec3f(lookup(m_finish.emission).head<3>()))
                           : factor;
}

Vec3f FaceLook::mapped_normal() const {
  if (!m_finish.normal) return Vec3f::UnitZ();
  Vec3f out = 2 * lookup(m_finish.normal).head<3>() - Vec3f::Ones();
  out.head<2>() *= m_finish.normal_scale;
  const float length = out.norm();
  return length > 1e-6f ? Vec3f(out / length) : Vec3f::UnitZ();
}

}  // namespace trivet
