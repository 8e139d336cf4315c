// The passes of one view: shadow maps, surfaces, light.
#include <algorithm>
#include <cmath>

#include "gpu/picture/renderer.h"

namespace trivet {
namespace {

/// Moves pixel centres within the pixel from view to view, for anti-aliasing.
Vec2 jitter_px(int view) { return even_point(view) - Vec2(0.5, 0.5); }

// Then left alone by what gives no light.
void clear_emission() {
  glColorMaski(1, GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glClearBufferfv(GL_COLOR, 1, std::array<float, 4>{}.data());
  glColorMaski(1, GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
}

}  // namespace

void prepare_to_draw() {
  glDisable(GL_BLEND);
  glDisable(GL_CULL_FACE);
  glDisable(GL_SCISSOR_TEST);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glDepthMask(GL_TRUE);
}

void add_to_target() {
  glDisable(GL_DEPTH_TEST);
  glEnable(GL_BLEND);
  glBlendEquation(GL_FUNC_ADD);
  glBlendFunc(GL_ONE, GL_ONE);
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
    const GeometryView drawn{m_maps[i].clip_from_frame, number, {}};
    draw_with(m_programs.shadow, {true, std::nullopt}, drawn);
    draw_with(m_programs.shadow_see_through, {false, false}, drawn);
    if (m_textured) draw_with(m_textured->shadow_see_through, {false, true}, drawn);
  }
}

void PictureRenderer::draw_surfaces(int view, const PictureTile& tile) {
  glBindFramebuffer(GL_FRAMEBUFFER, m_targets.draw_surfaces.id());
  glViewport(0, 0, tile.width, tile.height);
  const float farthest = 1;
  glClearBufferfv(GL_DEPTH, 0, &farthest);
  glClearBufferuiv(GL_COLOR, 0, std::array<GLuint, 4>{}.data());
  if (m_geometry.emits()) clear_emission();
  const Eigen::Matrix4f clip = clip_from_frame(tile, jitter_px(view));
  const GeometryView drawn{clip, view, tile};
  draw_with(m_programs.surface, {true, false}, drawn);
  draw_with(m_programs.surface_see_through, {false, false}, drawn);
  if (!m_textured) return;
  const GLboolean emits = m_geometry.emits() ? GL_TRUE : GL_FALSE;
  glColorMaski(1, emits, emits, emits, emits);
  draw_with(m_textured->surface, {true, true}, drawn);
  draw_with(m_textured->surface_see_through, {false, true}, drawn);
}

void PictureRenderer::draw_with(const GlProgram& program, const PictureGeometry::Which& which,
                                const GeometryView& view) const {
  program.use();
  glUniformMatrix4fv(program.uniform("clip_from_frame"), 1, GL_FALSE, view.clip_from_frame.data());
  glUniform1i(program.uniform("materials"), 0);
  glUniform1i(program.uniform("corners"), 1);
  glUniform1ui(program.uniform("view"), static_cast<GLuint>(view.view));
  glUniform2i(program.uniform("tile"), view.tile.x, view.tile.y);
  set_uniform(program, "eye", m_camera.eye);
  m_geometry.draw(program, which);
}

void PictureRenderer::add_light(int view, const PictureTile& tile, const Lights& lights) {
  glBindFramebuffer(GL_FRAMEBUFFER, m_targets.draw_sums.id());
  glViewport(0, 0, tile.width, tile.height);
  add_to_target();
  m_programs.light.use();
  bind_texture(0, GL_TEXTURE_2D, m_targets.surfaces.id());
  bind_texture(2, GL_TEXTURE_2D, m_targets.floor_light.id());
  if (m_geometry.emits()) bind_texture(3, GL_TEXTURE_2D, m_targets.emission.id());
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
  glUniform1i(program.uniform("emission"), 3);
  glUniform4f(program.uniform("ndc_from_pixel"), float(2 / w), float(2 / h),
              float(2 * (tile.x + jitter.x()) / w - 1 - m_camera.middle.x()),
              float(2 * (tile.y + jitter.y()) / h - 1 - m_camera.middle.y()));
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
  bind_texture(1, GL_TEXTURE_2D_ARRAY, m_targets.maps.id());
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

Eigen::Matrix4f PictureRenderer::clip_from_frame(const PictureTile& tile,
                                                 const Vec2& jitter) const {
  const Vec3& forward = m_camera.forward;
  // The picture's NDC, stretched so that the tile fills -1 to 1 and shifted by the jitter.
  const Vec2 picture(m_options.width, m_options.height), size(tile.width, tile.height);
  const Vec2 scale = picture.cwiseQuotient(size);
  const Vec2 origin = Vec2(tile.x, tile.y) + jitter;
  const Vec2 offset = (picture - 2 * origin).cwiseQuotient(size) - Vec2::Ones() +
                      scale.cwiseProduct(m_camera.middle);
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
