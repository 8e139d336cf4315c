#include "gpu/zlist/zlist_gpu.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "core/base/error.h"
#include "gpu/egl/egl_context.h"
#include "gpu/zlist/zlist_pairs.h"
#include "gpu/zlist/zlist_view.h"

namespace trivet {
namespace {

/// Factor by which pixels are enlarged or shrunk for a retry when the lists do not fit.
constexpr int kOtherPixels = 4;
constexpr int kLeastResolution = 16, kLargestResolution = 1024;
constexpr int kResolutionOfHardware = 128;
constexpr int kLeastEntries = 1 << 14;
constexpr int kMostEntries = 1 << 20;  // 16 MiB: supported by all drivers for storage buffers
/// Consecutive OpenGL errors after which the GPU is no longer used.
constexpr int kMostErrors = 3;

/// Least graphics memory reserved for meshes.
constexpr std::size_t kLeastMeshBytes = 8 << 10;

/// A query, and the view for its lists.
struct Ask {
  const FirstContactQuery* query;
  double horizon;
  ZListFrame frame;
};

std::size_t num_pixels(const ZListFrame& frame) {
  return static_cast<std::size_t>(frame.width) * frame.height;
}

enum class Trouble { None, Meshes, Entries, Pairs };

struct Answer {
  Trouble trouble = Trouble::None;
  CandidatePairs proposal;  // valid if there is no trouble
};

const char* to_string(Trouble trouble) {
  switch (trouble) {
    case Trouble::Meshes:
      return "the meshes do not fit into the graphics memory";
    case Trouble::Entries:
      return "the lists of doubtful pixels do not fit into the graphics memory";
    default:
      return "too many candidate pairs of faces";
  }
}

int largest_resolution(const GpuZListOptions& options) {
  return options.resolution ? options.resolution : kResolutionOfHardware;
}

/// All objects that live in one context.
class GpuLists {
 public:
  explicit GpuLists(const GpuZListOptions& options);
  ~GpuLists();
  GpuLists(const GpuLists&) = delete;
  GpuLists& operator=(const GpuLists&) = delete;

  /// Answers queries with one kind of motion, within the available memory.
  std::vector<Answer> find_candidates(std::span<const Ask> asks);
  bool has_room(std::size_t num_asks, std::size_t largest) const {
    return m_raster->has_room(num_asks, largest);
  }
  std::string device() const { return m_context.renderer() + ", " + m_raster->method(); }
  bool is_software() const { return m_context.is_software(); }

 private:
  EglContext m_context;
  bool m_bounds_alone;
  std::unique_ptr<ZListRaster> m_raster;
  std::unique_ptr<ZListMeshCache> m_meshes;
};

GpuLists::GpuLists(const GpuZListOptions& options)
    : m_context(EglOptions{options.allow_software}), m_bounds_alone(options.bounds_alone) {
  const EglContext::Current current(m_context);
  const auto max_entries = static_cast<std::uint32_t>(options.max_list_entries);
  const bool computes = m_context.gl_version() >= 43 && !options.force_fallback;
  m_raster = computes ? make_compute_raster(max_entries)
                      : make_blend_raster(largest_resolution(options), max_entries);
  const std::size_t needed = m_raster->num_bytes() + kLeastMeshBytes;
  if (needed > options.memory_bytes) {
    m_raster.reset();
    throw Error(Error::Kind::Environment,
                "z-lists of " + std::to_string(largest_resolution(options)) + " pixels need " +
                    std::to_string(needed >> 10) + " KiB of graphics memory, more than the " +
                    std::to_string(options.memory_bytes >> 10) + " KiB allowed");
  }
  GLint64 max_buffer_bytes = std::numeric_limits<GLint64>::max();
  if (computes) glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &max_buffer_bytes);
  m_meshes = std::make_unique<ZListMeshCache>(options.memory_bytes - m_raster->num_bytes(),
                                              static_cast<std::size_t>(max_buffer_bytes));
}

GpuLists::~GpuLists() {
  try {
    const EglContext::Current current(m_context);
    m_meshes.reset();
    m_raster.reset();
  } catch (const Error&) {  // the context is lost, with all its objects
    const EglContext::None none;
    m_meshes.reset();
    m_raster.reset();
  }
}

CandidatePairs gives_up(const std::string& why) {
  CandidatePairs out;
  out.why = why;
  return out;
}

CandidatePairs nothing_touches(double horizon) {
  CandidatePairs out;
  out.usable = true;
  out.lower = horizon;
  return out;
}

Answer answer_of(const Ask& ask, const ZListView& view, bool bounds_alone, ZLists& lists) {
  if (lists.overflow) return {Trouble::Entries, {}};
  Answer out;
  CandidatePairs& p = out.proposal;
  if (bounds_alone)
    p.why = "only bounds were requested";
  else if (!make_pairs(view, lists, ask.frame, p.pairs))
    return {Trouble::Pairs, {}};
  p.usable = !bounds_alone;
  p.lower = std::min(ask.frame.time_before(lists.lower), ask.horizon);
  if (lists.upper < view.horizon) p.upper = ask.frame.time_after(lists.upper);
  p.work.body_pairs = static_cast<std::int64_t>(ask.frame.pairs.size());
  p.work.pixels = lists.num_pixels;
  p.work.doubtful_pixels = lists.num_doubtful;
  p.work.face_pairs = static_cast<std::int64_t>(p.pairs.size());
  p.work.bytes_read_back = lists.bytes_read_back;
  return out;
}

std::vector<Answer> GpuLists::find_candidates(std::span<const Ask> asks) {
  const EglContext::Current current(m_context);
  m_meshes->begin_query();
  std::vector<ZListView> views;
  for (const Ask& ask : asks) {
    views.push_back(make_view(*ask.query, ask.frame, *m_meshes));
    if (views.back().fixed.empty()) return std::vector<Answer>(asks.size(), {Trouble::Meshes, {}});
  }
  std::vector<ZLists> lists = m_raster->rasterise(views, m_bounds_alone);
  std::vector<Answer> out;
  for (std::size_t i = 0; i < asks.size(); ++i)
    out.push_back(answer_of(asks[i], views[i], m_bounds_alone, lists[i]));
  return out;
}

class GpuZListStage : public CandidateFinder {
 public:
  explicit GpuZListStage(const GpuZListOptions& options)
      : m_options(options),
        m_lists(std::make_unique<GpuLists>(options)),
        m_is_software(m_lists->is_software()),
        m_device(m_lists->device()) {}

  std::string name() const override { return "gpu (" + m_device + ")"; }
  std::string device() const override { return m_device; }
  CandidatePairs find_candidates(const FirstContactQuery& query, double horizon) override;
  std::vector<CandidatePairs> find_candidates_for_all(std::span<const FirstContactQuery> queries,
                                                      std::span<const double> horizons) override;

 private:
  int resolution_of(const FirstContactQuery& query) const;
  int other_resolution(Trouble trouble, int resolution) const;
  std::optional<std::vector<Answer>> try_asking(std::span<const Ask> asks);
  void ask_together(std::vector<Ask>& asks, std::span<const FirstContactQuery> queries,
                    std::vector<CandidatePairs>& out);

  GpuZListOptions m_options;
  std::unique_ptr<GpuLists> m_lists;  // null after an error
  bool m_is_software;
  int m_num_errors = 0;  // since the last success
  std::string m_device, m_last_error;
};

// Recreates a lost context and retries.
std::optional<std::vector<Answer>> GpuZListStage::try_asking(std::span<const Ask> asks) {
  while (m_num_errors < kMostErrors) {
    try {
      if (!m_lists) m_lists = std::make_unique<GpuLists>(m_options);
      auto out = m_lists->find_candidates(asks);
      m_num_errors = 0;
      return out;
    } catch (const Error& error) {
      m_lists.reset();
      m_last_error = error.what();
      ++m_num_errors;
    }
  }
  return std::nullopt;
}

int GpuZListStage::resolution_of(const FirstContactQuery& query) const {
  if (m_options.resolution == 0 && m_is_software) return zlist_resolution_of_processors(query);
  return largest_resolution(m_options);
}

// Larger pixels have fewer entries, smaller ones fewer pairs. 0: no resolution helps.
int GpuZListStage::other_resolution(Trouble trouble, int resolution) const {
  if (trouble == Trouble::Entries) return std::max(1, resolution / kOtherPixels);
  const int finer = resolution * kOtherPixels;
  const bool may_be_finer = trouble == Trouble::Pairs && finer <= kLargestResolution;
  return may_be_finer && !m_options.force_fallback ? finer : 0;
}

CandidatePairs GpuZListStage::find_candidates(const FirstContactQuery& query, double horizon) {
  Trouble trouble = Trouble::None;
  for (int resolution = resolution_of(query), tries = 0; resolution > 0 && tries < 2; ++tries) {
    const Ask ask{&query, horizon, make_zlist_frame(query, horizon, resolution)};
    if (ask.frame.empty()) return nothing_touches(horizon);
    auto answers = try_asking({&ask, 1});
    if (!answers) return gives_up(m_last_error);
    trouble = answers->front().trouble;
    if (trouble == Trouble::None) return std::move(answers->front().proposal);
    resolution = other_resolution(trouble, resolution);
  }
  return gives_up(to_string(trouble));
}

// Empties `asks`. Queries in trouble, perhaps because of another one, are retried alone.
void GpuZListStage::ask_together(std::vector<Ask>& asks, std::span<const FirstContactQuery> queries,
                                 std::vector<CandidatePairs>& out) {
  if (asks.empty()) return;
  auto answers = try_asking(asks);
  for (std::size_t i = 0; i < asks.size(); ++i) {
    CandidatePairs& proposal = out[static_cast<std::size_t>(asks[i].query - queries.data())];
    if (!answers)
      proposal = gives_up(m_last_error);
    else if ((*answers)[i].trouble == Trouble::None)
      proposal = std::move((*answers)[i].proposal);
    else
      proposal = find_candidates(*asks[i].query, asks[i].horizon);
  }
  asks.clear();
}

std::vector<CandidatePairs> GpuZListStage::find_candidates_for_all(
    std::span<const FirstContactQuery> queries, std::span<const double> horizons) {
  std::vector<CandidatePairs> out(queries.size());
  for (const auto kind : {Motion::Kind::Translation, Motion::Kind::Rotation}) {
    std::vector<Ask> asks;
    std::size_t largest = 0;
    for (std::size_t i = 0; i < queries.size(); ++i) {
      if (queries[i].motion.kind != kind) continue;
      Ask ask{&queries[i], horizons[i],
              make_zlist_frame(queries[i], horizons[i], resolution_of(queries[i]))};
      if (ask.frame.empty()) {
        out[i] = nothing_touches(horizons[i]);
        continue;
      }
      largest = std::max(largest, num_pixels(ask.frame));
      if (!m_lists || !m_lists->has_room(asks.size() + 1, largest)) {
        ask_together(asks, queries, out);
        largest = num_pixels(ask.frame);
      }
      asks.push_back(std::move(ask));
    }
    ask_together(asks, queries, out);
  }
  return out;
}

void check_range(const char* what, int value, int least, int largest) {
  if (value < least || value > largest)
    throw Error(Error::Kind::BadInput,
                std::string("the ") + what + " of z-lists is " + std::to_string(value) +
                    "; accepted: " + std::to_string(least) + " to " + std::to_string(largest));
}

}  // namespace

std::unique_ptr<CandidateFinder> make_gpu_candidate_finder(const GpuZListOptions& options) {
  if (options.resolution != 0)
    check_range("resolution", options.resolution, kLeastResolution, kLargestResolution);
  check_range("largest number of entries", options.max_list_entries, kLeastEntries, kMostEntries);
  return std::make_unique<GpuZListStage>(options);
}

}  // namespace trivet
