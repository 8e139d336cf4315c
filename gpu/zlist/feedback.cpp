// z-lists with OpenGL 3.3: framebuffers, whose doubtful pixels are found on the CPU, then a point
// per list entry by transform feedback.
#include <algorithm>
#include <cmath>

#include "gpu/zlist/framebuffer.h"

namespace trivet {
namespace {

using zlist_shaders::Pass;

/// Listing more doubtful pixels than this is too slow without compute shaders.
constexpr std::size_t kMaxDoubtful = 1 << 15;

bool is_none(float x) { return x < -1e29f; }  // as in the shaders
float below(float gap) { return gap - 2e-6f * std::abs(gap); }

struct GlQueryKind {
  static GLuint create() {
    GLuint id = 0;
    glGenQueries(1, &id);
    return id;
  }
  static void destroy(GLuint id) { glDeleteQueries(1, &id); }
};

/// Restores the state that other code expects of a fresh context.
class FeedbackState {
 public:
  explicit FeedbackState(const GlFramebuffer& target) {
    glBindFramebuffer(GL_FRAMEBUFFER, target.id());
    glEnable(GL_RASTERIZER_DISCARD);
  }
  ~FeedbackState() {
    glDisable(GL_RASTERIZER_DISCARD);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glBindVertexArray(0);
  }
  FeedbackState(const FeedbackState&) = delete;
  FeedbackState& operator=(const FeedbackState&) = delete;
};

/// The pixels of a view, row by row.
struct Texels {
  std::span<const std::array<float, 4>> moving;   // front, -rear, sample
  std::span<const std::array<float, 2>> nearest;  // -nearest, -bound of the time

  bool has_both(std::size_t i) const { return !is_none(nearest[i][0]); }
  float gap(std::size_t i) const { return below(-nearest[i][0] - moving[i][0]); }
};

constexpr std::size_t kTexelFloats = 6;

ZLists lists_of(const ZListView& view, const Texels& texels) {
  ZLists out;
  out.upper = out.lower = view.horizon;
  // A first pass finds the bounds, a second one the pixels within them.
  for (std::size_t i = 0; i < texels.nearest.size(); ++i) {
    if (!texels.has_both(i)) continue;
    ++out.num_pixels;
    if (!is_none(texels.nearest[i][1])) out.upper = std::min(out.upper, -texels.nearest[i][1]);
    out.lower = std::min(out.lower, std::max(0.0f, texels.gap(i)));
  }
  for (std::size_t i = 0; i < texels.nearest.size(); ++i)
    if (texels.has_both(i) && texels.gap(i) <= out.upper)
      out.entries.push_back({static_cast<std::uint32_t>(i), 0, 0, 0});
  out.num_doubtful = static_cast<std::int64_t>(out.entries.size());
  out.handed_over = view.most_handed_over > 0 && out.entries.size() <= view.most_handed_over;
  return out;
}

class FeedbackRaster : public ZListRaster {
 public:
  explicit FeedbackRaster(std::uint32_t max_entries);
  const char* description() const override { return "framebuffers, transform feedback"; }
  std::size_t num_bytes() const override {
    return ZListFramebuffers::num_bytes() + m_max_entries * sizeof(ZListEntry) +
           sizeof(float) * kTexelFloats * kMaxZListPixels;
  }
  bool has_room(std::size_t num_views, std::size_t num_bodies, int width,
                int height) const override {
    return m_framebuffers.has_room(num_views, num_bodies, width, height);
  }
  bool prefers_large_pixels() const override { return true; }
  std::vector<ZLists> rasterise(std::span<const ZListView> views, ZListOutput output) override;

 private:
  void list(std::span<const ZListView> views, std::vector<ZLists>& lists);
  std::vector<ZLists> read_depths(std::span<const ZListView> views);
  const GlProgram& program(Motion::Kind kind, Pass pass);
  void list(const ZListView& view, int layer, ZLists& lists);
  GLuint draw_lists(const ZListView& view, Pass pass, int layer, int pixels_per_run,
                    const ZLists& lists);
  bool list(const ZListView& view, Pass pass, int layer, int pixels_per_run, ZLists& lists);

  std::size_t m_max_entries;
  ZListFramebuffers m_framebuffers;
  const ZListTarget* m_target = nullptr;  // of the last batch
  GlFramebuffer m_read;                   // of one layer
  GlTexture m_nothing;
  GlFramebuffer m_no_target;  // complete, so that draw calls are legal, though they write no pixels
  GlBuffer m_texels, m_records, m_doubtful;
  GlTexture m_doubtful_texture;
  GlHandle<GlQueryKind> m_generated;
  std::map<std::pair<Motion::Kind, Pass>, GlProgram> m_programs;
};

FeedbackRaster::FeedbackRaster(std::uint32_t max_entries)
    : m_max_entries(max_entries),
      m_read(GlFramebuffer::create()),
      m_nothing(make_texture_2d(GL_RGBA32F, 1, 1)),
      m_no_target(make_framebuffer({m_nothing.id()}, 0)),
      m_texels(GlBuffer::create()),
      m_records(
          make_buffer(GL_TRANSFORM_FEEDBACK_BUFFER, nullptr, max_entries * sizeof(ZListEntry))),
      m_doubtful(make_buffer(GL_TEXTURE_BUFFER, nullptr, 4 * kMaxDoubtful)),
      m_doubtful_texture(GlTexture::create()),
      m_generated(GlHandle<GlQueryKind>::create()) {
  glBindTexture(GL_TEXTURE_BUFFER, m_doubtful_texture.id());
  glTexBuffer(GL_TEXTURE_BUFFER, GL_RG16UI, m_doubtful.id());
  check_gl("making room for z-lists");
}

const GlProgram& FeedbackRaster::program(Motion::Kind kind, Pass pass) {
  using namespace zlist_shaders;
  const auto known = m_programs.find({kind, pass});
  if (known != m_programs.end()) return known->second;
  GlProgram made(
      "z-lists",
      {{GL_VERTEX_SHADER, list_vertex(kind)}, {GL_GEOMETRY_SHADER, list_geometry(kind, pass)}},
      "record");
  return m_programs.emplace(std::pair(kind, pass), std::move(made)).first->second;
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

// All layers of both textures, in one read.
std::vector<ZLists> FeedbackRaster::read_depths(std::span<const ZListView> views) {
  // The read waits once for all layers: copies go into one buffer.
  std::size_t num_texels = 0;
  for (const ZListView& v : views) num_texels += static_cast<std::size_t>(v.width) * v.height;
  const std::size_t bytes = sizeof(float) * kTexelFloats * num_texels;
  glBindBuffer(GL_PIXEL_PACK_BUFFER, m_texels.id());
  glBufferData(GL_PIXEL_PACK_BUFFER, static_cast<GLsizeiptr>(bytes), nullptr, GL_STREAM_READ);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, m_read.id());
  std::size_t at = 0;
  const auto read = [&](GLuint texture, std::size_t layer, GLenum format, std::size_t floats) {
    const ZListView& v = views[layer];
    glFramebufferTextureLayer(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, texture, 0,
                              static_cast<GLint>(layer));
    glReadPixels(0, 0, v.width, v.height, format, GL_FLOAT, const_cast<void*>(buffer_offset(at)));
    at += sizeof(float) * floats * v.width * v.height;
  };
  // Both textures of a layer follow each other.
  for (std::size_t i = 0; i < views.size(); ++i) {
    read(m_target->moving.id(), i, GL_RGBA, 4);
    read(m_target->nearest.id(), i, GL_RG, 2);
  }
  std::vector<float> texels(kTexelFloats * num_texels);
  glGetBufferSubData(GL_PIXEL_PACK_BUFFER, 0, static_cast<GLsizeiptr>(bytes), texels.data());
  glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
  check_gl("reading depths back");
  // The copy is cut into views again.
  std::vector<ZLists> out;
  const float* next = texels.data();
  for (const ZListView& v : views) {
    const std::size_t n = static_cast<std::size_t>(v.width) * v.height;
    out.push_back(lists_of(v, {{reinterpret_cast<const std::array<float, 4>*>(next), n},
                               {reinterpret_cast<const std::array<float, 2>*>(next + 4 * n), n}}));
    next += kTexelFloats * n;
  }
  out[0].bytes_read_back = static_cast<std::int64_t>(bytes);
  out[0].read_backs = 1;
  return out;
}

// Writes the records; returns the number that would be needed.
GLuint FeedbackRaster::draw_lists(const ZListView& view, Pass pass, int layer, int pixels_per_run,
                                  const ZLists& lists) {
  const GlProgram& p = program(view.kind, pass);
  p.use();
  set_view_uniforms(p, view);
  bind_texture(0, GL_TEXTURE_2D_ARRAY, m_target->moving.id());
  bind_texture(1, GL_TEXTURE_2D_ARRAY, m_target->nearest.id());
  bind_texture(2, GL_TEXTURE_BUFFER, m_doubtful_texture.id());
  glUniform1i(p.uniform("moving"), 0);
  glUniform1i(p.uniform("nearest"), 1);
  glUniform1i(p.uniform("doubtful"), 2);
  glUniform1i(p.uniform("layer"), layer);
  const auto num_doubtful = static_cast<int>(lists.num_doubtful);
  glUniform1i(p.uniform("num_doubtful"), num_doubtful);
  glUniform1i(p.uniform("pixels_per_run"), pixels_per_run);
  glUniform1f(p.uniform("upper"), lists.upper);
  glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, m_records.id());
  glBeginQuery(GL_PRIMITIVES_GENERATED, m_generated.id());
  glBeginTransformFeedback(GL_POINTS);
  // An instance handles a run of pixels, so that a face over many of them is split.
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
bool FeedbackRaster::list(const ZListView& view, Pass pass, int layer, int pixels_per_run,
                          ZLists& lists) {
  const GLuint num_records = draw_lists(view, pass, layer, pixels_per_run, lists);
  // Entries beyond the buffer are lost: all of them have to be made in another way.
  if (num_records > m_max_entries) return false;
  if (num_records == 0) return true;
  const std::size_t before = lists.entries.size();
  lists.entries.resize(before + num_records);
  const std::size_t bytes = num_records * sizeof(ZListEntry);
  glBindBuffer(GL_TRANSFORM_FEEDBACK_BUFFER, m_records.id());
  glGetBufferSubData(GL_TRANSFORM_FEEDBACK_BUFFER, 0, static_cast<GLsizeiptr>(bytes),
                     lists.entries.data() + before);
  lists.bytes_read_back += static_cast<std::int64_t>(bytes);
  ++lists.read_backs;
  check_gl("reading z-lists back");
  // A run that had too many ends with a mark.
  const auto added = lists.entries.begin() + static_cast<std::ptrdiff_t>(before);
  const bool complete = std::none_of(added, lists.entries.end(), [](const ZListEntry& e) {
    return e.pixel == zlist_shaders::kTooMany;
  });
  if (!complete) lists.entries.resize(before);
  return complete;
}

// Replaces the doubtful pixels of a view by lists.
void FeedbackRaster::list(const ZListView& view, int layer, ZLists& lists) {
  std::vector<std::uint16_t> doubtful;  // x y of each, row by row
  for (const ZListEntry& e : lists.entries) {
    doubtful.push_back(static_cast<std::uint16_t>(e.pixel % view.width));
    doubtful.push_back(static_cast<std::uint16_t>(e.pixel / view.width));
  }
  lists.entries.clear();
  // Doubtful pixels beyond the buffer need larger pixels.
  lists.overflow = doubtful.size() / 2 > kMaxDoubtful;
  if (doubtful.empty() || lists.overflow) return;
  glBindBuffer(GL_TEXTURE_BUFFER, m_doubtful.id());
  glBufferSubData(GL_TEXTURE_BUFFER, 0, static_cast<GLsizeiptr>(doubtful.size() * 2),
                  doubtful.data());
  // Long runs are fast; where a face has too many entries in one, short ones are tried.
  for (const Pass pass : {Pass::MovingLists, Pass::FixedLists})
    lists.overflow =
        lists.overflow || (!list(view, pass, layer, zlist_shaders::kManyPixelsPerRun, lists) &&
                           !list(view, pass, layer, zlist_shaders::kFewPixelsPerRun, lists));
}

std::vector<ZLists> FeedbackRaster::rasterise(std::span<const ZListView> views,
                                              ZListOutput output) {
  m_target = &m_framebuffers.draw(make_batch(views));
  std::vector<ZLists> out = read_depths(views);
  if (output == ZListOutput::Lists) list(views, out);
  if (output == ZListOutput::Bounds)
    for (ZLists& lists : out) lists.entries.clear();
  return out;
}

void FeedbackRaster::list(std::span<const ZListView> views, std::vector<ZLists>& lists) {
  const FeedbackState state(m_no_target);
  for (std::size_t i = 0; i < views.size(); ++i)
    if (!lists[i].handed_over) list(views[i], static_cast<int>(i), lists[i]);
}

}  // namespace

std::unique_ptr<ZListRaster> make_feedback_raster(std::uint32_t max_entries) {
  return std::make_unique<FeedbackRaster>(max_entries);
}

}  // namespace trivet
