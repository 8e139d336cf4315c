#include "raster/zlist/search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "raster/zlist/draw_parts.h"

namespace trivet {
namespace {

constexpr int kZoom = 8;
// Pairs in a pixel from which zooming pays; with tied depths, zooming only multiplies them.
constexpr size_t kZoomPairs = 64, kZoomTiedPairs = 4096;
// Further zooming must shorten the lists of a pixel by this factor, on average.
constexpr size_t kZoomGain = 4;
constexpr size_t kAnyPairs = std::numeric_limits<std::uint32_t>::max();
constexpr int kMostZooms = 1 << 14;
// Angles of one face in one pixel closer than this are merged into one fragment.
constexpr float kOneFragment = 0.5F;
// Number of faces from which a first bound by every kStride-th one pays.
constexpr size_t kManyFaces = 4096, kStride = 16;

// Sorts by pixel and face; pieces of one face of a rotation are merged into one fragment.
void sort_fragments(std::vector<Fragment>& list) {
  // Fragments of one face are brought together, and in order of depth.
  std::sort(list.begin(), list.end(), [](const Fragment& a, const Fragment& b) {
    return std::tie(a.pixel, a.face, a.lower) < std::tie(b.pixel, b.face, b.lower);
  });
  size_t num = 0;
  for (const Fragment& f : list) {
    Fragment* last = num ? &list[num - 1] : nullptr;
    if (last && last->pixel == f.pixel && last->face == f.face &&
        f.lower <= last->upper + kOneFragment)
      last->upper = std::max(last->upper, f.upper);
    else
      list[num++] = f;
  }
  list.resize(num);
}

// Starting at `at`, the fragments of its pixel.
std::span<Fragment> same_pixel(std::vector<Fragment>& list, size_t at) {
  size_t end = at;
  while (end < list.size() && list[end].pixel == list[at].pixel) ++end;
  return {&list[at], end - at};
}

}  // namespace

ZListSearch::ZListSearch(const FirstContactQuery& query, const ZListFrame& frame,
                         const SoftwareZListOptions& options)
    : m_query(query),
      m_frame(frame),
      m_options(options),
      m_moving(frame, query.moving, frame.moving),
      m_fixed(frame, query.fixed, frame.fixed),
      m_moving_boxes(m_moving.num_faces()),
      m_reach(rounded_up(std::min(frame.reach, 1e30))),
      m_tie(frame.kind == Motion::Kind::Rotation
                ? 1e-5F
                : 4e-6F * static_cast<float>(frame.moving_depth + frame.width + frame.height)) {
  m_upper.reset(m_reach);
}

bool ZListSearch::give_up(const char* why) {
  m_why = why;
  return false;
}

CandidatePairs ZListSearch::run() {
  Lists lists;
  const bool drawn = draw_base(lists);
  return finish(drawn, lists);
}

CandidatePairs ZListSearch::finish(bool drawn, Lists& lists) {
  if (drawn && resolve(View::whole(m_frame, true), 0, kAnyPairs, lists)) return proposal();
  CandidatePairs out;
  out.why = m_why;
  out.work = m_work;
  return out;
}

bool ZListSearch::draw_base(Lists& lists) {
  m_moving.project(m_options.num_threads);
  m_fixed.project(m_options.num_threads);
  const View moving = View::whole(m_frame, true), fixed = View::whole(m_frame, false);
  DepthMap map;
  // The moving side is drawn as a depth map, so that fixed faces out of its reach are never kept.
  if (!draw_depth_map(m_moving, moving, m_options.num_threads, map, &m_moving_boxes))
    return give_up("a moving face has too many pieces near the axis");
  // Every kStride-th face of a large mesh gives a first bound.
  if (m_fixed.num_faces() >= kManyFaces) sample_upper_bound(fixed, map);
  return collect_fixed(fixed, map, lists.fixed) &&
         collect_moving(moving, lists.fixed, lists.moving);
}

void ZListSearch::sample_upper_bound(const View& view, const DepthMap& map) {
  // The sample lowers the bound alone, and keeps no fragments.
  const auto make = [&] {
    FixedSink sink(map, m_upper);
    sink.keep = false;
    return sink;
  };
  draw_parts<FixedSink>(m_fixed, view, wanted_of(map.lower, map.upper, map.width, m_upper.get()),
                        kStride, m_options.num_threads, make, [](FixedSink&) {});
}

bool ZListSearch::collect_fixed(const View& view, const DepthMap& map, std::vector<Fragment>& out) {
  bool overflow = false;
  std::vector<char> covered(map.lower.size());
  const auto make = [&] {
    FixedSink sink(map, m_upper);
    sink.covered.resize(map.lower.size());
    sink.most = m_options.most_fragments / static_cast<size_t>(m_options.num_threads);
    return sink;
  };
  // Fixed faces wholly outside of the moving depths and the bound are skipped unseen.
  const Wanted wanted = wanted_of(map.lower, map.upper, map.width, m_upper.get());
  const auto done = [&](FixedSink& sink) {
    sink.compact();
    overflow |= sink.overflow;
    out.insert(out.end(), sink.found.begin(), sink.found.end());
    for (size_t i = 0; i < covered.size(); ++i) covered[i] |= sink.covered[i];
  };
  const bool complete =
      draw_parts<FixedSink>(m_fixed, view, wanted, 1, m_options.num_threads, make, done);
  m_work.pixels = std::count(covered.begin(), covered.end(), 1);
  if (!complete) return give_up("a fixed face has too many pieces near the axis");
  return overflow ? give_up("too many doubtful fixed faces") : true;
}

bool ZListSearch::collect_moving(const View& view, const std::vector<Fragment>& fixed,
                                 std::vector<Fragment>& out) {
  const size_t num_pixels = static_cast<size_t>(view.width) * view.height;
  MovingSink::Limits limits{std::vector<float>(num_pixels, kFloatInfinity),
                            std::vector<float>(num_pixels, -kFloatInfinity)};
  const float upper = m_upper.get();
  // A moving face counts in a pixel if it may reach one of the fixed fragments there within the
  // bound.
  for (const Fragment& f : fixed) {
    limits.lower[f.pixel] = std::min(limits.lower[f.pixel], f.lower - upper);
    limits.upper[f.pixel] = std::max(limits.upper[f.pixel], f.upper);
  }
  // Without fixed faces the motion is free.
  if (fixed.empty()) return true;
  bool overflow = false;
  const auto make = [&] {
    MovingSink sink(limits, view.width);
    sink.most = m_options.most_fragments / static_cast<size_t>(m_options.num_threads);
    return sink;
  };
  const Wanted wanted = wanted_of(limits.lower, limits.upper, view.width, 0);
  const auto done = [&](MovingSink& sink) {
    overflow |= sink.overflow;
    out.insert(out.end(), sink.found.begin(), sink.found.end());
  };
  const bool complete = draw_parts<MovingSink>(m_moving, view, wanted, 1, m_options.num_threads,
                                               make, done, &m_moving_boxes);
  if (!complete) return give_up("a moving face has too many pieces near the axis");
  return overflow ? give_up("too many doubtful moving faces") : true;
}

// Pixels with fragments of both sides, the nearest first.
std::vector<ZListSearch::Pixel> ZListSearch::pixels_of(Lists& lists) {
  sort_fragments(lists.moving);
  sort_fragments(lists.fixed);
  std::vector<Pixel> out;
  for (size_t i = 0, j = 0; i < lists.moving.size() && j < lists.fixed.size();) {
    // Both lists are in the order of pixels, and are walked together.
    const auto a = same_pixel(lists.moving, i), b = same_pixel(lists.fixed, j);
    const int pixel_a = a.front().pixel, pixel_b = b.front().pixel;
    if (pixel_a <= pixel_b) i += a.size();
    if (pixel_b <= pixel_a) j += b.size();
    if (pixel_a != pixel_b) continue;
    float front = -kFloatInfinity, nearest = kFloatInfinity;
    for (const Fragment& f : a) front = std::max(front, f.upper);
    for (const Fragment& f : b) nearest = std::min(nearest, f.lower);
    out.push_back({pixel_a, std::max(0.0F, nearest - front), a, b});
  }
  std::sort(out.begin(), out.end(), [](const Pixel& x, const Pixel& y) {
    return std::tie(x.bound, x.pixel) < std::tie(y.bound, y.pixel);
  });
  return out;
}

// Pixel by pixel, the nearest first, so that the bound sinks early.
bool ZListSearch::resolve(const View& view, int level, size_t pairs_before, Lists& lists) {
  const std::vector<Pixel> pixels = pixels_of(lists);
  if (level == 0) m_work.doubtful_pixels = static_cast<std::int64_t>(pixels.size());
  size_t num_pairs = 0;
  for (const Pixel& p : pixels) num_pairs += p.moving.size() * p.fixed.size();
  // Zooming that did not shorten the lists will not do so next time.
  if (num_pairs * kZoomGain > pairs_before * pixels.size()) level = m_options.zoom_levels;
  for (const Pixel& p : pixels) {
    // All further pixels are farther away still.
    if (p.bound > m_upper.get()) break;
    if (!resolve_pixel(view, level, p)) return false;
  }
  return true;
}

bool ZListSearch::resolve_pixel(const View& view, int level, const Pixel& pixel) {
  Pixel p = pixel;
  const float upper = m_upper.get();
  float front = -kFloatInfinity, nearest = kFloatInfinity;
  for (const Fragment& f : p.moving) front = std::max(front, f.upper);
  for (const Fragment& f : p.fixed) nearest = std::min(nearest, f.lower);
  // Fragments beyond the bound leave the pixel, on both sides.
  const auto a = std::partition(p.moving.begin(), p.moving.end(),
                                [&](const Fragment& f) { return f.upper >= nearest - upper; });
  const auto b = std::partition(p.fixed.begin(), p.fixed.end(),
                                [&](const Fragment& f) { return f.lower <= front + upper; });
  p.moving = {p.moving.begin(), a};
  p.fixed = {p.fixed.begin(), b};
  // Flush surfaces are equally near everywhere; a finer image cannot part them.
  const bool tied = upper - p.bound <= m_tie;
  const bool finer =
      level < m_options.zoom_levels && m_num_zooms < kMostZooms && view.growth() * kZoom <= 1;
  if (finer && p.moving.size() * p.fixed.size() > (tied ? kZoomTiedPairs : kZoomPairs))
    return zoom(view, level, p);
  return add_pairs(p);
}

bool ZListSearch::zoom(const View& view, int level, const Pixel& pixel) {
  // The pixel becomes an image of its own, with the faces of its lists.
  const View finer = view.zoomed(pixel.pixel % view.width, pixel.pixel / view.width, kZoom);
  ++m_num_zooms;
  DepthMap map(finer.width, finer.height);
  Lists lists;
  TriangleRaster moving(finer.of(true)), fixed(finer.of(false));
  const auto draw = [](const Layer& layer, std::span<const Fragment> fragments,
                       TriangleRaster& raster, SpanSink& sink) {
    std::vector<std::uint32_t> faces;
    for (const Fragment& f : fragments) faces.push_back(f.face);
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    bool complete = true;
    for (const std::uint32_t face : faces) {
      sink.face = face;
      complete &= raster.draw(layer.corners(face), sink);
    }
    return complete;
  };
  // Both sides are drawn as before, and the bound may sink by it.
  ZoomSink to_map(map, lists.moving);
  FixedSink to_list(map, m_upper);
  to_list.most = m_options.most_fragments;
  if (!draw(m_moving, pixel.moving, moving, to_map) || !draw(m_fixed, pixel.fixed, fixed, to_list))
    return give_up("a face has too many pieces near the axis");
  if (to_list.overflow || lists.moving.size() > m_options.most_fragments)
    return give_up("too many doubtful faces");
  to_list.compact();
  lists.fixed = std::move(to_list.found);
  return resolve(finer, level + 1, pixel.moving.size() * pixel.fixed.size(), lists);
}

bool ZListSearch::add_pairs(const Pixel& p) {
  const float upper = m_upper.get();
  std::sort(p.fixed.begin(), p.fixed.end(), [](const Fragment& a, const Fragment& b) {
    return std::tie(a.lower, a.face) < std::tie(b.lower, b.face);
  });
  for (const Fragment& a : p.moving)
    for (const Fragment& b : p.fixed) {
      // The fixed fragments are in order: all others are too far.
      if (b.lower - a.upper > upper) break;
      // This one lies behind the moving face.
      if (b.upper < a.lower) continue;
      m_candidates.push_back({a.face, b.face, std::max(0.0F, b.lower - a.upper)});
    }
  // A pair of faces often meets in many pixels: it is counted once before the search gives up.
  if (m_candidates.size() <= m_options.most_pairs) return true;
  drop_duplicates();
  return m_candidates.size() <= m_options.most_pairs / 2 ? true
                                                         : give_up("too many candidate pairs");
}

// Keeps one candidate per pair, with its lowest bound; none beyond the upper bound.
void ZListSearch::drop_duplicates() {
  // Candidates that the bound has passed meanwhile are dropped first.
  const float upper = m_upper.get();
  std::erase_if(m_candidates, [&](const Candidate& c) { return c.bound > upper; });
  std::sort(m_candidates.begin(), m_candidates.end(), [](const Candidate& a, const Candidate& b) {
    return std::tie(a.moving, a.fixed, a.bound) < std::tie(b.moving, b.fixed, b.bound);
  });
  const auto same = [](const Candidate& a, const Candidate& b) {
    return a.moving == b.moving && a.fixed == b.fixed;
  };
  m_candidates.erase(std::unique(m_candidates.begin(), m_candidates.end(), same),
                     m_candidates.end());
}

CandidatePairs ZListSearch::proposal() {
  drop_duplicates();
  const float upper = m_upper.get();
  CandidatePairs out;
  out.usable = true;
  for (const Candidate& c : m_candidates) {
    const Layer::FaceId a = m_moving.id(c.moving), b = m_fixed.id(c.fixed);
    // One float32 ulp for the subtraction of depths.
    const double depth = c.bound * (1 - 2e-7);
    out.pairs.push_back({a.body, b.body, a.face, b.face, m_frame.time_before(depth)});
  }
  std::sort(out.pairs.begin(), out.pairs.end(), [](const FacePair& a, const FacePair& b) {
    return std::tie(a.not_before, a.moving, a.fixed, a.face_moving, a.face_fixed) <
           std::tie(b.not_before, b.moving, b.fixed, b.face_moving, b.face_fixed);
  });
  out.lower = out.pairs.empty() ? kInfinity : out.pairs.front().not_before;
  // A bound that is still the horizon says that perhaps nothing touches.
  if (upper < m_frame.reach) out.upper = m_frame.time_after(upper);
  m_work.body_pairs = static_cast<std::int64_t>(m_frame.pairs.size());
  m_work.face_pairs = static_cast<std::int64_t>(out.pairs.size());
  out.work = m_work;
  return out;
}

}  // namespace trivet
