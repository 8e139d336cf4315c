#include "gpu/live/renderer.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "gpu/live/key.h"
#include "gpu/live/shaders.h"
#include "gpu/picture/shaders.h"
#include "gpu/picture/shadow_map.h"

namespace trivet {
namespace {

namespace shaders = live_shaders;
using picture_shaders::Surfaces;

constexpr int kSamples = 4;  // per pixel

GlTexture make_shadow_texture() {
  GlTexture texture = make_texture_2d(GL_DEPTH_COMPONENT32F, kLiveShadowMapPx, kLiveShadowMapPx);
  set_linear(texture);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
  return texture;
}

PictureMesh box_mesh() {
  static const auto vertices = [] {
    std::array<Vec3, 8> all;
    for (int i = 0; i < 8; ++i) all[i] = box_corner({Vec3::Constant(-1), Vec3::Constant(1)}, i);
    return all;
  }();
  static const std::array<Index3, 12> triangles{Index3{0, 2, 3}, Index3{0, 3, 1}, Index3{4, 5, 7},
                                                Index3{4, 7, 6}, Index3{0, 1, 5}, Index3{0, 5, 4},
                                                Index3{2, 6, 7}, Index3{2, 7, 3}, Index3{0, 4, 6},
                                                Index3{0, 6, 2}, Index3{1, 3, 7}, Index3{1, 7, 5}};
  PictureMesh mesh;
  mesh.vertices = vertices;
  mesh.triangles = triangles;
  return mesh;
}

void describe_overlay_vertices() {
  constexpr GLsizei kStride = sizeof(OverlayVertex);
  glVertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, kStride, buffer_offset(0));
  glVertexAttribPointer(1, 4, GL_FLOAT, GL_FALSE, kStride, buffer_offset(16));
  glVertexAttribPointer(2, 3, GL_FLOAT, GL_FALSE, kStride, buffer_offset(32));
  for (GLuint location = 0; location < 3; ++location) glEnableVertexAttribArray(location);
}
static_assert(offsetof(OverlayVertex, colour) == 16 && offsetof(OverlayVertex, beside) == 32);

}  // namespace

const Vec3 kLiveLight = Vec3(-0.42, -0.38, 0.90).normalized();

void bind_target(const GlFramebuffer& framebuffer, int width, int height) {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
  glViewport(0, 0, width, height);
}

void copy_target(const GlFramebuffer& from, const GlFramebuffer& to, int width, int height,
                 GLbitfield what) {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, from.id());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, to.id());
  glBlitFramebuffer(0, 0, width, height, 0, 0, width, height, what, GL_NEAREST);
}

void prepare_to_draw_solids() {
  glDisable(GL_BLEND);
  glDisable(GL_CULL_FACE);
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_POLYGON_OFFSET_FILL);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glDepthMask(GL_TRUE);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

void blend_over() {
  glEnable(GL_BLEND);
  glBlendEquation(GL_FUNC_ADD);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
}

Eigen::Matrix4d world_from_frame(const PictureFrame& frame) {
  Eigen::Matrix4d m = Eigen::Matrix4d::Identity();
  m.topLeftCorner<3, 3>() /= frame.scale;
  m.topRightCorner<3, 1>() = frame.centre;
  return m;
}

MeshProgram::MeshProgram(const char* name, const std::string& vertex, const std::string& fragment)
    : program(name, vertex, fragment),
      frame_from_object(program.uniform("frame_from_object")),
      frame_from_normal(program.uniform("frame_from_normal")),
      tint(program.uniform("tint")),
      opacity(program.uniform("opacity")),
      finish(program) {}

LivePrograms::LivePrograms()
    : object("objects", shaders::object_vertex(Surfaces::Plain),
             shaders::object_fragment(Surfaces::Plain)),
      textured_object("textured objects", shaders::object_vertex(Surfaces::Textured),
                      shaders::object_fragment(Surfaces::Textured)),
      shadow("the shadow map", picture_shaders::shadow_vertex(), shaders::empty_fragment()),
      textured_shadow("the shadow map of textured objects",
                      picture_shaders::shadow_vertex(Surfaces::Textured), shaders::cut_fragment()),
      mask("the outline's mask", picture_shaders::shadow_vertex(), shaders::mask_fragment()),
      floor("the floor", shaders::floor_vertex(), shaders::floor_fragment()),
      backdrop("the backdrop", picture_shaders::whole_target_vertex(),
               shaders::backdrop_fragment()),
      outline("outlines", picture_shaders::whole_target_vertex(), shaders::outline_fragment()),
      overlay("overlays", shaders::overlay_vertex(), shaders::overlay_fragment()) {}

LiveTargets::LiveTargets(int its_width, int its_height, int samples)
    : width(its_width),
      height(its_height),
      colour(make_renderbuffer(GL_RGBA8, width, height, samples)),
      depth(make_renderbuffer(GL_DEPTH_COMPONENT32F, width, height, samples)),
      picture(make_texture_2d(GL_RGBA8, width, height)),
      mask(make_texture_2d(GL_RGBA8, width, height)),
      draw(make_framebuffer(colour, depth)),
      draw_picture(make_framebuffer({picture.id()}, 0)),
      draw_mask(make_framebuffer({mask.id()}, 0)) {}

LiveStill::LiveStill(int its_width, int its_height)
    : width(its_width),
      height(its_height),
      colour(make_renderbuffer(GL_RGBA8, width, height, 0)),
      depth(make_renderbuffer(GL_DEPTH_COMPONENT32F, width, height, 0)),
      draw(make_framebuffer(colour, depth)) {}

LiveRenderer::LiveRenderer(std::int64_t many_triangles)
    : m_many_triangles(many_triangles),
      m_no_attributes(GlVertexArray::create()),
      m_overlay_array(GlVertexArray::create()),
      m_overlay_buffer(GlBuffer::create()),
      m_shadow_map(make_shadow_texture()),
      m_draw_shadow_map(GlFramebuffer::create()) {
  m_box = upload_mesh(box_mesh(), 0);
  glBindFramebuffer(GL_FRAMEBUFFER, m_draw_shadow_map.id());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, m_shadow_map.id(), 0);
  glDrawBuffer(GL_NONE);
  glReadBuffer(GL_NONE);
  glBindVertexArray(m_overlay_array.id());
  glBindBuffer(GL_ARRAY_BUFFER, m_overlay_buffer.id());
  describe_overlay_vertices();
  check_gl("preparing live views");
}

void LiveRenderer::draw_shadow_map(const View& view, bool of_moving) {
  std::vector<const Instance*> casters;
  for (const Instance& instance : m_instances)
    if (instance.object->opacity >= 1 && (of_moving || !instance.object->moving))
      casters.push_back(&instance);
  std::sort(casters.begin(), casters.end(),  // in the scene's order, independent of the camera
            [](const Instance* a, const Instance* b) { return a->object < b->object; });
  const int size_px = view.options.draft ? kDraftShadowMapPx : kLiveShadowMapPx;
  std::string key;
  std::vector<Vec3> hull;
  for (const Instance* caster : casters) {
    append_key(key, *caster->object);
    for (const Vec3& corner : caster->corners) hull.push_back(m_frame.apply(corner));
  }
  if (m_shadow_key == key && m_shadow_px >= size_px) return;
  m_shadow_key = std::move(key);
  m_work.shadow_map_drawn = true;
  const ShadowMap map = fit_shadow_map(kLiveLight, hull, size_px, Vec2::Zero());
  m_shadow_px = size_px;
  m_shadow_texel = map.texel / m_frame.scale;
  Eigen::Matrix4d map_from_clip = Eigen::Matrix4d::Identity() * 0.5;
  map_from_clip.col(3) << 0.5, 0.5, 0.5, 1;
  m_map_from_world =
      map_from_clip * map.clip_from_frame.cast<double>() * world_from_frame(m_frame).inverse();
  prepare_to_draw_solids();
  bind_target(m_draw_shadow_map, size_px, size_px);
  const float farthest = 1;
  glClearBufferfv(GL_DEPTH, 0, &farthest);
  for (const MeshProgram* program : {&m_programs.shadow, &m_programs.textured_shadow}) {
    program->program.use();
    set_uniform(program->program, "clip_from_frame",
                Eigen::Matrix4d(map.clip_from_frame.cast<double>()));
    set_uniform(program->program, "materials", 0);
    for (const Instance* caster : casters)
      if (caster->mesh->textured() == (program == &m_programs.textured_shadow))
        draw_one(*program, *caster, Part::Solid);
  }
}

Image LiveRenderer::draw(const LiveScene& scene, const LiveCamera& camera,
                         const LiveOptions& options) {
  m_work = {};
  View view{scene, camera, options, make_view_axes(camera, double(options.width) / options.height)};
  place_instances(scene);
  view.floor_centre = Vec3(camera.target.x(), camera.target.y(), 0);
  view.floor_radius = std::max(3 * view.reach(), 4 * m_frame.radius / m_frame.scale);
  Kept& kept = m_views[options.view];
  std::optional<LiveTargets>& targets = options.draft ? kept.draft : kept.full;
  if (!targets || targets->width != options.width || targets->height != options.height) {
    targets.reset();  // free before allocating
    targets.emplace(options.width, options.height, options.draft ? 0 : kSamples);
  }
  find_depth_range(view);
  if (options.draft && m_num_triangles > m_many_triangles) {
    draw_draft(view, kept);
  } else {
    draw_all(view, *targets);
  }
  draw_translucent(view);
  draw_overlay(view);
  copy_target(targets->draw, targets->draw_picture, options.width, options.height,
              GL_COLOR_BUFFER_BIT);
  draw_outlines(view, *targets);
  check_gl("drawing a view");
  return read(*targets);
}

void LiveRenderer::draw_all(View& view, const LiveTargets& targets) {
  view.clip_from_world = clip_from_world(view.camera, view.axes, view.near_depth, view.far_depth);
  cull(view);
  if (view.options.shadows) draw_shadow_map(view, true);
  prepare_to_draw_solids();
  bind_target(targets.draw, targets.width, targets.height);
  draw_backdrop(view);
  draw_solid(view, true, true);
}

}  // namespace trivet
