#include "gpu/zlist/device.h"

#include <algorithm>
#include <limits>
#include <map>
#include <mutex>
#include <tuple>

#include "core/base/error.h"
#include "gpu/egl/environment_error.h"
#include "gpu/zlist/measure_lists.h"
#include "gpu/zlist/pairs.h"
#include "gpu/zlist/view.h"

namespace trivet {
namespace {

/// Least graphics memory reserved for meshes.
constexpr std::size_t kLeastMeshBytes = 8 << 10;
/// OpenGL with compute shaders.
constexpr int kComputes = 43;

EglOptions checked_options(const GpuZListOptions& options) {
  options.faults.check_present();
  return egl_options(options);
}

std::unique_ptr<ZListRaster> make_raster(const GpuZListOptions& options, int gl_version) {
  const auto max_entries = static_cast<std::uint32_t>(options.max_list_entries);
  if (options.method == GpuMethod::Framebuffer)
    return gl_version >= kComputes ? make_framebuffer_raster(max_entries)
                                   : make_feedback_raster(max_entries);
  if (gl_version >= kComputes) return make_compute_raster(max_entries);
  throw environment_error(say(
      "z-lists by compute shaders need OpenGL 4.3, here is %1.%2; accepted: the method framebuffer",
      gl_version / 10, gl_version % 10));
}

ZListAnswer answer_of(const ZListAsk& ask, const ZListView& view, ZLists& lists) {
  ZListAnswer out;
  CandidatePairs& p = out.proposal;
  if (!make_pairs(view, lists, ask.frame, p.pairs)) return {ZListTrouble::Pairs, false, {}};
  p.usable = true;
  p.work.gpu_lists = lists.num_doubtful > 0;
  return out;
}

ZListAnswer answer_in_software(const ZListAsk& ask, const ZListView& view, const ZLists& lists,
                               DoubtfulLists& software) {
  // The lists of handed over pixels are empty: their places tell software where to look.
  Doubt doubt;
  for (const ZListEntry& e : lists.entries) doubt.pixels.push_back(e.pixel);
  if (lists.upper < view.horizon) doubt.upper = lists.upper;
  ZListAnswer out{ZListTrouble::None, true, software.find_candidates(*ask.query, ask.frame, doubt)};
  out.proposal.work.software_lists = lists.num_doubtful > 0;
  return out;
}

void set_bounds(const ZListAsk& ask, const ZListView& view, const ZLists& lists,
                ZListAnswer& answer) {
  CandidatePairs& p = answer.proposal;
  // Bounds of a GPU hold for software, too, which may have found better ones.
  p.lower = std::max(p.lower, std::min(ask.frame.time_before(lists.lower), ask.horizon));
  if (!answer.in_software && lists.upper < view.horizon)
    p.upper = ask.frame.time_after(lists.upper);
}

void set_work(const ZListAsk& ask, const ZLists& lists, CandidatePairs& p) {
  p.work.body_pairs = static_cast<std::int64_t>(ask.frame.pairs.size());
  p.work.pixels = lists.num_pixels;
  p.work.doubtful_pixels = lists.num_doubtful;
  p.work.face_pairs = static_cast<std::int64_t>(p.pairs.size());
  p.work.bytes_read_back = lists.bytes_read_back;
  p.work.read_backs = lists.read_backs;
}

ZListAnswer without_lists() {
  ZListAnswer out;
  out.proposal.why = "only bounds were requested";
  return out;
}

double num_faces(const ZListView& view) {
  double out = 0;
  for (const auto* bodies : {&view.moving, &view.fixed})
    for (const ZListBody& body : *bodies) out += body.mesh->num_faces;
  return out;
}

std::size_t num_bodies(std::span<const ZListView> views) {
  std::size_t out = 0;
  for (const ZListView& v : views) out += v.moving.size() + v.fixed.size();
  return out;
}

}  // namespace

EglOptions egl_options(const GpuZListOptions& options) {
  EglOptions out{options.allow_software, options.most_gl_version};
  if (options.device != 0) out.device = options.device;
  return out;
}

const char* to_string(ZListTrouble trouble) {
  switch (trouble) {
    case ZListTrouble::Meshes:
      return "the meshes do not fit into the graphics memory";
    case ZListTrouble::Bodies:
      return "too many bodies for the textures of this OpenGL";
    case ZListTrouble::Entries:
      return "the lists of doubtful pixels do not fit into the graphics memory";
    default:
      return "too many candidate pairs of faces";
  }
}

ZListDevice::ZListDevice(const GpuZListOptions& options)
    : m_options(options), m_context(checked_options(options)) {
  // The context is current for this block, and given back to the caller's afterwards.
  const EglContext::Current current(m_context);
  m_raster = make_raster(options, gl_version());
  // Memory for results is fixed; meshes get all that is left.
  const std::size_t needed = m_raster->num_bytes() + kLeastMeshBytes;
  if (needed > options.memory_bytes) {
    m_raster.reset();
    throw environment_error(
        say("z-lists need %1 KiB of graphics memory, more than the %2 KiB allowed", needed >> 10,
            options.memory_bytes >> 10));
  }
  // A mesh has to fit into one buffer of the driver.
  GLint64 max_buffer_bytes = std::numeric_limits<GLint64>::max();
  if (gl_version() >= kComputes)
    glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &max_buffer_bytes);
  m_meshes = std::make_unique<ZListMeshCache>(options.memory_bytes - m_raster->num_bytes(),
                                              static_cast<std::size_t>(max_buffer_bytes));
}

ZListDevice::~ZListDevice() {
  try {
    // Objects of a lost context cannot be deleted, only forgotten.
    const EglContext::Current current(m_context);
    m_meshes.reset();
    m_raster.reset();
  } catch (const Error&) {  // the context is lost, with all its objects
    const EglContext::None none;
    m_meshes.reset();
    m_raster.reset();
  }
}

int ZListDevice::gl_version() const {
  return std::min(m_context.gl_version(), m_options.most_gl_version);
}

std::string ZListDevice::description() const {
  const int version = gl_version();
  return m_context.renderer() + ", " + m_raster->description() + ", OpenGL " +
         std::to_string(version / 10) + "." + std::to_string(version % 10);
}

// Measured ones of this process, by renderer, method and kind of motion.
ListCosts ZListDevice::list_costs(Motion::Kind kind) {
  if (m_options.list_costs) return *m_options.list_costs;
  if (m_context.is_software()) return list_costs_of_llvmpipe(kind);
  // A process asks the same device again and again: it is measured once.
  static std::mutex mutex;
  static std::map<std::tuple<std::string, std::string, Motion::Kind>, ListCosts> known;
  const std::lock_guard lock(mutex);
  const std::tuple key(m_context.renderer(), std::string(m_raster->description()), kind);
  const auto found = known.find(key);
  if (found != known.end()) return found->second;
  return known.emplace(key, measure_list_costs(*this, kind)).first->second;
}

std::uint32_t ZListDevice::most_handed_over(const ZListView& view, ZListWanted wanted) {
  // The number of doubtful pixels decides: few are listed by software, many on the GPU.
  if (wanted == ZListWanted::SoftwareLists) return kAllHandedOver;
  if (wanted != ZListWanted::Chosen) return 0;
  const ListCosts costs = list_costs(view.kind);
  return costs.most_in_software(num_faces(view));
}

std::vector<ZListAnswer> ZListDevice::answer(std::span<const ZListAsk> asks,
                                             std::span<const ZListView> views, ZListWanted wanted) {
  const bool bounds_alone = wanted == ZListWanted::Bounds;
  // One draw answers all; each answer is judged on its own.
  std::vector<ZLists> lists =
      m_raster->rasterise(views, bounds_alone ? ZListOutput::Bounds : ZListOutput::Lists);
  m_options.faults.check_no_reset();
  std::vector<ZListAnswer> out;
  for (std::size_t i = 0; i < asks.size(); ++i) {
    if (lists[i].overflow)
      out.push_back({ZListTrouble::Entries, false, {}});
    else if (bounds_alone)
      out.push_back(without_lists());
    else if (lists[i].handed_over)
      out.push_back(answer_in_software(asks[i], views[i], lists[i], *m_options.software_lists));
    else
      out.push_back(answer_of(asks[i], views[i], lists[i]));
    set_bounds(asks[i], views[i], lists[i], out.back());
    set_work(asks[i], lists[i], out.back().proposal);
    // The first answer stands for the draw that all share.
    out.back().proposal.work.draws = i == 0;
  }
  return out;
}

std::vector<ZListAnswer> ZListDevice::find_candidates(std::span<const ZListAsk> asks,
                                                      ZListWanted wanted) {
  const EglContext::Current current(m_context);
  // Before the meshes are named: it may send others.
  if (wanted == ZListWanted::Chosen) list_costs(asks.front().query->motion.kind);
  m_meshes->begin_query();
  // All meshes have to be in graphics memory before anything is drawn.
  std::vector<ZListView> views;
  int width = 0, height = 0;
  for (const ZListAsk& ask : asks) {
    views.push_back(make_view(*ask.query, ask.frame, *m_meshes));
    if (views.back().fixed.empty())
      return std::vector<ZListAnswer>(asks.size(), {ZListTrouble::Meshes, false, {}});
    views.back().most_handed_over = most_handed_over(views.back(), wanted);
    width = std::max(width, ask.frame.width);
    height = std::max(height, ask.frame.height);
  }
  // Limits of textures and layers depend on the driver.
  if (!m_raster->has_room(asks.size(), num_bodies(views), width, height))
    return std::vector<ZListAnswer>(asks.size(), {ZListTrouble::Bodies, false, {}});
  return answer(asks, views, wanted);
}

}  // namespace trivet
