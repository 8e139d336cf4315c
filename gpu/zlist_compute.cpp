// z-lists by compute shaders: one thread per face, minima and maxima by atomics on ordered floats.
#include <algorithm>
#include <bit>
#include <map>

#include "gpu/gl_objects.h"
#include "gpu/zlist_lists.h"
#include "gpu/zlist_shaders.h"

namespace trivet {
namespace {

using zlist_shaders::Pass;

constexpr int kMaxLarge = 1 << 15;  // faces per body that cover many pixels

/// As in the shaders.
struct Counters {
  std::uint32_t upper, lower;
  std::uint32_t num_pixels = 0, num_doubtful = 0;
  std::uint32_t doubtful_low[2] = {0xffffffffu, 0xffffffffu}, doubtful_high[2] = {0, 0};
  std::uint32_t num_entries = 0, num_large = 0;
  std::uint32_t large_groups[3] = {0, 1, 1};
};
constexpr GLintptr kNumLargeOffset = 36, kLargeGroupsOffset = 40;
static_assert(offsetof(Counters, num_large) == kNumLargeOffset);
static_assert(offsetof(Counters, large_groups) == kLargeGroupsOffset);

std::uint32_t ordered(float x) {
  const auto bits = std::bit_cast<std::uint32_t>(x);
  return (bits & 0x80000000u) != 0 ? ~bits : bits | 0x80000000u;
}

float unordered(std::uint32_t key) {
  return std::bit_cast<float>((key & 0x80000000u) != 0 ? key & 0x7fffffffu : ~key);
}

GlBuffer make_storage(std::size_t bytes) {
  GlBuffer buffer = GlBuffer::create();
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, buffer.id());
  glBufferData(GL_SHADER_STORAGE_BUFFER, static_cast<GLsizeiptr>(bytes), nullptr, GL_DYNAMIC_COPY);
  check_gl("making room for z-lists");
  return buffer;
}

class ComputeRaster : public ZListRaster {
 public:
  explicit ComputeRaster(int resolution)
      : m_plane_bytes(sizeof(std::uint32_t) * resolution * resolution),
        m_image(make_storage(4 * m_plane_bytes)),
        m_counters(make_storage(sizeof(Counters))),
        m_entries(make_storage(kMaxZListEntries * sizeof(ZListEntry))),
        m_large(make_storage(kMaxLarge * sizeof(std::uint32_t))),
        m_reduction("z-list reduction", {{GL_COMPUTE_SHADER, zlist_shaders::reduction()}}) {}

  const char* method() const override { return "compute shaders"; }
  std::size_t num_bytes() const override { return num_bytes(m_plane_bytes); }
  static std::size_t num_bytes(std::size_t plane_bytes) {
    return 4 * plane_bytes + kMaxZListEntries * sizeof(ZListEntry) + 4 * kMaxLarge;
  }
  ZLists rasterise(const ZListView& view) override;

 private:
  const GlProgram& program(Motion::Kind kind, Pass pass);
  void clear(const ZListView& view);
  void run(const ZListView& view, Pass pass);
  void run_body(const GlProgram& program, const ZListBody& body);
  void reduce(const ZListView& view);
  ZLists read_back();

  std::size_t m_plane_bytes;
  GlBuffer m_image, m_counters, m_entries, m_large;
  GlProgram m_reduction;
  std::map<std::pair<Motion::Kind, Pass>, GlProgram> m_programs;
};

const GlProgram& ComputeRaster::program(Motion::Kind kind, Pass pass) {
  const auto known = m_programs.find({kind, pass});
  if (known != m_programs.end()) return known->second;
  return m_programs
      .emplace(std::pair(kind, pass),
               GlProgram("z-lists", {{GL_COMPUTE_SHADER, zlist_shaders::compute(kind, pass)}}))
      .first->second;
}

void ComputeRaster::clear(const ZListView& view) {
  Counters counters{};
  counters.upper = counters.lower = ordered(view.horizon);
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, m_counters.id());
  glBufferSubData(GL_SHADER_STORAGE_BUFFER, 0, sizeof counters, &counters);
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, m_image.id());
  const auto plane = static_cast<GLsizeiptr>(sizeof(std::uint32_t)) * view.width * view.height;
  const std::uint32_t lowest = 0, highest = 0xffffffffu;
  const std::uint32_t first[4] = {lowest, highest, lowest, highest};
  for (int i = 0; i < 4; ++i)
    glClearBufferSubData(GL_SHADER_STORAGE_BUFFER, GL_R32UI, i * plane, plane, GL_RED_INTEGER,
                         GL_UNSIGNED_INT, &first[i]);
  const GLuint buffers[] = {m_image.id(), m_counters.id(), m_entries.id(), m_large.id()};
  for (GLuint i = 0; i < 4; ++i) glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 2 + i, buffers[i]);
  glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, m_counters.id());
}

void ComputeRaster::run(const ZListView& view, Pass pass) {
  const GlProgram& p = program(view.kind, pass);
  p.use();
  set_view_uniforms(p, view);
  glUniform1ui(p.uniform("max_entries"), kMaxZListEntries);
  glUniform1ui(p.uniform("max_large"), kMaxLarge);
  const bool moves = pass == Pass::Moving || pass == Pass::MovingLists;
  for (const ZListBody& body : moves ? view.moving : view.fixed) run_body(p, body);
  check_gl("drawing z-lists");
}

void ComputeRaster::run_body(const GlProgram& program, const ZListBody& body) {
  set_body_uniforms(program, body);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, body.mesh->vertices.id());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, body.mesh->corners.id());
  const auto num_faces = static_cast<GLuint>(body.mesh->num_faces);
  glUniform1ui(program.uniform("num_faces"), num_faces);
  glUniform1ui(program.uniform("group_per_face"), 0);
  const GLuint num_groups = (num_faces + 63) / 64, wide = std::min(num_groups, 65535u);
  glDispatchCompute(wide, (num_groups + wide - 1) / wide, 1);
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);
  glUniform1ui(program.uniform("group_per_face"), 1);
  glDispatchComputeIndirect(kLargeGroupsOffset);
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
  const std::uint32_t none = 0;
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, m_counters.id());
  glClearBufferSubData(GL_SHADER_STORAGE_BUFFER, GL_R32UI, kNumLargeOffset, 8, GL_RED_INTEGER,
                       GL_UNSIGNED_INT, &none);
}

void ComputeRaster::reduce(const ZListView& view) {
  m_reduction.use();
  set_view_uniforms(m_reduction, view);
  glDispatchCompute((view.width + 7) / 8, (view.height + 7) / 8, 1);
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

ZLists ComputeRaster::read_back() {
  Counters counters{};
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, m_counters.id());
  glGetBufferSubData(GL_SHADER_STORAGE_BUFFER, 0, sizeof counters, &counters);
  ZLists out;
  out.upper = unordered(counters.upper);
  out.lower = unordered(counters.lower);
  out.num_pixels = counters.num_pixels;
  out.num_doubtful = counters.num_doubtful;
  out.bytes_read_back = sizeof counters;
  out.overflow = counters.num_entries > kMaxZListEntries;
  if (!out.overflow && counters.num_entries > 0) {
    out.entries.resize(counters.num_entries);
    const auto bytes = static_cast<GLsizeiptr>(out.entries.size() * sizeof(ZListEntry));
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, m_entries.id());
    glGetBufferSubData(GL_SHADER_STORAGE_BUFFER, 0, bytes, out.entries.data());
    out.bytes_read_back += bytes;
  }
  check_gl("reading z-lists back");
  return out;
}

ZLists ComputeRaster::rasterise(const ZListView& view) {
  clear(view);
  run(view, Pass::Moving);
  run(view, Pass::Fixed);
  reduce(view);
  run(view, Pass::MovingLists);
  run(view, Pass::FixedLists);
  return read_back();
}

}  // namespace

std::unique_ptr<ZListRaster> make_compute_raster(int resolution) {
  return std::make_unique<ComputeRaster>(resolution);
}

}  // namespace trivet
