#include "raster/zlist/software_zlists.h"

#include <algorithm>
#include <cmath>

#include "core/base/arena.h"
#include "core/base/bad_input.h"
#include "raster/zlist/search.h"

namespace trivet {
namespace {

constexpr int kLargestResolution = 4096;

SoftwareZListOptions checked(SoftwareZListOptions options) {
  require(options.resolution >= 0 && options.resolution <= kLargestResolution,
          say("resolution of z-lists is %1; accepted: 0 (automatic) to %2", options.resolution,
              kLargestResolution));
  require(
      options.num_threads >= 0,
      say("number of threads of z-lists is %1; accepted: 0 (all) or more", options.num_threads));
  require(options.zoom_levels >= 0 && options.zoom_levels <= 4,
          say("zoom levels of z-lists are %1; accepted: 0 to 4", options.zoom_levels));
  if (options.num_threads == 0) options.num_threads = num_threads_here();
  return options;
}

}  // namespace

SoftwareZLists::SoftwareZLists(const SoftwareZListOptions& options) : m_options(checked(options)) {}

CandidatePairs SoftwareZLists::find_candidates(const FirstContactQuery& query, double horizon) {
  const int resolution =
      m_options.resolution ? m_options.resolution : zlist_resolution_of_processors(query);
  const ZListFrame frame = make_zlist_frame(query, horizon, resolution);
  if (!frame.empty()) return ZListSearch(query, frame, m_options).run();
  // Bodies that never meet leave nothing to propose: the motion is free.
  CandidatePairs nothing;
  nothing.usable = true;
  nothing.lower = kInfinity;
  return nothing;
}

SoftwareDoubtfulLists::SoftwareDoubtfulLists(const SoftwareZListOptions& options)
    : m_options(checked(options)) {}

CandidatePairs SoftwareDoubtfulLists::find_candidates(const FirstContactQuery& query,
                                                      const ZListFrame& frame, const Doubt& doubt) {
  return ZListSearch(query, frame, m_options).run(doubt);
}

}  // namespace trivet
