#include "gpu/picture/renderer.h"

#include <algorithm>
#include <cmath>

namespace trivet {
namespace {

constexpr int kMaxTile = 2048;                // px; bounds the memory of large pictures
constexpr int kMinMap = 512, kMaxMap = 2048;  // px; side of the key light's shadow map
constexpr int kFloorLightViews = 12, kFloorLightMap = 256;
constexpr float kExposure = 1.0f;

/// Aims at a texel per pixel when the scene fills the picture.
int largest_map(const PictureOptions& options) {
  return std::clamp(std::max(options.width, options.height), kMinMap, kMaxMap);
}

}  // namespace

PictureTargets::PictureTargets(int width, int height, int map_size, bool emits)
    : surfaces(make_texture_2d(GL_RGBA32UI, width, height)),
      emission(emits ? make_texture_2d(GL_RGBA16F, width, height) : GlTexture()),
      depth(make_texture_2d(GL_DEPTH_COMPONENT32F, width, height)),
      sums(make_texture_2d(GL_RGBA32F, width, height)),
      developed(make_texture_2d(GL_RGBA8, width, height)),
      floor_light(make_texture_2d(GL_RGBA32F, kFloorLightPx, kFloorLightPx)),
      maps(make_depth_array(map_size, kLightsPerView)),
      draw_surfaces(emits ? make_framebuffer({surfaces.id(), emission.id()}, depth.id())
                          : make_framebuffer({surfaces.id()}, depth.id())),
      draw_sums(make_framebuffer({sums.id()}, 0)),
      draw_developed(make_framebuffer({developed.id()}, 0)),
      draw_floor_light(make_framebuffer({floor_light.id()}, 0)) {
  set_linear(floor_light);
  for (int i = 0; i < kLightsPerView; ++i) draw_maps[i] = make_depth_framebuffer(maps.id(), i);
}

PictureRenderer::PictureRenderer(const PictureScene& scene, const FrameCamera& camera,
                                 const PictureOptions& options, PictureStore& store)
    : m_options(options),
      m_has_floor(scene.floor),
      m_frame(make_picture_frame(scene)),
      m_camera(camera),
      m_lights(options.samples, m_camera),
      m_geometry(scene, m_frame, store),
      m_programs(store.programs(m_geometry.emits())),
      m_textured(m_geometry.has_textures() ? &store.textured_programs() : nullptr),
      m_targets(std::min(options.width, kMaxTile), std::min(options.height, kMaxTile),
                largest_map(options), m_geometry.emits()),
      m_no_attributes(GlVertexArray::create()) {
  find_depth_range();
}

void PictureRenderer::find_depth_range() {
  double nearest = kInfinity, farthest = 0;
  for (const Vec3& p : m_geometry.hull_points()) {
    const double depth = (p - m_camera.eye).dot(m_camera.forward);
    nearest = std::min(nearest, depth), farthest = std::max(farthest, depth);
  }
  if (!(farthest > 0)) return;  // nothing in front of the camera
  m_far = 1.01 * farthest;
  m_near = std::max(0.99 * nearest, 1e-4 * m_far);
}

std::vector<PictureTile> PictureRenderer::tiles() const {
  std::vector<PictureTile> tiles;
  for (int y = 0; y < m_options.height; y += kMaxTile)
    for (int x = 0; x < m_options.width; x += kMaxTile)
      tiles.push_back({x, y, std::min(kMaxTile, m_options.width - x),
                       std::min(kMaxTile, m_options.height - y)});
  return tiles;
}

void PictureRenderer::set_map_sizes(int key_px, int other_px) {
  m_map_px.fill(other_px);
  m_map_px[0] = key_px;
}

Image PictureRenderer::render() {
  Image image{m_options.width, m_options.height, {}};
  image.rgba.resize(std::size_t{4} * image.width * image.height);
  const std::vector<PictureTile> all = tiles();
  const double num_steps = double(all.size()) * m_options.samples;
  double done = 0;
  if (m_has_floor) measure_floor_light();
  // Half as fine for the sky, whose shadows are soft: the look-ups take most of the time.
  set_map_sizes(largest_map(m_options), std::max(kMinMap, largest_map(m_options) / 2));
  for (const PictureTile& tile : all) {
    glBindFramebuffer(GL_FRAMEBUFFER, m_targets.draw_sums.id());
    glClearBufferfv(GL_COLOR, 0, std::array<float, 4>{}.data());
    for (int view = 0; view < m_options.samples; ++view) {
      render_view(view, tile);
      if (!m_options.progress) continue;
      glFinish();  // otherwise commands only queue up, and the fraction is meaningless
      m_options.progress(++done / num_steps);
    }
    develop(tile, image);
  }
  return image;
}

void PictureRenderer::measure_floor_light() {
  const PictureLights few_lights(kFloorLightViews, m_camera);
  set_map_sizes(kFloorLightMap, kFloorLightMap);
  glBindFramebuffer(GL_FRAMEBUFFER, m_targets.draw_floor_light.id());
  glClearBufferfv(GL_COLOR, 0, std::array<float, 4>{}.data());
  for (int view = 0; view < kFloorLightViews; ++view) {
    const Lights lights = few_lights.of_view(view);
    prepare_to_draw();
    draw_shadow_maps(view, lights);
    glBindFramebuffer(GL_FRAMEBUFFER, m_targets.draw_floor_light.id());
    glViewport(0, 0, kFloorLightPx, kFloorLightPx);
    add_to_target();
    m_programs.floor_light.use();
    set_light_uniforms(m_programs.floor_light, lights);
    set_uniform(m_programs.floor_light, "floor_light_px", float(kFloorLightPx));
    glBindVertexArray(m_no_attributes.id());
    glDrawArrays(GL_TRIANGLES, 0, 3);
  }
}

void PictureRenderer::develop(const PictureTile& tile, Image& image) {
  glBindFramebuffer(GL_FRAMEBUFFER, m_targets.draw_developed.id());
  glViewport(0, 0, tile.width, tile.height);
  glDisable(GL_DEPTH_TEST);
  m_programs.develop.use();
  bind_texture(0, GL_TEXTURE_2D, m_targets.sums.id());
  glUniform1i(m_programs.develop.uniform("sums"), 0);
  set_uniform(m_programs.develop, "num_views", static_cast<float>(m_options.samples));
  set_uniform(m_programs.develop, "exposure", kExposure);
  glUniform4fv(m_programs.develop.uniform("background"), 1, m_options.background.data());
  glBindVertexArray(m_no_attributes.id());
  glDrawArrays(GL_TRIANGLES, 0, 3);
  const Image part = read_picture(tile.width, tile.height);
  for (int y = 0; y < tile.height; ++y) {
    const std::size_t row = image.height - tile.y - tile.height + y;
    std::copy_n(part.pixel(0, y), std::size_t{4} * tile.width,
                image.rgba.data() + 4 * (row * image.width + tile.x));
  }
}

}  // namespace trivet
