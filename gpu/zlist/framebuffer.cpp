#include "gpu/zlist/framebuffer.h"

#include <algorithm>
#include <bit>

namespace trivet {
namespace {

using zlist_shaders::Pass;

constexpr float kNone = -1e30f;  // as in the shaders
constexpr int kTexelsPerStruct = 4;
constexpr std::size_t kTexelBytes = 24;                   // of both textures
constexpr std::size_t kMostTexels = 2 * kMaxZListPixels;  // of all targets
static_assert(sizeof(glsl::Instance) == 16 * kTexelsPerStruct);
static_assert(sizeof(glsl::Layer) == 16 * kTexelsPerStruct);

/// Sizes of targets, so that few serve all views.
int rounded(GLuint size) { return static_cast<int>(std::bit_ceil(std::max(size, 16u))); }

int limit(GLenum name) {
  GLint value = 0;
  glGetIntegerv(name, &value);
  return value;
}

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
    glDisable(GL_BLEND);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glBindVertexArray(0);
  }
  BlendState(const BlendState&) = delete;
  BlendState& operator=(const BlendState&) = delete;
};

template <class T>
void send(const GlBuffer& buffer, const std::vector<T>& data) {
  glBindBuffer(GL_TEXTURE_BUFFER, buffer.id());
  glBufferData(GL_TEXTURE_BUFFER, static_cast<GLsizeiptr>(data.size() * sizeof(T)), data.data(),
               GL_STREAM_DRAW);
}

GlTexture make_texels(const GlBuffer& buffer) {
  GlTexture out = GlTexture::create();
  glBindBuffer(GL_TEXTURE_BUFFER, buffer.id());  // creates it
  glBindTexture(GL_TEXTURE_BUFFER, out.id());
  glTexBuffer(GL_TEXTURE_BUFFER, GL_RGBA32UI, buffer.id());
  check_gl("making room for z-lists");
  return out;
}

}  // namespace

ZListTarget::ZListTarget(int wide, int high, int deep)
    : width(wide),
      height(high),
      num_layers(deep),
      moving(make_texture_array(GL_RGBA32F, wide, high, deep)),
      nearest(make_texture_array(GL_RG32F, wide, high, deep)),
      moving_framebuffer(make_layered_framebuffer(moving.id())),
      nearest_framebuffer(make_layered_framebuffer(nearest.id())) {}

ZListFramebuffers::ZListFramebuffers()
    : m_instances(GlBuffer::create()),
      m_layers(GlBuffer::create()),
      m_instance_texels(make_texels(m_instances)),
      m_layer_texels(make_texels(m_layers)),
      m_max_instances(static_cast<std::size_t>(limit(GL_MAX_TEXTURE_BUFFER_SIZE)) /
                      kTexelsPerStruct),
      m_max_layers(static_cast<std::size_t>(limit(GL_MAX_ARRAY_TEXTURE_LAYERS))) {}

std::size_t ZListFramebuffers::num_bytes() { return kTexelBytes * kMostTexels; }

bool ZListFramebuffers::has_room(std::size_t num_views, std::size_t num_bodies, int width,
                                 int height) const {
  // Targets have sizes of powers of two, so that few of them serve all views.
  const std::size_t deep = std::bit_ceil(num_views);
  const auto wide = static_cast<std::size_t>(rounded(static_cast<GLuint>(width)));
  const auto high = static_cast<std::size_t>(rounded(static_cast<GLuint>(height)));
  return deep <= m_max_layers && num_bodies <= m_max_instances &&
         wide * high * deep <= kMaxZListPixels;
}

const GlProgram& ZListFramebuffers::program(Motion::Kind kind, Pass pass) {
  using namespace zlist_shaders;
  const auto known = m_programs.find({kind, pass});
  if (known != m_programs.end()) return known->second;
  GlProgram made("z-list depths", {{GL_VERTEX_SHADER, face_vertex(kind)},
                                   {GL_GEOMETRY_SHADER, quad_geometry(kind)},
                                   {GL_FRAGMENT_SHADER, depth_fragment(kind, pass)}});
  return m_programs.emplace(std::pair(kind, pass), std::move(made)).first->second;
}

// Targets stay, as sizes come again; when there are too many, all go.
const ZListTarget& ZListFramebuffers::target_for(const ZListBatch& batch) {
  const std::array<int, 3> size = {rounded(batch.width), rounded(batch.height),
                                   static_cast<int>(std::bit_ceil(batch.layers.size()))};
  const auto known = m_targets.find(size);
  if (known != m_targets.end()) return known->second;
  const auto num_texels = [](const std::array<int, 3>& s) {
    return static_cast<std::size_t>(s[0]) * s[1] * s[2];
  };
  // A new size may not push all targets beyond the limit.
  std::size_t sum = num_texels(size);
  for (const auto& target : m_targets) sum += num_texels(target.first);
  if (sum > kMostTexels) m_targets.clear();
  return m_targets.emplace(size, ZListTarget(size[0], size[1], size[2])).first->second;
}

void ZListFramebuffers::draw(const ZListBatch& batch, Pass pass, const ZListTarget& target) {
  // Instances and layers are read from texels, as OpenGL 3.3 has no storage buffers.
  const GlProgram& p = program(batch.kind, pass);
  p.use();
  bind_texture(0, GL_TEXTURE_2D_ARRAY, target.moving.id());
  bind_texture(1, GL_TEXTURE_BUFFER, m_instance_texels.id());
  bind_texture(2, GL_TEXTURE_BUFFER, m_layer_texels.id());
  glUniform1i(p.uniform("moving"), 0);
  glUniform1i(p.uniform("instances"), 1);
  glUniform1i(p.uniform("layers"), 2);
  glUniform2i(p.uniform("target_size"), target.width, target.height);
  const bool moves = pass == Pass::Moving;
  glBindFramebuffer(GL_FRAMEBUFFER,
                    (moves ? target.moving_framebuffer : target.nearest_framebuffer).id());
  const float none[] = {kNone, kNone, kNone, kNone};
  // Maxima are blended over this value, which is below all depths.
  glClearBufferfv(GL_COLOR, 0, none);
  const GLint first_instance = p.uniform("first_instance");
  // All bodies of one mesh are instances of one call.
  for (const ZListJob& job : moves ? batch.moving : batch.fixed) {
    glUniform1i(first_instance, static_cast<GLint>(job.first_instance));
    glBindVertexArray(job.mesh->vertex_array.id());
    glDrawElementsInstanced(GL_TRIANGLES, 3 * job.mesh->num_faces, GL_UNSIGNED_INT, nullptr,
                            static_cast<GLsizei>(job.num_instances));
  }
  check_gl("drawing z-lists");
}

const ZListTarget& ZListFramebuffers::draw(const ZListBatch& batch) {
  const BlendState state;
  send(m_instances, batch.instances);
  send(m_layers, batch.layers);
  const ZListTarget& target = target_for(batch);
  glViewport(0, 0, target.width, target.height);
  draw(batch, Pass::Moving, target);
  draw(batch, Pass::Fixed, target);
  return target;
}

}  // namespace trivet
