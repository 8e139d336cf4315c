#include "raster/software_zlists.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "raster/zlist_search.h"

namespace trivet {
namespace {

constexpr int kLargestResolution = 4096;

// A pixel of one to three edges of the faces is best, by the measurements of a prototype; the zoom
// does the rest.
int resolution_for(const FirstContactQuery& query) {
  size_t num_faces = 0;
  for (const Body& body : query.moving) num_faces += body.shape->mesh.triangles.size();
  for (const Body& body : query.fixed) num_faces += body.shape->mesh.triangles.size();
  return num_faces < 200000 ? 32 : 64;
}

}  // namespace

SoftwareZLists::SoftwareZLists(const SoftwareZListOptions& options) : m_options(options) {
  const auto require = [](bool holds, const std::string& text) {
    if (!holds) throw Error(Error::Kind::BadInput, text);
  };
  require(options.resolution >= 0 && options.resolution <= kLargestResolution,
          "resolution of z-lists is " + std::to_string(options.resolution) +
              "; it can be 0 (chosen) to " + std::to_string(kLargestResolution));
  require(options.num_threads >= 0, "number of threads of z-lists is " +
                                        std::to_string(options.num_threads) +
                                        "; it can be 0 (all) or more");
  require(
      options.zoom_levels >= 0 && options.zoom_levels <= 4,
      "zoom levels of z-lists are " + std::to_string(options.zoom_levels) + "; they can be 0 to 4");
  if (m_options.num_threads == 0)
    m_options.num_threads = std::max(1, tbb::this_task_arena::max_concurrency());
}

Proposal SoftwareZLists::propose(const FirstContactQuery& query, double horizon) {
  const int resolution = m_options.resolution ? m_options.resolution : resolution_for(query);
  const ZListFrame frame = make_zlist_frame(query, horizon, resolution);
  if (!frame.empty()) return ZListSearch(query, frame, m_options).run();
  Proposal nothing;
  nothing.usable = true;
  nothing.lower = kInfinity;
  return nothing;
}

}  // namespace trivet
