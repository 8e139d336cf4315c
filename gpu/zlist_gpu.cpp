#include "gpu/zlist_gpu.h"

#include <algorithm>

#include "core/base/error.h"
#include "gpu/egl_context.h"
#include "gpu/zlist_pairs.h"
#include "gpu/zlist_view.h"

namespace trivet {
namespace {

/// What is tried when the lists do not fit: pixels that are this many times larger.
constexpr int kCoarser = 4;

/// All that lives in one context.
class GpuLists {
 public:
  explicit GpuLists(const GpuZListOptions& options)
      : m_context(EglOptions{options.allow_software}) {
    const EglContext::Current current(m_context);
    m_raster = m_context.gl_version() >= 43 && !options.force_fallback
                   ? make_compute_raster(options.resolution)
                   : make_blend_raster(options.resolution);
    const std::size_t needed = m_raster->num_bytes();
    if (needed > options.memory_bytes) {
      m_raster.reset();
      throw Error(Error::Kind::Environment,
                  "z-lists of " + std::to_string(options.resolution) + " pixels need " +
                      std::to_string(needed >> 10) + " KiB of graphics memory, more than the " +
                      std::to_string(options.memory_bytes >> 10) + " KiB that are allowed");
    }
    m_meshes = std::make_unique<ZListMeshCache>(options.memory_bytes - needed);
  }
  ~GpuLists() {
    try {
      const EglContext::Current current(m_context);
      m_meshes.reset();
      m_raster.reset();
    } catch (const Error&) {
      // Another thread holds the context; all of it goes with the context.
    }
  }
  GpuLists(const GpuLists&) = delete;
  GpuLists& operator=(const GpuLists&) = delete;

  Proposal propose(const FirstContactQuery& query, const ZListFrame& frame);
  std::string name() const {
    return "gpu (" + m_context.renderer() + ", " + m_raster->method() + ")";
  }

 private:
  EglContext m_context;
  std::unique_ptr<ZListRaster> m_raster;
  std::unique_ptr<ZListMeshCache> m_meshes;
};

Proposal gives_up(const std::string& why) {
  Proposal out;
  out.why = why;
  return out;
}

Proposal GpuLists::propose(const FirstContactQuery& query, const ZListFrame& frame) {
  const EglContext::Current current(m_context);
  m_meshes->begin_query();
  const ZListView view = make_view(query, frame, *m_meshes);
  if (view.fixed.empty()) return gives_up("the meshes do not fit into the graphics memory");
  ZLists lists = m_raster->rasterise(view);
  if (lists.overflow) return gives_up("the lists do not fit into the graphics memory");
  Proposal out;
  if (!make_pairs(view, lists, frame, out.pairs)) return gives_up("too many pairs of faces");
  out.usable = true;
  out.lower = frame.time_before(lists.lower);
  if (lists.upper < view.horizon) out.upper = frame.time_after(lists.upper);
  out.work.pixels = lists.num_pixels;
  out.work.doubtful_pixels = lists.num_doubtful;
  out.work.face_pairs = static_cast<std::int64_t>(out.pairs.size());
  out.work.bytes_read_back = lists.bytes_read_back;
  return out;
}

class GpuZListStage : public ZListStage {
 public:
  explicit GpuZListStage(const GpuZListOptions& options)
      : m_options(options), m_lists(std::make_unique<GpuLists>(options)), m_name(m_lists->name()) {}

  std::string name() const override { return m_name; }

  Proposal propose(const FirstContactQuery& query, double horizon) override {
    Proposal out;
    for (const int resolution : {m_options.resolution, m_options.resolution / kCoarser}) {
      const ZListFrame frame = make_zlist_frame(query, horizon, resolution);
      if (frame.empty()) return nothing_touches(horizon);
      out = try_propose(query, frame);
      out.work.body_pairs = static_cast<std::int64_t>(frame.pairs.size());
      if (out.usable) break;
    }
    return out;
  }

 private:
  static Proposal nothing_touches(double horizon) {
    Proposal out;
    out.usable = true;
    out.lower = horizon;
    return out;
  }

  Proposal try_propose(const FirstContactQuery& query, const ZListFrame& frame) {
    try {
      if (!m_lists) m_lists = std::make_unique<GpuLists>(m_options);
      return m_lists->propose(query, frame);
    } catch (const Error& error) {
      m_lists.reset();
      return gives_up(error.what());
    }
  }

  GpuZListOptions m_options;
  std::unique_ptr<GpuLists> m_lists;  // null after an error, until the next query
  std::string m_name;
};

}  // namespace

std::unique_ptr<ZListStage> make_gpu_zlist_stage(const GpuZListOptions& options) {
  if (options.resolution < 16 || options.resolution > 1024)
    throw Error(Error::Kind::BadInput, "the resolution of z-lists is " +
                                           std::to_string(options.resolution) +
                                           "; it can be 16 to 1024 pixels");
  return std::make_unique<GpuZListStage>(options);
}

}  // namespace trivet
