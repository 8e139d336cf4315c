#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "gpu/live/renderer.h"

namespace trivet {
namespace {

constexpr float kOutlinePx = 2.2f;
constexpr double kFinestCellPx = 6, kClearCellPx = 20;  // grid lines: first visible, full
constexpr double kNearestMark = 2e-4;  // of the farthest depth: marks of a section are cut here

}  // namespace

void LiveRenderer::draw_backdrop(const View& view) {
  const float farthest = 1;
  glClearBufferfv(GL_DEPTH, 0, &farthest);
  glDisable(GL_DEPTH_TEST);
  const GlProgram& program = m_programs.backdrop;
  program.use();
  set_uniform(program, "top", view.options.theme.background_top);
  set_uniform(program, "bottom", view.options.theme.background_bottom);
  set_uniform(program, "height", static_cast<float>(view.options.height));
  glBindVertexArray(m_no_attributes.id());
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glEnable(GL_DEPTH_TEST);
}

void LiveRenderer::set_shadow_uniforms(const GlProgram& program, const View& view) const {
  bind_texture(2, GL_TEXTURE_2D, m_shadow_map.id());
  set_uniform(program, "shadow_map", 2);
  set_uniform(program, "map_from_frame",
              Eigen::Matrix4d(m_map_from_world * world_from_frame(m_frame)));
  set_uniform(program, "light", kLiveLight);
  set_uniform(program, "texel", static_cast<float>(m_shadow_texel * m_frame.scale));
  set_uniform(program, "map_px", static_cast<float>(m_shadow_px));
  set_uniform(program, "texture_px", static_cast<float>(kLiveShadowMapPx));
  set_uniform(program, "shadows", !view.options.shadows ? 0 : view.options.draft ? 1 : 2);
}

void LiveRenderer::prepare_objects(const View& view, const MeshProgram& mesh_program) const {
  const GlProgram& program = mesh_program.program;
  program.use();
  set_uniform(program, "clip_from_frame",
              Eigen::Matrix4d(view.clip_from_world * world_from_frame(m_frame)));
  set_shadow_uniforms(program, view);
  set_uniform(program, "materials", 0);
  set_uniform(program, "exposure", view.options.theme.exposure);
  const Vec3 eye = view.camera.height ? Vec3(-view.axes.forward) : m_frame.apply(view.camera.eye);
  glUniform4f(program.uniform("eye"), static_cast<float>(eye.x()), static_cast<float>(eye.y()),
              static_cast<float>(eye.z()), view.camera.height ? 0.0f : 1.0f);
}

void LiveRenderer::draw_one(const MeshProgram& program, const Instance& instance, Part part) const {
  const UploadedMesh& mesh = *instance.mesh;
  if (mesh.empty()) return;
  glUniformMatrix4fv(program.frame_from_object, 1, GL_FALSE,
                     instance.placement.frame_from_object.data());
  glUniformMatrix3fv(program.frame_from_normal, 1, GL_FALSE,
                     instance.placement.frame_from_normal.data());
  glUniform4fv(program.tint, 1, instance.tint.data());
  glUniform1f(program.opacity, instance.object->opacity);
  bind_texture(0, GL_TEXTURE_BUFFER, mesh.material_texture.id());
  glBindVertexArray(mesh.vertex_array.id());
  const bool finishes = mesh.textured() && program.finish.used >= 0;
  if (finishes) program.finish.set_units();
  for (const MeshGroup& group : mesh.groups) {
    const bool is_solid = group.part != MeshPart::SeeThrough;
    if (part != Part::All && is_solid != (part == Part::Solid)) continue;
    if (finishes) mesh.surface->bind(program.finish, group.material);
    glDrawArrays(GL_TRIANGLES, group.first, group.count);
  }
  if (finishes) SurfaceImages::unbind();
}

// Programs are changed, and told of the view, only where the next mesh needs another.
void LiveRenderer::draw_object(const View& view, const Instance& instance, Part part) {
  const MeshProgram& program =
      instance.mesh->textured() ? m_programs.textured_object : m_programs.object;
  if (m_prepared != &program) prepare_objects(view, program);
  m_prepared = &program;
  draw_one(program, instance, part);
}

void LiveRenderer::draw_solid(const View& view, bool still, bool moving) {
  m_prepared = nullptr;
  for (const Instance& instance : m_instances)
    if (instance.seen && instance.object->opacity >= 1 &&
        (instance.object->moving ? moving : still))
      draw_object(view, instance, Part::Solid);
  if (still && view.scene.floor) draw_floor(view);
}

void LiveRenderer::draw_floor(const View& view) {
  blend_over();
  // Objects that lie on the floor win against it.
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(1, 2);
  const GlProgram& program = m_programs.floor;
  program.use();
  set_uniform(program, "clip_from_frame",
              Eigen::Matrix4d(view.clip_from_world * world_from_frame(m_frame)));
  set_shadow_uniforms(program, view);
  const LiveTheme& theme = view.options.theme;
  const double pixel = metres_per_pixel(view.camera.target, view.camera, view.options.height) *
                       view.options.pixel_ratio;
  const double cell = std::pow(10.0, std::ceil(std::log10(kFinestCellPx * pixel)));
  const double fine = (cell / pixel - kFinestCellPx) / (kClearCellPx - kFinestCellPx);
  set_uniform(program, "floor_centre", m_frame.apply(view.floor_centre));
  set_uniform(program, "floor_radius", static_cast<float>(view.floor_radius * m_frame.scale));
  const Vec3 origin = m_frame.apply(Vec3::Zero());
  glUniform2f(program.uniform("grid_origin"), static_cast<float>(origin.x()),
              static_cast<float>(origin.y()));
  set_uniform(program, "cell", static_cast<float>(cell * m_frame.scale));
  set_uniform(program, "fine", static_cast<float>(std::clamp(fine, 0.0, 1.0)));
  // Seen from below, the floor is only a veil.
  const bool from_below = view.camera.height ? view.axes.forward.z() > 0 : view.camera.eye.z() < 0;
  LiveColour floor = theme.floor;
  if (from_below) floor[3] *= 0.25f;
  set_uniform(program, "floor_colour", floor);
  set_uniform(program, "grid_colour", theme.grid);
  set_uniform(program, "axis_x", theme.axis_x);
  set_uniform(program, "axis_y", theme.axis_y);
  set_uniform(program, "shadow_on_floor", theme.shadow_on_floor);
  glBindVertexArray(m_no_attributes.id());
  if (from_below) glDepthMask(GL_FALSE);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  prepare_to_draw_solids();
}

void LiveRenderer::draw_translucent(const View& view) {
  prepare_to_draw_solids();
  m_prepared = nullptr;
  blend_over();
  glDepthMask(GL_FALSE);
  for (auto it = m_instances.rbegin(); it != m_instances.rend(); ++it)  // far ones first
    if (it->seen && it->object->opacity >= 1) draw_object(view, *it, Part::SeeThrough);
  // Only the nearest surface of a ghost is visible: first its depth, then its colour.
  for (auto it = m_instances.rbegin(); it != m_instances.rend(); ++it) {
    if (!it->seen || it->object->opacity >= 1) continue;
    glDepthMask(GL_TRUE);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    draw_object(view, *it, Part::All);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    draw_object(view, *it, Part::All);
  }
  prepare_to_draw_solids();
}

void LiveRenderer::draw_overlay(const View& view) {
  // A section cuts objects, not the marks in front of it.
  const double near =
      view.camera.cut ? std::min(view.near_depth, kNearestMark * view.far_depth) : view.near_depth;
  OverlayView overlay_view{view.camera, view.axes, view.clip_from_world, near};
  overlay_view.closer = 2e-3 * view.reach();
  overlay_view.width = view.options.width;
  overlay_view.height = view.options.height;
  overlay_view.pixel_ratio = view.options.pixel_ratio;
  OverlayTriangles triangles = overlay_triangles(view.scene.overlay, overlay_view);
  std::vector<OverlayVertex>& all = triangles.anywhere;
  const std::size_t num_anywhere = all.size();
  all.insert(all.end(), triangles.in_sight.begin(), triangles.in_sight.end());
  if (all.empty()) return;
  glBindVertexArray(m_overlay_array.id());
  glBindBuffer(GL_ARRAY_BUFFER, m_overlay_buffer.id());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(all.size() * sizeof(OverlayVertex)),
               all.data(), GL_STREAM_DRAW);
  blend_over();
  glDepthMask(GL_FALSE);
  m_programs.overlay.use();
  glDisable(GL_DEPTH_TEST);
  glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(num_anywhere));
  glEnable(GL_DEPTH_TEST);
  glDrawArrays(GL_TRIANGLES, static_cast<GLint>(num_anywhere),
               static_cast<GLsizei>(all.size() - num_anywhere));
  prepare_to_draw_solids();
}

void LiveRenderer::draw_outlines(const View& view, const LiveTargets& targets) {
  // Limits the pass to the screen area of the outlined objects.
  Eigen::Array2d lower(1, 1), upper(-1, -1);
  std::vector<const Instance*> outlined;
  for (const Instance& instance : m_instances) {
    if (!instance.object->outlined || !instance.seen) continue;
    outlined.push_back(&instance);
    for (const Vec3& corner : instance.corners) {
      const Eigen::Vector4d p = view.clip_from_world * corner.homogeneous();
      Eigen::Array2d a(-1, -1), b(1, 1);  // behind the eye: anywhere
      if (p.w() > 1e-9) a = b = p.head<2>().array() / p.w();
      lower = lower.min(a), upper = upper.max(b);
    }
  }
  if (outlined.empty()) return;
  const Eigen::Array2d size(targets.width, targets.height);
  const float reach = kOutlinePx * static_cast<float>(view.options.pixel_ratio);
  const Eigen::Array2d first = (0.5 * (lower.max(-1) + 1) * size - reach - 1).floor();
  const Eigen::Array2d end = (0.5 * (upper.min(1) + 1) * size + reach + 1).ceil();
  const auto restrict_to = [&](double room) {
    const Eigen::Array2i a = (first - room).cast<int>(), b = (end + room).cast<int>();
    glScissor(a.x(), a.y(), std::max(b.x() - a.x(), 0), std::max(b.y() - a.y(), 0));
  };
  prepare_to_draw_solids();
  glDisable(GL_DEPTH_TEST);
  glEnable(GL_SCISSOR_TEST);
  restrict_to(std::ceil(reach) + 1);  // outlines sample this far beside themselves
  glBindFramebuffer(GL_FRAMEBUFFER, targets.draw_mask.id());
  glClearBufferfv(GL_COLOR, 0, LiveColour{}.data());
  prepare_objects(view, m_programs.mask);
  for (const Instance* instance : outlined) draw_one(m_programs.mask, *instance, Part::All);
  restrict_to(0);
  glBindFramebuffer(GL_FRAMEBUFFER, targets.draw_picture.id());
  blend_over();
  m_programs.outline.use();
  bind_texture(0, GL_TEXTURE_2D, targets.mask.id());
  set_uniform(m_programs.outline, "mask", 0);
  set_uniform(m_programs.outline, "outline", view.options.theme.outline);
  set_uniform(m_programs.outline, "reach", reach);
  glBindVertexArray(m_no_attributes.id());
  glDrawArrays(GL_TRIANGLES, 0, 3);
  prepare_to_draw_solids();
}

Image LiveRenderer::read(const LiveTargets& targets) const {
  glBindFramebuffer(GL_FRAMEBUFFER, targets.draw_picture.id());
  return read_picture(targets.width, targets.height);
}

}  // namespace trivet
