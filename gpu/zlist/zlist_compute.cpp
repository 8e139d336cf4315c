// z-lists by compute shaders: one thread per face, minima and maxima by atomics on ordered floats,
// all views of a batch as layers of one image.
#include <algorithm>
#include <bit>
#include <map>

#include "gpu/egl/gl_objects.h"
#include "gpu/zlist/zlist_lists.h"
#include "gpu/zlist/zlist_shaders.h"

namespace trivet {
namespace {

using zlist_shaders::Pass;

constexpr std::size_t kMaxPixels = 1 << 20;  // of all layers
constexpr std::size_t kMaxLayers = 256;
constexpr int kMaxLarge = 1 << 15;  // faces per mesh that cover many pixels

constexpr glsl::Counters kNothingCounted = {0, 0, {0, 1, 1}};
constexpr std::uint32_t kFarRight = 0x7fffffff;  // of every pixel

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

template <class T>
void send(const GlBuffer& buffer, const std::vector<T>& data) {
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, buffer.id());
  glBufferData(GL_SHADER_STORAGE_BUFFER, static_cast<GLsizeiptr>(data.size() * sizeof(T)),
               data.data(), GL_STREAM_DRAW);
}

template <class T>
void read(const GlBuffer& buffer, std::vector<T>& data) {
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, buffer.id());
  glGetBufferSubData(GL_SHADER_STORAGE_BUFFER, 0, static_cast<GLsizeiptr>(data.size() * sizeof(T)),
                     data.data());
}

/// All instances of a mesh, contiguous in the instance buffer.
struct Job {
  const GpuMesh* mesh = nullptr;
  GLuint first_instance = 0, num_instances = 0;
};

/// Data sent for a batch: jobs of the moving and of the fixed bodies, instances, layers.
struct Batch {
  std::vector<Job> moving, fixed;
  std::vector<glsl::Instance> instances;
  std::vector<glsl::Layer> layers;
  GLuint layer_pixels = 1, width = 1, height = 1;  // of the largest
};

glsl::Instance make_instance(const ZListBody& body, std::size_t layer) {
  const std::array<float, 12>& m = body.rows;
  return {{{m[0], m[1], m[2], m[3]}, {m[4], m[5], m[6], m[7]}, {m[8], m[9], m[10], m[11]}},
          body.blur,
          body.depth_blur,
          body.first_face,
          static_cast<std::uint32_t>(layer)};
}

/// Nothing counted, no doubtful pixel.
glsl::Layer make_layer(const ZListView& v) {
  const std::uint32_t horizon = ordered(v.horizon);
  return {{v.width, v.height},
          v.first_radius,
          v.sample_error,
          v.period,
          v.first_depth,
          horizon,
          horizon,
          0,
          0,
          kFarRight,
          kFarRight,
          0,
          0};
}

std::vector<Job> add_jobs(std::span<const ZListView> views,
                          std::vector<ZListBody> ZListView::*bodies,
                          std::vector<glsl::Instance>& out) {
  std::map<const GpuMesh*, std::vector<glsl::Instance>> of_mesh;
  for (std::size_t layer = 0; layer < views.size(); ++layer)
    for (const ZListBody& b : views[layer].*bodies)
      of_mesh[b.mesh].push_back(make_instance(b, layer));
  std::vector<Job> jobs;
  for (const auto& [mesh, instances] : of_mesh) {
    jobs.push_back({mesh, static_cast<GLuint>(out.size()), static_cast<GLuint>(instances.size())});
    out.insert(out.end(), instances.begin(), instances.end());
  }
  return jobs;
}

Batch make_batch(std::span<const ZListView> views) {
  Batch out;
  out.moving = add_jobs(views, &ZListView::moving, out.instances);
  out.fixed = add_jobs(views, &ZListView::fixed, out.instances);
  for (const ZListView& v : views) {
    out.layers.push_back(make_layer(v));
    out.width = std::max(out.width, static_cast<GLuint>(v.width));
    out.height = std::max(out.height, static_cast<GLuint>(v.height));
    out.layer_pixels = std::max(out.layer_pixels, static_cast<GLuint>(v.width * v.height));
  }
  return out;
}

class ComputeRaster : public ZListRaster {
 public:
  explicit ComputeRaster(std::uint32_t max_entries)
      : m_max_entries(max_entries),
        m_image(make_storage(kImageBytes)),
        m_counters(make_storage(sizeof(glsl::Counters))),
        m_entries(make_storage(max_entries * sizeof(ZListEntry))),
        m_large(make_storage(kLargeBytes)),
        m_instances(GlBuffer::create()),
        m_layers(GlBuffer::create()),
        m_reduction("z-list reduction", {{GL_COMPUTE_SHADER, zlist_shaders::reduction()}}) {}

  const char* method() const override { return "compute shaders"; }
  std::size_t num_bytes() const override {
    return kImageBytes + kLargeBytes + m_max_entries * sizeof(ZListEntry);
  }
  bool has_room(std::size_t num_views, std::size_t num_pixels) const override {
    return num_views <= kMaxLayers && num_views * num_pixels <= kMaxPixels;
  }
  std::vector<ZLists> rasterise(std::span<const ZListView> views, bool bounds_alone) override;

 private:
  static constexpr std::size_t kImageBytes = 4 * sizeof(std::uint32_t) * kMaxPixels;
  static constexpr std::size_t kLargeBytes = 2 * sizeof(std::uint32_t) * kMaxLarge;

  const GlProgram& program(Motion::Kind kind, Pass pass);
  void start(const Batch& batch);
  void run(Motion::Kind kind, const Batch& batch, Pass pass);
  void run_job(const GlProgram& program, const Job& job);
  void reduce(const Batch& batch);
  std::vector<ZLists> read_back(const Batch& batch);

  std::uint32_t m_max_entries;
  GlBuffer m_image, m_counters, m_entries, m_large, m_instances, m_layers;
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

void set_layers(const GlProgram& program, const Batch& batch) {
  glUniform1ui(program.uniform("num_layers"), static_cast<GLuint>(batch.layers.size()));
  glUniform1ui(program.uniform("layer_pixels"), batch.layer_pixels);
}

void ComputeRaster::start(const Batch& batch) {
  send(m_instances, batch.instances);
  send(m_layers, batch.layers);
  send(m_counters, std::vector{kNothingCounted});
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, m_image.id());
  const std::size_t plane = sizeof(std::uint32_t) * batch.layers.size() * batch.layer_pixels;
  const std::uint32_t lowest = 0, highest = 0xffffffffu;
  const std::uint32_t first[4] = {lowest, highest, lowest, highest};
  for (int i = 0; i < 4; ++i)
    glClearBufferSubData(GL_SHADER_STORAGE_BUFFER, GL_R32UI, static_cast<GLintptr>(i * plane),
                         static_cast<GLsizeiptr>(plane), GL_RED_INTEGER, GL_UNSIGNED_INT,
                         &first[i]);
  const GLuint buffers[] = {m_image.id(), m_counters.id(),  m_entries.id(),
                            m_large.id(), m_instances.id(), m_layers.id()};
  for (GLuint i = 0; i < std::size(buffers); ++i)
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 2 + i, buffers[i]);
  glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, m_counters.id());
}

void ComputeRaster::run(Motion::Kind kind, const Batch& batch, Pass pass) {
  const GlProgram& p = program(kind, pass);
  p.use();
  set_layers(p, batch);
  glUniform1ui(p.uniform("max_entries"), m_max_entries);
  glUniform1ui(p.uniform("max_large"), kMaxLarge);
  const bool moves = pass == Pass::Moving || pass == Pass::MovingLists;
  for (const Job& job : moves ? batch.moving : batch.fixed) run_job(p, job);
  check_gl("drawing z-lists");
}

void ComputeRaster::run_job(const GlProgram& program, const Job& job) {
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, job.mesh->vertices.id());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, job.mesh->corners.id());
  const auto num_faces = static_cast<GLuint>(job.mesh->num_faces);
  glUniform1ui(program.uniform("num_faces"), num_faces);
  glUniform1ui(program.uniform("first_instance"), job.first_instance);
  glUniform1ui(program.uniform("group_per_face"), 0);
  const GLuint num_groups = (num_faces + 63) / 64, wide = std::min(num_groups, 65535u);
  glDispatchCompute(wide, (num_groups + wide - 1) / wide, job.num_instances);
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);
  glUniform1ui(program.uniform("group_per_face"), 1);
  glDispatchComputeIndirect(offsetof(glsl::Counters, large_groups));
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
  const std::uint32_t none = 0;
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, m_counters.id());
  glClearBufferSubData(GL_SHADER_STORAGE_BUFFER, GL_R32UI, offsetof(glsl::Counters, num_large), 8,
                       GL_RED_INTEGER, GL_UNSIGNED_INT, &none);
}

void ComputeRaster::reduce(const Batch& batch) {
  m_reduction.use();
  set_layers(m_reduction, batch);
  glDispatchCompute((batch.width + 7) / 8, (batch.height + 7) / 8,
                    static_cast<GLuint>(batch.layers.size()));
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

std::vector<ZLists> ComputeRaster::read_back(const Batch& batch) {
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  std::vector<glsl::Counters> counters(1);
  std::vector<glsl::Layer> layers(batch.layers);
  std::vector<ZListEntry> entries;
  read(m_counters, counters);
  read(m_layers, layers);
  const bool overflow = counters[0].num_entries > m_max_entries;
  if (!overflow && counters[0].num_entries > 0) {
    entries.resize(counters[0].num_entries);
    read(m_entries, entries);
  }
  check_gl("reading z-lists back");
  std::vector<ZLists> out;
  for (const glsl::Layer& b : layers) {
    ZLists lists;
    lists.overflow = overflow;
    lists.upper = unordered(b.upper);
    lists.lower = unordered(b.lower);
    lists.num_pixels = b.num_pixels;
    lists.num_doubtful = b.num_doubtful;
    lists.bytes_read_back = sizeof(glsl::Counters) + sizeof(glsl::Layer);
    out.push_back(lists);
  }
  for (const ZListEntry& e : entries) out[e.pixel / batch.layer_pixels].entries.push_back(e);
  for (ZLists& lists : out)
    lists.bytes_read_back += static_cast<std::int64_t>(lists.entries.size() * sizeof(ZListEntry));
  return out;
}

std::vector<ZLists> ComputeRaster::rasterise(std::span<const ZListView> views, bool bounds_alone) {
  const Motion::Kind kind = views.front().kind;
  const Batch batch = make_batch(views);
  start(batch);
  run(kind, batch, Pass::Moving);
  run(kind, batch, Pass::Fixed);
  reduce(batch);
  if (!bounds_alone) {
    run(kind, batch, Pass::MovingLists);
    run(kind, batch, Pass::FixedLists);
  }
  return read_back(batch);
}

}  // namespace

std::unique_ptr<ZListRaster> make_compute_raster(std::uint32_t max_entries) {
  return std::make_unique<ComputeRaster>(max_entries);
}

}  // namespace trivet
