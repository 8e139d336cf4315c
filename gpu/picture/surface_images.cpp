#include "gpu/picture/surface_images.h"

#include <algorithm>

namespace trivet {
namespace {

constexpr int kFirstImageUnit = 3;  // below are materials, corners and shadow maps
constexpr const char* kImageNames[4] = {"base_image", "polish_image", "normal_image",
                                        "emission_image"};
constexpr int kNumWraps = 3;

std::array<const TextureUse*, 4> uses_of(const SurfaceFinish& finish) {
  return {&finish.base_colour, &finish.metallic_roughness, &finish.normal, &finish.emission};
}

GLint wrap_mode(TextureWrap wrap) {
  return wrap == TextureWrap::Clamp    ? GL_CLAMP_TO_EDGE
         : wrap == TextureWrap::Mirror ? GL_MIRRORED_REPEAT
                                       : GL_REPEAT;
}

GlSampler make_sampler(TextureWrap u, TextureWrap v, bool nearest) {
  GlSampler sampler = GlSampler::create();
  glSamplerParameteri(sampler.id(), GL_TEXTURE_WRAP_S, wrap_mode(u));
  glSamplerParameteri(sampler.id(), GL_TEXTURE_WRAP_T, wrap_mode(v));
  glSamplerParameteri(sampler.id(), GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glSamplerParameteri(sampler.id(), GL_TEXTURE_MAG_FILTER, nearest ? GL_NEAREST : GL_LINEAR);
  return sampler;
}

// Levels finer than the driver takes are left out.
GlTexture make_image(const TextureImage& image, std::size_t& num_bytes) {
  GLint max_side = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &max_side);
  GlTexture texture = GlTexture::create();
  glBindTexture(GL_TEXTURE_2D, texture.id());
  const GLint format = image.srgb ? GL_SRGB8_ALPHA8 : GL_RGBA8;
  GLint level = 0;
  for (const DecodedImage& texels : image.levels) {
    if (std::max(texels.width, texels.height) > max_side) continue;
    glTexImage2D(GL_TEXTURE_2D, level++, format, texels.width, texels.height, 0, GL_RGBA,
                 GL_UNSIGNED_BYTE, texels.rgba.data());
    num_bytes += texels.rgba.size();
  }
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, std::max(level - 1, 0));
  check_gl("sending textures to the graphics memory");
  return texture;
}

}  // namespace

FinishUniforms::FinishUniforms(const GlProgram& program)
    : used(program.uniform("image_used")),
      sets(program.uniform("image_set")),
      places(program.uniform("image_place")),
      emitted(program.uniform("emitted")),
      normal_scale(program.uniform("normal_scale")),
      cutoff(program.uniform("cutoff")) {
  for (int i = 0; i < 4; ++i) images[i] = program.uniform(kImageNames[i]);
}

void FinishUniforms::set_units() const {
  for (int i = 0; i < 4; ++i) glUniform1i(images[i], kFirstImageUnit + i);
}

SurfaceImages::SurfaceImages(const SurfaceLook& look) : m_finishes(look.finishes) {
  m_textures.reserve(look.images.size());
  for (const auto& image : look.images)
    m_textures.push_back(image ? make_image(*image, m_num_bytes) : GlTexture());
  m_samplers.resize(std::size_t{2} * kNumWraps * kNumWraps);
  m_sampled.reserve(m_finishes.size());
  for (const SurfaceFinish& finish : m_finishes) {
    std::array<Sampled, 4>& out = m_sampled.emplace_back();
    const auto uses = uses_of(finish);
    for (std::size_t i = 0; i < 4; ++i) out[i] = sampled(*uses[i]);
  }
}

SurfaceImages::Sampled SurfaceImages::sampled(const TextureUse& use) {
  if (!use) return {};
  const std::size_t wraps =
      static_cast<std::size_t>(use.wrap_u) * kNumWraps + static_cast<std::size_t>(use.wrap_v);
  GlSampler& sampler = m_samplers[2 * wraps + use.nearest];
  if (sampler.id() == 0) sampler = make_sampler(use.wrap_u, use.wrap_v, use.nearest);
  return {m_textures[static_cast<std::size_t>(use.image)].id(), sampler.id()};
}

void SurfaceImages::bind(const FinishUniforms& uniforms, std::size_t material) const {
  const SurfaceFinish& finish = m_finishes[material];
  std::array<GLint, 4> used, sets;
  std::array<std::array<float, 3>, 8> places;
  const auto uses = uses_of(finish);
  for (std::size_t i = 0; i < 4; ++i) {
    const Sampled& its = m_sampled[material][i];
    used[i] = its.texture != 0, sets[i] = uses[i]->set;
    std::copy_n(uses[i]->transform.begin(), 2, places.begin() + static_cast<std::ptrdiff_t>(2 * i));
    if (!used[i]) continue;
    const int unit = kFirstImageUnit + static_cast<int>(i);
    bind_texture(unit, GL_TEXTURE_2D, its.texture);
    glBindSampler(static_cast<GLuint>(unit), its.sampler);
  }
  glActiveTexture(GL_TEXTURE0);
  glUniform4iv(uniforms.used, 1, used.data());
  glUniform4iv(uniforms.sets, 1, sets.data());
  glUniform3fv(uniforms.places, 8, places[0].data());
  glUniform3fv(uniforms.emitted, 1, finish.emitted.data());
  glUniform1f(uniforms.normal_scale, finish.normal_scale);
  // Below 0: nothing is discarded; above 1: by alpha.
  const bool cut = finish.transparency == Transparency::Cut;
  const bool blend = finish.transparency == Transparency::Blend;
  glUniform1f(uniforms.cutoff, cut ? std::clamp(finish.cutoff, 0.0f, 1.0f) : blend ? 2.0f : -1.0f);
}

void SurfaceImages::unbind() {
  for (GLuint i = 0; i < 4; ++i) glBindSampler(kFirstImageUnit + i, 0);
}

bool SurfaceImages::emits() const {
  return std::any_of(m_finishes.begin(), m_finishes.end(),
                     [](const SurfaceFinish& f) { return f.emitted != std::array<float, 3>{}; });
}

}  // namespace trivet
