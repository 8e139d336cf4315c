// A search that begins in the doubtful pixels of another stage.
#include <algorithm>
#include <limits>

#include "raster/zlist/draw_parts.h"

namespace trivet {
namespace {

/// The region of a mask, at all depths.
Wanted region_of(const std::vector<std::uint32_t>& pixels, int width) {
  Wanted out{-kFloatInfinity, kFloatInfinity, width, std::numeric_limits<int>::max(), -1, -1};
  for (const std::uint32_t pixel : pixels) {
    const int x = static_cast<int>(pixel) % width, y = static_cast<int>(pixel) / width;
    out.x0 = std::min(out.x0, x);
    out.x1 = std::max(out.x1, x);
    out.y0 = std::min(out.y0, y);
    out.y1 = std::max(out.y1, y);
  }
  return out;
}

/// Empties the map outside the mask, so that no fixed face is kept there.
void cut(DepthMap& map, const std::vector<char>& mask) {
  for (std::size_t i = 0; i < mask.size(); ++i) {
    if (mask[i]) continue;
    map.lower[i] = map.lowest_centre[i] = kFloatInfinity;
    map.upper[i] = map.highest_centre[i] = -kFloatInfinity;
  }
}

}  // namespace

CandidatePairs ZListSearch::run(const Doubt& doubt) {
  // The other stage has found an upper bound; a float32 above it is still one.
  m_upper.lower_to(static_cast<float>(std::min(doubt.upper, 1e30)) * 1.000001F);
  Lists lists;
  const bool drawn = doubt.pixels.empty() || draw_doubtful(doubt.pixels, lists);
  return finish(drawn, lists);
}

bool ZListSearch::draw_doubtful(const std::vector<std::uint32_t>& pixels, Lists& lists) {
  m_moving.project(m_options.num_threads);
  m_fixed.project(m_options.num_threads);
  const View moving = View::whole(m_frame, true), fixed = View::whole(m_frame, false);
  // Only pixels in doubt are drawn, in both images.
  std::vector<char> mask(static_cast<std::size_t>(moving.width) * moving.height);
  for (const std::uint32_t pixel : pixels) mask[pixel] = 1;
  DepthMap map(moving.width, moving.height);
  return collect_moving_in(mask, region_of(pixels, moving.width), moving, map, lists.moving) &&
         collect_fixed(fixed, map, lists.fixed);
}

// All of them, also those that reach no fixed face: that is not known before the fixed are drawn.
bool ZListSearch::collect_moving_in(const std::vector<char>& mask, const Wanted& wanted,
                                    const View& view, DepthMap& map, std::vector<Fragment>& out) {
  bool overflow = false;
  // Threads share the limit of fragments.
  const auto make = [&] {
    MaskedSink sink(mask, view);
    sink.most = m_options.most_fragments / static_cast<std::size_t>(m_options.num_threads);
    return sink;
  };
  const auto done = [&](MaskedSink& sink) {
    overflow |= sink.overflow;
    map.add(sink.map);
    out.insert(out.end(), sink.found.begin(), sink.found.end());
  };
  const bool complete =
      draw_parts<MaskedSink>(m_moving, view, wanted, 1, m_options.num_threads, make, done);
  cut(map, mask);
  if (!complete) return give_up("a moving face has too many pieces near the axis");
  return overflow ? give_up("too many doubtful moving faces") : true;
}

}  // namespace trivet
