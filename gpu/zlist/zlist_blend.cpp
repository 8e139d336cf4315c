// z-lists with OpenGL 3.3: framebuffers that blend maxima, then a point per list entry by transform
// feedback. The doubtful pixels are found on the CPU.
#include <algorithm>
#include <cmath>
#include <map>

#include "gpu/egl/gl_objects.h"
#include "gpu/zlist/zlist_lists.h"
#include "gpu/zlist/zlist_shaders.h"

namespace trivet {
namespace {

using zlist_shaders::Pass;
using Texel = std::array<float, 4>;

constexpr float kNone = -1e30f;  // as in the shaders
/// Listing more doubtful pixels than this is too slow without compute shaders.
constexpr std::size_t kMaxDoubtful = 1 << 15;

bool is_none(float x) { return x < -1e29f; }

struct GlQueryKind {
  static GLuint create() {
    GLuint id = 0;
    glGenQueries(1, &id);
    return id;
  }
  static void destroy(GLuint id) { glDeleteQueries(1, &id); }
};

/// Restores the state that other code expects of a fresh context.
class BlendState {
 public:
  BlendState() {
    glEnable(GL_BLEND);
    glBlendEquation(GL_MAX);
    glDisable(GL_CULL_FACE);
    glDisable(GL_DEPTH_TEST);
  }
  ~BlendState() {
    glDisable(GL_RASTERIZER_DISCARD);
    glDisable(GL_BLEND);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glBindVertexArray(0);
  }
  BlendState(const BlendState&) = delete;
  BlendState& operator=(const BlendState&) = delete;
};

void bind_texture(int unit, GLenum target, GLuint id) {
  glActiveTexture(GL_TEXTURE0 + unit);
  glBindTexture(target, id);
}

class BlendRaster : public ZListRaster {
 public:
  BlendRaster(int resolution, std::uint32_t max_entries);
  const char* method() const override { return "blended framebuffers"; }
  std::size_t num_bytes() const override {
    return 2 * sizeof(Texel) * m_resolution * m_resolution + m_max_entries * sizeof(ZListEntry);
  }
  bool has_room(std::size_t /*num_views*/, std::size_t num_pixels) const override {
    return num_pixels <= m_resolution * m_resolution;
  }
  std::vector<ZLists> rasterise(std::span<const ZListView> views, bool bounds_alone) override;

 private:
  ZLists rasterise(const ZListView& view, bool bounds_alone);
  const GlProgram& program(Motion::Kind kind, Pass pass);
  void draw(const ZListView& view, Pass pass, const GlFramebuffer& target);
  std::vector<Texel> read(const ZListView& view, const GlFramebuffer& target, ZLists& lists);
  std::vector<std::uint16_t> find_doubtful(const ZListView& view, ZLists& lists);
  void send_doubtful(const std::vector<std::uint16_t>& pixels);
  GLuint draw_lists(const ZListView& view, Pass pass, int pixels_per_run, const ZLists& lists);
  bool list(const ZListView& view, Pass pass, int pixels_per_run, ZLists& lists);

  std::size_t m_resolution;
  std::size_t m_max_entries;
  GlTexture m_moving, m_nearest, m_nothing;
  GlFramebuffer m_moving_target, m_nearest_target;
  GlFramebuffer m_no_target;  // complete, so that draw calls are legal, though they write no pixels
  GlBuffer m_records, m_doubtful;
  GlTexture m_doubtful_texture;
  GlHandle<GlQueryKind> m_generated;
  std::map<std::pair<Motion::Kind, Pass>, GlProgram> m_programs;
};

BlendRaster::BlendRaster(int resolution, std::uint32_t max_entries)
    : m_resolution(resolution),
      m_max_entries(max_entries),
      m_moving(make_texture_2d(GL_RGBA32F, resolution, resolution)),
      m_nearest(make_texture_2d(GL_RGBA32F, resolution, resolution)),
      m_nothing(make_texture_2d(GL_RGBA32F, 1, 1)),
      m_moving_target(make_framebuffer({m_moving.id()}, 0)),
      m_nearest_target(make_framebuffer({m_nearest.id()}, 0)),
      m_no_target(make_framebuffer({m_nothing.id()}, 0)),
      m_records(
          make_buffer(GL_TRANSFORM_FEEDBACK_BUFFER, nullptr, max_entries * sizeof(ZListEntry))),
      m_doubtful(make_buffer(GL_TEXTURE_BUFFER, nullptr, 4 * kMaxDoubtful)),
      m_doubtful_texture(GlTexture::create()),
      m_generated(GlHandle<GlQueryKind>::create()) {
  glBindTexture(GL_TEXTURE_BUFFER, m_doubtful_texture.id());
  glTexBuffer(GL_TEXTURE_BUFFER, GL_RG16UI, m_doubtful.id());
  check_gl("making room for z-lists");
}

const GlProgram& BlendRaster::program(Motion::Kind kind, Pass pass) {
  using namespace zlist_shaders;
  const auto known = m_programs.find({kind, pass});
  if (known != m_programs.end()) return known->second;
  const std::string vertex = face_vertex(kind);
  const auto add = [&](GlProgram made) -> const GlProgram& {
    return m_programs.emplace(std::pair(kind, pass), std::move(made)).first->second;
  };
  if (pass == Pass::MovingLists || pass == Pass::FixedLists)
    return add(GlProgram(
        "z-lists", {{GL_VERTEX_SHADER, vertex}, {GL_GEOMETRY_SHADER, list_geometry(kind, pass)}},
        "record"));
  return add(GlProgram("z-list depths", {{GL_VERTEX_SHADER, vertex},
                                         {GL_GEOMETRY_SHADER, quad_geometry(kind)},
                                         {GL_FRAGMENT_SHADER, depth_fragment(kind, pass)}}));
}

void set_view_uniforms(const GlProgram& program, const ZListView& view) {
  glUniform2i(program.uniform("size"), view.width, view.height);
  glUniform1f(program.uniform("first_radius"), view.first_radius);
  glUniform1f(program.uniform("sample_error"), view.sample_error);
  glUniform1f(program.uniform("period"), view.period);
  glUniform1f(program.uniform("first_depth"), view.first_depth);
}

void set_body_uniforms(const GlProgram& program, const ZListBody& body) {
  glUniform4fv(program.uniform("rows"), 3, body.rows.data());
  glUniform1f(program.uniform("blur"), body.blur);
  glUniform1f(program.uniform("depth_blur"), body.depth_blur);
  glUniform1ui(program.uniform("first_face"), body.first_face);
}

void draw_bodies(const GlProgram& program, const std::vector<ZListBody>& bodies, GLsizei num_runs) {
  for (const ZListBody& body : bodies) {
    set_body_uniforms(program, body);
    glBindVertexArray(body.mesh->vertex_array.id());
    glDrawElementsInstanced(GL_TRIANGLES, 3 * body.mesh->num_faces, GL_UNSIGNED_INT, nullptr,
                            num_runs);
  }
}

void BlendRaster::draw(const ZListView& view, Pass pass, const GlFramebuffer& target) {
  const GlProgram& p = program(view.kind, pass);
  p.use();
  set_view_uniforms(p, view);
  bind_texture(0, GL_TEXTURE_2D, m_moving.id());
  glUniform1i(p.uniform("moving"), 0);
  glBindFramebuffer(GL_FRAMEBUFFER, target.id());
  glViewport(0, 0, view.width, view.height);
  const Texel none = {kNone, kNone, kNone, kNone};
  glClearBufferfv(GL_COLOR, 0, none.data());
  draw_bodies(p, pass == Pass::Moving ? view.moving : view.fixed, 1);
  check_gl("drawing z-lists");
}

std::vector<Texel> BlendRaster::read(const ZListView& view, const GlFramebuffer& target,
                                     ZLists& lists) {
  std::vector<Texel> texels(static_cast<std::size_t>(view.width) * view.height);
  glBindFramebuffer(GL_FRAMEBUFFER, target.id());
  glReadPixels(0, 0, view.width, view.height, GL_RGBA, GL_FLOAT, texels.data());
  check_gl("reading depths back");
  lists.bytes_read_back += static_cast<std::int64_t>(texels.size() * sizeof(Texel));
  return texels;
}

// x y of each, row by row; also sets the bounds.
std::vector<std::uint16_t> BlendRaster::find_doubtful(const ZListView& view, ZLists& lists) {
  const std::vector<Texel> moving = read(view, m_moving_target, lists);
  const std::vector<Texel> nearest = read(view, m_nearest_target, lists);
  const auto below = [](float gap) { return gap - 2e-6f * std::abs(gap); };
  lists.upper = lists.lower = view.horizon;
  for (std::size_t i = 0; i < nearest.size(); ++i) {
    if (is_none(nearest[i][0])) continue;
    ++lists.num_pixels;
    if (!is_none(nearest[i][1])) lists.upper = std::min(lists.upper, -nearest[i][1]);
    const float gap = below(-nearest[i][0] - moving[i][0]);
    lists.lower = std::min(lists.lower, std::max(0.0f, gap));
  }
  std::vector<std::uint16_t> out;
  for (std::size_t i = 0; i < nearest.size(); ++i)
    if (!is_none(nearest[i][0]) && below(-nearest[i][0] - moving[i][0]) <= lists.upper) {
      out.push_back(static_cast<std::uint16_t>(i % view.width));
      out.push_back(static_cast<std::uint16_t>(i / view.width));
    }
  lists.num_doubtful = static_cast<std::int64_t>(out.size() / 2);
  return out;
}

void BlendRaster::send_doubtful(const std::vector<std::uint16_t>& pixels) {
  glBindBuffer(GL_TEXTURE_BUFFER, m_doubtful.id());
  glBufferSubData(GL_TEXTURE_BUFFER, 0, static_cast<GLsizeiptr>(pixels.size() * 2), pixels.data());
}

// Writes the records; returns the number that would be needed.
GLuint BlendRaster::draw_lists(const ZListView& view, Pass pass, int pixels_per_run,
                               const ZLists& lists) {
  const GlProgram& p = program(view.kind, pass);
  p.use();
  set_view_uniforms(p, view);
  bind_texture(0, GL_TEXTURE_2D, m_moving.id());
  bind_texture(1, GL_TEXTURE_2D, m_nearest.id());
  bind_texture(2, GL_TEXTURE_BUFFER, m_doubtful_texture.id());
  glUniform1i(p.uniform("moving"), 0);
  glUniform1i(p.uniform("nearest"), 1);
  glUniform1i(p.uniform("doubtful"), 2);
  const auto num_doubtful = static_cast<int>(lists.num_doubtful);
  glUniform1i(p.uniform("num_doubtful"), num_doubtful);
  glUniform1i(p.uniform("pixels_per_run"), pixels_per_run);
  glUniform1f(p.uniform("upper"), lists.upper);
  glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, m_records.id());
  glBeginQuery(GL_PRIMITIVES_GENERATED, m_generated.id());
  glBeginTransformFeedback(GL_POINTS);
  draw_bodies(p, pass == Pass::MovingLists ? view.moving : view.fixed,
              (num_doubtful + pixels_per_run - 1) / pixels_per_run);
  glEndTransformFeedback();
  glEndQuery(GL_PRIMITIVES_GENERATED);
  GLuint num_records = 0;
  glGetQueryObjectuiv(m_generated.id(), GL_QUERY_RESULT, &num_records);
  check_gl("drawing z-lists");
  return num_records;
}

// Adds the entries of a pass; false if one run, or all together, had too many.
bool BlendRaster::list(const ZListView& view, Pass pass, int pixels_per_run, ZLists& lists) {
  const GLuint num_records = draw_lists(view, pass, pixels_per_run, lists);
  if (num_records > m_max_entries) return false;
  if (num_records == 0) return true;
  const std::size_t before = lists.entries.size();
  lists.entries.resize(before + num_records);
  const std::size_t bytes = num_records * sizeof(ZListEntry);
  glBindBuffer(GL_TRANSFORM_FEEDBACK_BUFFER, m_records.id());
  glGetBufferSubData(GL_TRANSFORM_FEEDBACK_BUFFER, 0, static_cast<GLsizeiptr>(bytes),
                     lists.entries.data() + before);
  lists.bytes_read_back += static_cast<std::int64_t>(bytes);
  check_gl("reading z-lists back");
  const auto added = lists.entries.begin() + static_cast<std::ptrdiff_t>(before);
  const bool complete = std::none_of(added, lists.entries.end(), [](const ZListEntry& e) {
    return e.pixel == zlist_shaders::kTooMany;
  });
  if (!complete) lists.entries.resize(before);
  return complete;
}

ZLists BlendRaster::rasterise(const ZListView& view, bool bounds_alone) {
  const BlendState state;
  draw(view, Pass::Moving, m_moving_target);
  draw(view, Pass::Fixed, m_nearest_target);
  ZLists lists;
  const std::vector<std::uint16_t> doubtful = find_doubtful(view, lists);
  if (doubtful.empty() || bounds_alone) return lists;
  lists.overflow = doubtful.size() / 2 > kMaxDoubtful;
  if (lists.overflow) return lists;
  send_doubtful(doubtful);
  glBindFramebuffer(GL_FRAMEBUFFER, m_no_target.id());
  glEnable(GL_RASTERIZER_DISCARD);
  for (const Pass pass : {Pass::MovingLists, Pass::FixedLists})
    lists.overflow =
        lists.overflow || (!list(view, pass, zlist_shaders::kManyPixelsPerRun, lists) &&
                           !list(view, pass, zlist_shaders::kFewPixelsPerRun, lists));
  return lists;
}

std::vector<ZLists> BlendRaster::rasterise(std::span<const ZListView> views, bool bounds_alone) {
  std::vector<ZLists> out;
  for (const ZListView& view : views) out.push_back(rasterise(view, bounds_alone));
  return out;
}

}  // namespace

std::unique_ptr<ZListRaster> make_blend_raster(int resolution, std::uint32_t max_entries) {
  return std::make_unique<BlendRaster>(resolution, max_entries);
}

}  // namespace trivet
