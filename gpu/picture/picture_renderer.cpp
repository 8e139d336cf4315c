#include "gpu/picture/picture_renderer.h"

#include <algorithm>
#include <cmath>

#include "gpu/picture/picture_shaders.h"

namespace trivet {
namespace {

constexpr int kMaxTile = 2048;                // px; bounds the memory of large pictures
constexpr int kMinMap = 512, kMaxMap = 2048;  // px; side of the key light's shadow map
constexpr int kFloorLightPx = 128, kFloorLightViews = 12, kFloorLightMap = 256;
constexpr double kFadeBegin = 1.0, kFadeEnd = 3.2;  // of the floor, in radii of the scene
constexpr float kExposure = 1.0f;

void bind_to_unit(int unit, GLenum target, const GlTexture& texture) {
  glActiveTexture(GL_TEXTURE0 + unit);
  glBindTexture(target, texture.id());
}

/// Moves pixel centres within the pixel from view to view, for anti-aliasing.
Vec2 jitter_px(int view) { return even_point(view) - Vec2(0.5, 0.5); }

/// Aims at a texel per pixel when the scene fills the picture.
int largest_map(const PictureOptions& options) {
  return std::clamp(std::max(options.width, options.height), kMinMap, kMaxMap);
}

/// State for both sides of every triangle, nearest first.
void prepare_to_draw() {
  glDisable(GL_BLEND);
  glDisable(GL_CULL_FACE);
  glDisable(GL_SCISSOR_TEST);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glDepthMask(GL_TRUE);
}

/// State for additive blending.
void add_to_target() {
  glDisable(GL_DEPTH_TEST);
  glEnable(GL_BLEND);
  glBlendEquation(GL_FUNC_ADD);
  glBlendFunc(GL_ONE, GL_ONE);
}

}  // namespace

PicturePrograms::PicturePrograms()
    : surface("surfaces", picture_shaders::surface_vertex(),
              picture_shaders::surface_fragment(false)),
      surface_see_through("see-through surfaces", picture_shaders::surface_vertex(),
                          picture_shaders::surface_fragment(true)),
      shadow("shadows", picture_shaders::shadow_vertex(), picture_shaders::shadow_fragment(false)),
      shadow_see_through("see-through shadows", picture_shaders::shadow_vertex(),
                         picture_shaders::shadow_fragment(true)),
      floor_light("floor light", picture_shaders::whole_target_vertex(),
                  picture_shaders::floor_light_fragment()),
      light("light", picture_shaders::whole_target_vertex(), picture_shaders::light_fragment()),
      develop("development", picture_shaders::whole_target_vertex(),
              picture_shaders::develop_fragment()) {}

PictureTargets::PictureTargets(int width, int height, int map_size)
    : surfaces(make_texture_2d(GL_RGBA32UI, width, height)),
      depth(make_texture_2d(GL_DEPTH_COMPONENT32F, width, height)),
      sums(make_texture_2d(GL_RGBA32F, width, height)),
      developed(make_texture_2d(GL_RGBA8, width, height)),
      floor_light(make_texture_2d(GL_RGBA32F, kFloorLightPx, kFloorLightPx)),
      maps(make_depth_array(map_size, kLightsPerView)),
      draw_surfaces(make_framebuffer({surfaces.id()}, depth.id())),
      draw_sums(make_framebuffer({sums.id()}, 0)),
      draw_developed(make_framebuffer({developed.id()}, 0)),
      draw_floor_light(make_framebuffer({floor_light.id()}, 0)) {
  set_linear(floor_light);
  for (int i = 0; i < kLightsPerView; ++i) draw_maps[i] = make_depth_framebuffer(maps.id(), i);
}

PictureRenderer::PictureRenderer(const PictureScene& scene, const Camera& camera,
                                 const PictureOptions& options)
    : m_options(options),
      m_has_floor(scene.floor),
      m_frame(make_picture_frame(scene)),
      m_camera(make_frame_camera(camera, double(options.width) / options.height, m_frame)),
      m_lights(options.samples, m_camera),
      m_geometry(scene, m_frame),
      m_targets(std::min(options.width, kMaxTile), std::min(options.height, kMaxTile),
                largest_map(options)),
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

void PictureRenderer::render_view(int view, const PictureTile& tile) {
  const Lights lights = m_lights.of_view(view);
  prepare_to_draw();
  draw_shadow_maps(view, lights);
  draw_surfaces(view, tile);
  add_light(view, tile, lights);
  check_gl("rendering a picture");
}

void PictureRenderer::draw_shadow_maps(int view, const Lights& lights) {
  for (int i = 0; i < kLightsPerView; ++i) {
    const int number = kLightsPerView * view + i;
    m_maps[i] = fit_shadow_map(lights[i].direction, m_geometry.hull_points(), m_map_px[i],
                               jitter_px(number));
    if (!casts_shadows(i)) continue;
    glBindFramebuffer(GL_FRAMEBUFFER, m_targets.draw_maps[i].id());
    glViewport(0, 0, m_map_px[i], m_map_px[i]);
    const float farthest = 1;
    glClearBufferfv(GL_DEPTH, 0, &farthest);
    draw_geometry(m_programs.shadow, m_programs.shadow_see_through, m_maps[i].clip_from_frame,
                  number, {});
  }
}

void PictureRenderer::draw_surfaces(int view, const PictureTile& tile) {
  glBindFramebuffer(GL_FRAMEBUFFER, m_targets.draw_surfaces.id());
  glViewport(0, 0, tile.width, tile.height);
  const float farthest = 1;
  glClearBufferfv(GL_DEPTH, 0, &farthest);
  glClearBufferuiv(GL_COLOR, 0, std::array<GLuint, 4>{}.data());
  draw_geometry(m_programs.surface, m_programs.surface_see_through,
                clip_from_frame(tile, jitter_px(view)), view, tile);
}

void PictureRenderer::draw_geometry(const GlProgram& opaque, const GlProgram& see_through,
                                    const Eigen::Matrix4f& clip_from_frame, int view,
                                    const PictureTile& tile) {
  const auto draw = [&](const GlProgram& program, PictureGeometry::Part part) {
    program.use();
    glUniformMatrix4fv(program.uniform("clip_from_frame"), 1, GL_FALSE, clip_from_frame.data());
    glUniform1i(program.uniform("materials"), 0);
    glUniform1i(program.uniform("corners"), 1);
    glUniform1ui(program.uniform("view"), static_cast<GLuint>(view));
    glUniform2i(program.uniform("tile"), tile.x, tile.y);
    set_uniform(program, "eye", m_camera.eye);
    m_geometry.draw(program, part);
  };
  draw(opaque, PictureGeometry::Part::Opaque);
  draw(see_through, PictureGeometry::Part::SeeThrough);
}

void PictureRenderer::add_light(int view, const PictureTile& tile, const Lights& lights) {
  glBindFramebuffer(GL_FRAMEBUFFER, m_targets.draw_sums.id());
  glViewport(0, 0, tile.width, tile.height);
  add_to_target();
  m_programs.light.use();
  bind_to_unit(0, GL_TEXTURE_2D, m_targets.surfaces);
  bind_to_unit(2, GL_TEXTURE_2D, m_targets.floor_light);
  set_view_uniforms(view, tile);
  set_light_uniforms(m_programs.light, lights);
  glBindVertexArray(m_no_attributes.id());
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glDisable(GL_BLEND);
}

void PictureRenderer::set_view_uniforms(int view, const PictureTile& tile) {
  const GlProgram& program = m_programs.light;
  const double w = m_options.width, h = m_options.height;
  const Vec2 jitter = jitter_px(view);
  glUniform1i(program.uniform("surfaces"), 0);
  glUniform1i(program.uniform("floor_light"), 2);
  glUniform4f(program.uniform("ndc_from_pixel"), float(2 / w), float(2 / h),
              float(2 * (tile.x + jitter.x()) / w - 1), float(2 * (tile.y + jitter.y()) / h - 1));
  set_uniform(program, "eye", m_camera.eye);
  set_uniform(program, "forward", m_camera.forward);
  set_uniform(program, "right", m_camera.right);
  set_uniform(program, "up", m_camera.up);
  glUniform1i(program.uniform("has_floor"), m_has_floor ? 1 : 0);
  glUniform2f(program.uniform("floor_fade"), float(kFadeBegin * floor_radius()),
              float(kFadeEnd * floor_radius()));
  // The reflected smooth sky excludes the key light, but a real room has walls lit by it: a value
  // between the sky alone and all light.
  const double mirrored = 0.75 / (1 - kKeyShare);
  glUniform2f(program.uniform("sky_radiance"), float(mirrored * m_lights.sky_radiance(0)),
              float(mirrored * m_lights.sky_radiance(1)));
}

void PictureRenderer::set_light_uniforms(const GlProgram& program, const Lights& lights) {
  bind_to_unit(1, GL_TEXTURE_2D_ARRAY, m_targets.maps);
  glUniform1i(program.uniform("shadow_maps"), 1);
  set_uniform(program, "floor_z", static_cast<float>(m_frame.floor_z));
  set_uniform(program, "floor_extent", static_cast<float>(kFadeEnd * floor_radius()));
  // Clip coordinates are -1 to 1, the map's and its depth's 0 to 1.
  Eigen::Matrix4f map_from_clip = Eigen::Matrix4f::Identity() * 0.5f;
  map_from_clip.col(3) << 0.5f, 0.5f, 0.5f, 1.0f;
  std::array<Eigen::Matrix4f, kLightsPerView> map_from_frame;
  std::array<Eigen::Vector3f, kLightsPerView> direction, irradiance;
  std::array<float, kLightsPerView> texel, casts, map_size;
  for (int i = 0; i < kLightsPerView; ++i) {
    map_from_frame[i] = map_from_clip * m_maps[i].clip_from_frame;
    direction[i] = lights[i].direction.cast<float>();
    irradiance[i] = lights[i].irradiance.cast<float>();
    texel[i] = static_cast<float>(m_maps[i].texel);
    map_size[i] = static_cast<float>(m_map_px[i]);
    casts[i] = casts_shadows(i) ? 1.0f : 0.0f;
  }
  glUniformMatrix4fv(program.uniform("map_from_frame"), kLightsPerView, GL_FALSE,
                     map_from_frame[0].data());
  glUniform3fv(program.uniform("direction"), kLightsPerView, direction[0].data());
  glUniform3fv(program.uniform("irradiance"), kLightsPerView, irradiance[0].data());
  glUniform1fv(program.uniform("texel"), kLightsPerView, texel.data());
  glUniform1fv(program.uniform("casts"), kLightsPerView, casts.data());
  glUniform1fv(program.uniform("map_size"), kLightsPerView, map_size.data());
}

void PictureRenderer::develop(const PictureTile& tile, Image& image) {
  glBindFramebuffer(GL_FRAMEBUFFER, m_targets.draw_developed.id());
  glViewport(0, 0, tile.width, tile.height);
  glDisable(GL_DEPTH_TEST);
  m_programs.develop.use();
  bind_to_unit(0, GL_TEXTURE_2D, m_targets.sums);
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

Eigen::Matrix4f PictureRenderer::clip_from_frame(const PictureTile& tile,
                                                 const Vec2& jitter) const {
  const Vec3& forward = m_camera.forward;
  // The picture's NDC, stretched so that the tile fills -1 to 1 and shifted by the jitter.
  const Vec2 picture(m_options.width, m_options.height), size(tile.width, tile.height);
  const Vec2 scale = picture.cwiseQuotient(size);
  const Vec2 origin = Vec2(tile.x, tile.y) + jitter;
  const Vec2 offset = (picture - 2 * origin).cwiseQuotient(size) - Vec2::Ones();
  Eigen::Matrix4d clip = Eigen::Matrix4d::Zero();
  const Vec3 x = m_camera.right / m_camera.right.squaredNorm();
  const Vec3 y = m_camera.up / m_camera.up.squaredNorm();
  clip.block<1, 3>(0, 0) = (scale.x() * x + offset.x() * forward).transpose();
  clip.block<1, 3>(1, 0) = (scale.y() * y + offset.y() * forward).transpose();
  clip.block<1, 3>(2, 0) = ((m_far + m_near) / (m_far - m_near) * forward).transpose();
  clip.block<1, 3>(3, 0) = forward.transpose();
  clip.col(3) = -clip.leftCols<3>() * m_camera.eye;
  clip(2, 3) -= 2 * m_far * m_near / (m_far - m_near);
  return clip.cast<float>();
}

}  // namespace trivet
