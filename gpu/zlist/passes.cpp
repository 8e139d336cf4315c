#include "gpu/zlist/passes.h"

#include <algorithm>
#include <cstring>

namespace trivet {
namespace {

using zlist_shaders::Depths;
using zlist_shaders::Pass;

constexpr int kMaxLarge = 1 << 15;  // faces per mesh that cover many pixels
constexpr std::size_t kLargeBytes = 2 * sizeof(std::uint32_t) * kMaxLarge;
/// Parts of a buffer begin at multiples of this: the largest alignment that OpenGL lets a driver
/// ask.
constexpr std::size_t kAlignment = 256;
/// Entries that come with the counters, in one read; more are rare and cost a second one.
constexpr std::uint32_t kFirstEntries = 2048;

constexpr glsl::Counters kNothingCounted = {0, 0, {0, 1, 1}};

std::size_t aligned(std::size_t bytes) {
  return (bytes + kAlignment - 1) / kAlignment * kAlignment;
}

void bind_range(GLuint binding, const GlBuffer& buffer, std::size_t first, std::size_t bytes) {
  glBindBufferRange(GL_SHADER_STORAGE_BUFFER, binding, buffer.id(), static_cast<GLintptr>(first),
                    static_cast<GLsizeiptr>(bytes));
}

void set_batch(const GlProgram& program, const ZListBatch& batch, std::uint32_t max_entries) {
  glUniform1ui(program.uniform("num_layers"), static_cast<GLuint>(batch.layers.size()));
  glUniform1ui(program.uniform("layer_pixels"), batch.layer_pixels);
  glUniform1ui(program.uniform("max_entries"), max_entries);
  glUniform1i(program.uniform("moving"), 0);
  glUniform1i(program.uniform("nearest"), 1);
}

/// Copies on the device.
void copy(GLenum from, std::size_t at_from, GLenum to, std::size_t at_to, std::size_t bytes) {
  glCopyBufferSubData(from, to, static_cast<GLintptr>(at_from), static_cast<GLintptr>(at_to),
                      static_cast<GLsizeiptr>(bytes));
}

/// As in the shaders: nothing is listed.
bool hands_over(const glsl::Layer& layer) {
  return layer.most_handed_over > 0 && layer.num_doubtful <= layer.most_handed_over;
}

/// False if every view hands over as many pixels as it has.
bool may_make_lists(const ZListBatch& batch) {
  return std::any_of(batch.layers.begin(), batch.layers.end(), [](const glsl::Layer& layer) {
    return layer.most_handed_over <
           static_cast<std::uint32_t>(layer.size.x) * static_cast<std::uint32_t>(layer.size.y);
  });
}

/// Bounds of every view, from the layers as read back.
std::vector<ZLists> bounds_of(const ZListBatch& batch, const char* layers) {
  std::vector<ZLists> out(batch.layers.size());
  for (std::size_t i = 0; i < out.size(); ++i) {
    // Layers are copied out, as the buffer has no alignment of its own.
    glsl::Layer layer;
    std::memcpy(&layer, layers + i * sizeof layer, sizeof layer);
    out[i].upper = unordered(layer.upper);
    out[i].lower = unordered(layer.lower);
    out[i].num_pixels = layer.num_pixels;
    out[i].num_doubtful = layer.num_doubtful;
    out[i].handed_over = hands_over(layer);
  }
  return out;
}

}  // namespace

GlBuffer make_storage(std::size_t bytes) {
  // Immutable storage that the processor does not map may stay in graphics memory.
  GlBuffer buffer = GlBuffer::create();
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, buffer.id());
  const auto size = static_cast<GLsizeiptr>(bytes);
  if (epoxy_gl_version() >= 44)
    glBufferStorage(GL_SHADER_STORAGE_BUFFER, size, nullptr, 0);
  else
    glBufferData(GL_SHADER_STORAGE_BUFFER, size, nullptr, GL_STATIC_COPY);
  check_gl("making room for z-lists");
  return buffer;
}

ZListPasses::ZListPasses(Depths depths, std::uint32_t max_entries)
    : m_depths(depths),
      m_max_entries(max_entries),
      m_results(make_storage(num_bytes() - kLargeBytes)),
      m_large(make_storage(kLargeBytes)),
      m_instances(GlBuffer::create()),
      m_sent(GlBuffer::create()),
      m_received(GlBuffer::create()),
      m_reduction("z-list reduction", {{GL_COMPUTE_SHADER, zlist_shaders::reduction(depths)}}) {}

std::size_t ZListPasses::num_bytes() const {
  return kLargeBytes + kAlignment + aligned(kMaxLayers * sizeof(glsl::Layer)) +
         m_max_entries * sizeof(ZListEntry);
}

std::size_t ZListPasses::first_entry(const ZListBatch& batch) const {
  return kAlignment + aligned(batch.layers.size() * sizeof(glsl::Layer));
}

const GlProgram& ZListPasses::program(Motion::Kind kind, Pass pass) {
  const auto known = m_programs.find({kind, pass});
  if (known != m_programs.end()) return known->second;
  const std::string text = zlist_shaders::compute(kind, pass, m_depths);
  return m_programs
      .emplace(std::pair(kind, pass), GlProgram("z-lists", {{GL_COMPUTE_SHADER, text}}))
      .first->second;
}

void ZListPasses::start(const ZListBatch& batch) {
  // Instances and layers of the whole batch are sent once.
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, m_instances.id());
  const std::size_t instance_bytes = batch.instances.size() * sizeof(glsl::Instance);
  glBufferData(GL_SHADER_STORAGE_BUFFER, static_cast<GLsizeiptr>(instance_bytes),
               batch.instances.data(), GL_STREAM_DRAW);
  const std::size_t layer_bytes = batch.layers.size() * sizeof(glsl::Layer);
  // Counters and layers share one upload and, later, one read.
  std::vector<char> head(kAlignment + layer_bytes);
  std::memcpy(head.data(), &kNothingCounted, sizeof kNothingCounted);
  std::memcpy(head.data() + kAlignment, batch.layers.data(), layer_bytes);
  glBindBuffer(GL_COPY_READ_BUFFER, m_sent.id());
  glBufferData(GL_COPY_READ_BUFFER, static_cast<GLsizeiptr>(head.size()), head.data(),
               GL_STREAM_DRAW);
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, m_results.id());
  copy(GL_COPY_READ_BUFFER, 0, GL_SHADER_STORAGE_BUFFER, 0, head.size());
  bind_range(3, m_results, 0, sizeof(glsl::Counters));
  bind_range(4, m_results, first_entry(batch), m_max_entries * sizeof(ZListEntry));
  bind_range(5, m_large, 0, kLargeBytes);
  bind_range(6, m_instances, 0, instance_bytes);
  bind_range(7, m_results, kAlignment, layer_bytes);
  glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, m_results.id());
}

void ZListPasses::run(const ZListBatch& batch, Pass pass) {
  const GlProgram& p = program(batch.kind, pass);
  p.use();
  set_batch(p, batch, m_max_entries);
  glUniform1ui(p.uniform("max_large"), kMaxLarge);
  // Lists are made of the same bodies as depths.
  const bool moves = pass == Pass::Moving || pass == Pass::MovingLists;
  for (const ZListJob& job : moves ? batch.moving : batch.fixed) run_job(p, job);
  check_gl("drawing z-lists");
}

void ZListPasses::run_job(const GlProgram& program, const ZListJob& job) {
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, job.mesh->vertices.id());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, job.mesh->corners.id());
  // The first dispatch takes a thread per face; a face over many pixels is put aside.
  const auto num_faces = static_cast<GLuint>(job.mesh->num_faces);
  glUniform1ui(program.uniform("num_faces"), num_faces);
  glUniform1ui(program.uniform("first_instance"), job.first_instance);
  glUniform1ui(program.uniform("group_per_face"), 0);
  const GLuint num_groups = (num_faces + 63) / 64, wide = std::min(num_groups, 65535u);
  glDispatchCompute(wide, (num_groups + wide - 1) / wide, job.num_instances);
  // The number of faces put aside is read by the GPU itself: the processor does not wait.
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);
  glUniform1ui(program.uniform("group_per_face"), 1);
  glDispatchComputeIndirect(offsetof(glsl::Counters, large_groups));
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
  // The next job has no large faces yet: as at the start.
  constexpr std::size_t kFirst = offsetof(glsl::Counters, num_large);
  constexpr std::size_t kEnd = offsetof(glsl::Counters, large_groups) + sizeof(std::uint32_t);
  glBindBuffer(GL_COPY_READ_BUFFER, m_sent.id());
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, m_results.id());
  copy(GL_COPY_READ_BUFFER, kFirst, GL_SHADER_STORAGE_BUFFER, kFirst, kEnd - kFirst);
}

void ZListPasses::over_pixels(const GlProgram& program, const ZListBatch& batch) {
  program.use();
  set_batch(program, batch, m_max_entries);
  glDispatchCompute((batch.width + 7) / 8, (batch.height + 7) / 8,
                    static_cast<GLuint>(batch.layers.size()));
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

void ZListPasses::find_upper_bounds(const ZListBatch& batch) {
  // The shader is compiled when framebuffers are first used so.
  if (!m_upper_bounds)
    m_upper_bounds.emplace(
        "z-list bounds",
        std::initializer_list<GlShaderSource>{{GL_COMPUTE_SHADER, zlist_shaders::upper_bounds()}});
  over_pixels(*m_upper_bounds, batch);
}

std::vector<ZLists> ZListPasses::finish(const ZListBatch& batch, ZListOutput output) {
  over_pixels(m_reduction, batch);
  // Bounds alone, or pixels handed over, need no lists.
  if (output == ZListOutput::Lists && may_make_lists(batch)) {
    run(batch, Pass::MovingLists);
    run(batch, Pass::FixedLists);
  }
  return read_back(batch);
}

// By a small buffer of its own, so that a driver need not move the results to where it can read
// them.
void ZListPasses::read(std::size_t first, void* to, std::size_t bytes) {
  glBindBuffer(GL_COPY_READ_BUFFER, m_results.id());
  glBindBuffer(GL_COPY_WRITE_BUFFER, m_received.id());
  glBufferData(GL_COPY_WRITE_BUFFER, static_cast<GLsizeiptr>(bytes), nullptr, GL_STREAM_READ);
  copy(GL_COPY_READ_BUFFER, first, GL_COPY_WRITE_BUFFER, 0, bytes);
  glGetBufferSubData(GL_COPY_WRITE_BUFFER, 0, static_cast<GLsizeiptr>(bytes), to);
}

std::vector<ZLists> ZListPasses::read_back(const ZListBatch& batch) {
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  // The head holds counters, layers and the first entries, which are mostly all.
  const std::size_t entries_at = first_entry(batch);
  const std::uint32_t num_first = std::min(kFirstEntries, m_max_entries);
  std::vector<char> head(entries_at + num_first * sizeof(ZListEntry));
  read(0, head.data(), head.size());
  glsl::Counters counters;
  std::memcpy(&counters, head.data(), sizeof counters);
  // Entries beyond the buffer were counted and not written.
  const bool overflow = counters.num_entries > m_max_entries;
  std::vector<ZListEntry> entries(overflow ? 0 : counters.num_entries);
  const std::size_t with_head = std::min<std::size_t>(entries.size(), num_first);
  std::copy_n(head.begin() + static_cast<std::ptrdiff_t>(entries_at),
              with_head * sizeof(ZListEntry), reinterpret_cast<char*>(entries.data()));
  const std::size_t rest = (entries.size() - with_head) * sizeof(ZListEntry);
  if (rest > 0) read(head.size(), entries.data() + with_head, rest);
  check_gl("reading z-lists back");
  std::vector<ZLists> out = bounds_of(batch, head.data() + kAlignment);
  for (ZLists& lists : out) lists.overflow = overflow;
  out[0].bytes_read_back = static_cast<std::int64_t>(head.size() + rest);
  out[0].read_backs = rest > 0 ? 2 : 1;
  // Entries of all views come in any order; the pixel's number tells the view.
  for (ZListEntry e : entries) {
    ZLists& lists = out[e.pixel / batch.layer_pixels];
    if (!lists.handed_over && e.face == glsl::kNoFace) continue;  // too many to be handed over
    e.pixel %= batch.layer_pixels;
    lists.entries.push_back(e);
  }
  return out;
}

}  // namespace trivet
