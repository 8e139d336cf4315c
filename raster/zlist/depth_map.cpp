#include "raster/zlist/depth_map.h"

#include <algorithm>
#include <limits>

#include "core/base/parallel.h"

namespace trivet {
namespace {

static_assert(kPartStep % FaceBoxes::kRun == 0, "two threads would write the box of one run");

template <bool kTurning>
bool draw_part(const Layer& layer, const View& view, size_t first, size_t last, DepthMap& out,
               FaceBoxes* boxes) {
  TriangleRaster raster(view);
  DepthMapSink sink(out);
  return draw_faces<kTurning>(layer, view, Wanted::all_of(view), first, last, 1, raster, sink,
                              boxes);
}

}  // namespace

DepthMap::DepthMap(int w, int h) : width(w), height(h) {
  // Empty pixels have limits that every face betters.
  const size_t n = static_cast<size_t>(w) * h;
  lower.assign(n, kFloatInfinity);
  upper.assign(n, -kFloatInfinity);
  highest_centre.assign(n, -kFloatInfinity);
  lowest_centre.assign(n, kFloatInfinity);
}

void DepthMap::add(const Span& s) {
  const int at = s.row * width + s.first;
  float *low = &lower[at], *high = &upper[at];
  for (int i = 0; i < s.count; ++i) {
    low[i] = std::min(low[i], s.lower[i]);
    high[i] = std::max(high[i], s.upper[i]);
  }
  // Depths at centres bound what is met for certain; badly known ones bound nothing.
  if (!(s.centre_error <= kLargestCentreError)) return;
  float *nearest = &lowest_centre[at], *farthest = &highest_centre[at];
  for (int i = 0; i < s.count; ++i) {
    const float near_by = s.centre[i] + s.centre_error, far_by = s.centre[i] - s.centre_error;
    nearest[i] = near_by < nearest[i] ? near_by : nearest[i];  // false for NaN
    farthest[i] = far_by > farthest[i] ? far_by : farthest[i];
  }
}

void DepthMap::add_sample(int pixel, float depth, float error) {
  lowest_centre[pixel] = std::min(lowest_centre[pixel], depth + error);
  highest_centre[pixel] = std::max(highest_centre[pixel], depth - error);
}

void DepthMap::add(const DepthMap& other) {
  for (size_t i = 0; i < lower.size(); ++i) {
    lower[i] = std::min(lower[i], other.lower[i]);
    upper[i] = std::max(upper[i], other.upper[i]);
    highest_centre[i] = std::max(highest_centre[i], other.highest_centre[i]);
    lowest_centre[i] = std::min(lowest_centre[i], other.lowest_centre[i]);
  }
}

bool draw_depth_map(const Layer& layer, const View& view, int num_threads, DepthMap& out,
                    FaceBoxes* boxes) {
  const size_t count = layer.num_faces(), parts = num_parts(count, num_threads);
  // Each part of the faces has a map of its own.
  std::vector<DepthMap> maps(parts, DepthMap(view.width, view.height));
  std::vector<char> complete(parts);
  for_each_part(count, num_threads, [&](size_t part, size_t first, size_t last) {
    complete[part] = view.turning() ? draw_part<true>(layer, view, first, last, maps[part], nullptr)
                                    : draw_part<false>(layer, view, first, last, maps[part], boxes);
  });
  if (boxes && !view.turning()) boxes->noted = true;
  // Minima and maxima do not depend on how the faces were shared among threads.
  out = std::move(maps[0]);
  for (size_t i = 1; i < parts; ++i) out.add(maps[i]);
  return std::find(complete.begin(), complete.end(), 0) == complete.end();
}

}  // namespace trivet
