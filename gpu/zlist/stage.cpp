#include "gpu/zlist/stage.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "core/base/error.h"
#include "gpu/zlist/device.h"
#include "gpu/zlist/methods.h"

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

using Trouble = ZListTrouble;

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

class GpuZListStage : public CandidateFinder {
 public:
  explicit GpuZListStage(const GpuZListOptions& options)
      : m_options(options),
        m_device(std::make_unique<ZListDevice>(options)),
        m_is_software(m_device->context().is_software()),
        m_prefers_large_pixels(m_device->raster().prefers_large_pixels()),
        m_notes(once_each(options.notes)),
        m_description(m_device->description()) {}

  std::string name() const override { return "gpu (" + m_description + ")"; }
  std::string device() const override { return m_description; }
  std::string method() const override {
    return m_options.method == GpuMethod::Compute ? "compute" : "framebuffer";
  }
  std::string lists() const override {
    return to_string(m_options.software_lists ? m_options.listing : GpuListing::Gpu);
  }
  CandidatePairs find_candidates(const FirstContactQuery& query, double horizon) override;
  std::vector<CandidatePairs> find_candidates_for_all(std::span<const FirstContactQuery> queries,
                                                      std::span<const double> horizons) override;

 private:
  /// Queries that are drawn together.
  struct Group {
    std::vector<ZListAsk> asks;
    std::size_t num_bodies = 0;
    int width = 0, height = 0;
  };

  int resolution_of(const FirstContactQuery& query) const;
  int other_resolution(Trouble trouble, int resolution) const;
  ZListWanted wanted() const;
  std::optional<std::vector<ZListAnswer>> try_asking(std::span<const ZListAsk> asks,
                                                     ZListWanted wanted);
  void put_aside(const CandidatePairs& unused);
  CandidatePairs with_aside(CandidatePairs proposal);
  CandidatePairs answer_of(const ZListAsk& ask, Trouble& trouble);
  bool add(ZListAsk& ask, Group& group) const;
  void ask_together(Group& group, std::span<const FirstContactQuery> queries,
                    std::vector<CandidatePairs>& out);

  GpuZListOptions m_options;
  std::unique_ptr<ZListDevice> m_device;  // null after an error
  bool m_is_software, m_prefers_large_pixels;
  int m_num_errors = 0;  // since the last success
  ZListWork m_aside;     // of draws whose answers are not used: they count with the next proposal
  GpuNotes m_notes;
  std::string m_description, m_last_error;
};

// Recreates a lost context and retries.
std::optional<std::vector<ZListAnswer>> GpuZListStage::try_asking(std::span<const ZListAsk> asks,
                                                                  ZListWanted wanted) {
  // A lost context takes all its objects with it: a new device starts from nothing.
  while (m_num_errors < (m_options.recreates_context ? kMostErrors : 1)) {
    try {
      if (!m_device) m_device = std::make_unique<ZListDevice>(m_options);
      auto out = m_device->find_candidates(asks, wanted);
      if (std::exchange(m_num_errors, 0) > 0) m_notes.tell_recovered(say(kGoesOn, m_last_error));
      return out;
    } catch (const Error& error) {
      if (m_device) ++m_aside.draws;  // which were lost
      m_device.reset();
      m_last_error = error.what();
      ++m_num_errors;
    }
  }
  if (m_options.recreates_context) m_notes.tell_lost(say(kInsteadOfGpu, m_last_error));
  return std::nullopt;
}

int GpuZListStage::resolution_of(const FirstContactQuery& query) const {
  if (m_options.resolution != 0) return m_options.resolution;
  return m_is_software ? zlist_resolution_of_processors(query) : kResolutionOfHardware;
}

// Larger pixels have fewer entries, smaller ones fewer pairs. 0: no resolution helps.
int GpuZListStage::other_resolution(Trouble trouble, int resolution) const {
  if (trouble == Trouble::Entries) return std::max(1, resolution / kOtherPixels);
  const int finer = resolution * kOtherPixels;
  const bool may_be_finer = trouble == Trouble::Pairs && finer <= kLargestResolution;
  return may_be_finer && !m_prefers_large_pixels ? finer : 0;
}

ZListWanted GpuZListStage::wanted() const {
  if (m_options.bounds_alone) return ZListWanted::Bounds;
  if (!m_options.software_lists || m_options.listing == GpuListing::Gpu)
    return ZListWanted::GpuLists;
  return m_options.listing == GpuListing::Software ? ZListWanted::SoftwareLists
                                                   : ZListWanted::Chosen;
}

void GpuZListStage::put_aside(const CandidatePairs& unused) {
  m_aside.draws += unused.work.draws;
  m_aside.read_backs += unused.work.read_backs;
  m_aside.bytes_read_back += unused.work.bytes_read_back;
}

CandidatePairs GpuZListStage::with_aside(CandidatePairs proposal) {
  const ZListWork aside = std::exchange(m_aside, {});
  proposal.work.draws += aside.draws;
  proposal.work.read_backs += aside.read_backs;
  proposal.work.bytes_read_back += aside.bytes_read_back;
  return proposal;
}

// A proposal, or trouble that another resolution may avoid.
CandidatePairs GpuZListStage::answer_of(const ZListAsk& ask, Trouble& trouble) {
  const ZListWanted first = wanted();
  // The chosen way is tried first, and the other one where its lists are too long.
  auto answers = try_asking({&ask, 1}, first);
  const bool too_long = answers && (answers->front().trouble == Trouble::Entries ||
                                    answers->front().trouble == Trouble::Pairs);
  const bool gave_up = answers && answers->front().in_software && !answers->front().proposal.usable;
  // Work of answers that are not used still counts.
  if ((too_long && first == ZListWanted::Chosen) || gave_up) {
    put_aside(answers->front().proposal);
    answers = try_asking({&ask, 1}, gave_up ? ZListWanted::GpuLists : ZListWanted::SoftwareLists);
  }
  trouble = answers ? answers->front().trouble : Trouble::None;
  return with_aside(answers ? std::move(answers->front().proposal) : gives_up(m_last_error));
}

CandidatePairs GpuZListStage::find_candidates(const FirstContactQuery& query, double horizon) {
  Trouble trouble = Trouble::None;
  // Lists that do not fit get one more try with other pixels.
  for (int resolution = resolution_of(query), tries = 0; resolution > 0 && tries < 2; ++tries) {
    const ZListAsk ask{&query, horizon, make_zlist_frame(query, horizon, resolution)};
    // Bodies that never meet need no image.
    if (ask.frame.empty()) return nothing_touches(horizon);
    CandidatePairs proposal = answer_of(ask, trouble);
    if (trouble == Trouble::None) return proposal;
    put_aside(proposal);
    resolution = other_resolution(trouble, resolution);
  }
  return with_aside(gives_up(to_string(trouble)));
}

// False if the group is full.
bool GpuZListStage::add(ZListAsk& ask, Group& group) const {
  const std::size_t num_bodies =
      group.num_bodies + ask.frame.moving.size() + ask.frame.fixed.size();
  const int width = std::max(group.width, ask.frame.width);
  const int height = std::max(group.height, ask.frame.height);
  // A query alone always fits a group; what it needs is found when it is drawn.
  if (!group.asks.empty() &&
      (!m_device || !m_device->raster().has_room(group.asks.size() + 1, num_bodies, width, height)))
    return false;
  group.num_bodies = num_bodies;
  group.width = width;
  group.height = height;
  group.asks.push_back(std::move(ask));
  return true;
}

// Empties the group. Queries in trouble, perhaps because of another one, are retried alone, as are
// those that software gives up.
void GpuZListStage::ask_together(Group& group, std::span<const FirstContactQuery> queries,
                                 std::vector<CandidatePairs>& out) {
  if (group.asks.empty()) return;
  // The group shares a draw and a read.
  auto answers = try_asking(group.asks, wanted());
  for (std::size_t i = 0; i < group.asks.size(); ++i) {
    const ZListAsk& ask = group.asks[i];
    CandidatePairs& proposal = out[static_cast<std::size_t>(ask.query - queries.data())];
    if (!answers) {
      proposal = with_aside(gives_up(m_last_error));
      continue;
    }
    ZListAnswer& answer = (*answers)[i];
    // An answer counts unless it is in trouble, or software gave it up.
    if (answer.trouble == Trouble::None && (answer.proposal.usable || !answer.in_software)) {
      proposal = with_aside(std::move(answer.proposal));
    } else {
      put_aside(answer.proposal);
      proposal = find_candidates(*ask.query, ask.horizon);
    }
  }
  group = {};
}

std::vector<CandidatePairs> GpuZListStage::find_candidates_for_all(
    std::span<const FirstContactQuery> queries, std::span<const double> horizons) {
  std::vector<CandidatePairs> out(queries.size());
  // A batch has one kind of motion, as shaders differ.
  for (const auto kind : {Motion::Kind::Translation, Motion::Kind::Rotation}) {
    Group group;
    for (std::size_t i = 0; i < queries.size(); ++i) {
      if (queries[i].motion.kind != kind) continue;
      ZListAsk ask{&queries[i], horizons[i],
                   make_zlist_frame(queries[i], horizons[i], resolution_of(queries[i]))};
      if (ask.frame.empty()) {
        out[i] = nothing_touches(horizons[i]);
        continue;
      }
      if (add(ask, group)) continue;
      ask_together(group, queries, out);
      add(ask, group);
    }
    ask_together(group, queries, out);
  }
  return out;
}

void check_range(const Sentence& what, int value, int least, int largest) {
  if (value < least || value > largest)
    throw Error(Error::Kind::BadInput, "the %1 of z-lists is %2; accepted: %3 to %4", what, value,
                least, largest);
}

}  // namespace

GpuListing gpu_listing_from_name(const std::string& name) {
  if (name == "auto") return GpuListing::Auto;
  if (name == "gpu") return GpuListing::Gpu;
  if (name == "software") return GpuListing::Software;
  throw Error(Error::Kind::BadInput,
              "lists by \"%1\" are not accepted; accepted: auto, gpu, software", name);
}

std::string to_string(GpuListing listing) {
  if (listing == GpuListing::Auto) return "auto";
  return listing == GpuListing::Gpu ? "gpu" : "software";
}

std::unique_ptr<CandidateFinder> make_gpu_candidate_finder(const GpuZListOptions& options) {
  if (options.resolution != 0)
    check_range("resolution", options.resolution, kLeastResolution, kLargestResolution);
  check_range("largest number of entries", options.max_list_entries, kLeastEntries, kMostEntries);
  check_range("latest OpenGL version", options.most_gl_version, 33, 46);
  if (options.listing == GpuListing::Software && !options.software_lists)
    throw Error(Error::Kind::BadInput,
                "z-lists are to be made in software, but by nobody; accepted: software_lists");
  if (options.method == GpuMethod::Auto) return make_faster_candidate_finder(options);
  return std::make_unique<GpuZListStage>(options);
}

}  // namespace trivet
