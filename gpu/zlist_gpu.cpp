#include "gpu/zlist_gpu.h"

#include <algorithm>
#include <optional>

#include "core/base/error.h"
#include "gpu/egl_context.h"
#include "gpu/zlist_pairs.h"
#include "gpu/zlist_view.h"

namespace trivet {
namespace {

/// What is tried when the lists do not fit: pixels that are this many times larger.
constexpr int kCoarser = 4;
/// Errors of OpenGL in a row after which it is left alone.
constexpr int kMostErrors = 3;

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
  ~GpuLists();
  GpuLists(const GpuLists&) = delete;
  GpuLists& operator=(const GpuLists&) = delete;

  /// @return nothing when the lists are too long.
  std::optional<Proposal> propose(const FirstContactQuery& query, const ZListFrame& frame,
                                  double horizon);
  std::string name() const {
    return "gpu (" + m_context.renderer() + ", " + m_raster->method() + ")";
  }

 private:
  EglContext m_context;
  std::unique_ptr<ZListRaster> m_raster;
  std::unique_ptr<ZListMeshCache> m_meshes;
};

GpuLists::~GpuLists() {
  try {
    const EglContext::Current current(m_context);
    m_meshes.reset();
    m_raster.reset();
  } catch (const Error&) {  // the context is lost, and all objects with it
    const EglContext::None none;
    m_meshes.reset();
    m_raster.reset();
  }
}

Proposal gives_up(const std::string& why) {
  Proposal out;
  out.why = why;
  return out;
}

std::optional<Proposal> GpuLists::propose(const FirstContactQuery& query, const ZListFrame& frame,
                                          double horizon) {
  const EglContext::Current current(m_context);
  m_meshes->begin_query();
  const ZListView view = make_view(query, frame, *m_meshes);
  if (view.fixed.empty()) return gives_up("the meshes do not fit into the graphics memory");
  ZLists lists = m_raster->rasterise(view);
  Proposal out;
  if (lists.overflow || !make_pairs(view, lists, frame, out.pairs)) return std::nullopt;
  out.usable = true;
  out.lower = std::min(frame.time_before(lists.lower), horizon);
  if (lists.upper < view.horizon) out.upper = frame.time_after(lists.upper);
  out.work.body_pairs = static_cast<std::int64_t>(frame.pairs.size());
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
  Proposal propose(const FirstContactQuery& query, double horizon) override;

 private:
  std::optional<Proposal> try_propose(const FirstContactQuery& query, const ZListFrame& frame,
                                      double horizon);

  GpuZListOptions m_options;
  std::unique_ptr<GpuLists> m_lists;  // null after an error
  int m_num_errors = 0;               // since something last worked
  std::string m_name, m_last_error;
};

Proposal GpuZListStage::propose(const FirstContactQuery& query, double horizon) {
  for (const int resolution : {m_options.resolution, m_options.resolution / kCoarser}) {
    const ZListFrame frame = make_zlist_frame(query, horizon, resolution);
    if (frame.empty()) {
      Proposal nothing_touches;
      nothing_touches.usable = true;
      nothing_touches.lower = horizon;
      return nothing_touches;
    }
    if (std::optional<Proposal> out = try_propose(query, frame, horizon)) return *std::move(out);
  }
  return gives_up("too many faces are in doubtful pixels");
}

// A lost context is made again, and the query asked again.
std::optional<Proposal> GpuZListStage::try_propose(const FirstContactQuery& query,
                                                   const ZListFrame& frame, double horizon) {
  while (m_num_errors < kMostErrors) try {
      if (!m_lists) m_lists = std::make_unique<GpuLists>(m_options);
      const auto out = m_lists->propose(query, frame, horizon);
      m_num_errors = 0;
      return out;
    } catch (const Error& error) {
      m_lists.reset();
      m_last_error = error.what();
      ++m_num_errors;
    }
  return gives_up(m_last_error);
}

}  // namespace

std::unique_ptr<ZListStage> make_gpu_zlist_stage(const GpuZListOptions& options) {
  if (options.resolution < 16 || options.resolution > 1024)
    throw Error(Error::Kind::BadInput, "the resolution of z-lists is " +
                                           std::to_string(options.resolution) +
                                           "; it can be 16 to 1024 pixels");
  return std::make_unique<GpuZListStage>(options);
}

}  // namespace trivet
