// Passes of a search over a layer, in parts. Private.
#pragma once

#include "core/base/parallel.h"
#include "raster/zlist/fragment_sinks.h"

namespace trivet {

/// Runs every part of a layer with its own sink, made by `make`, and hands them to `done` in order.
/// @return false if a face had too many pieces.
template <class Sink, class Make, class Done>
bool draw_parts(const Layer& layer, const View& view, const Wanted& wanted, std::size_t stride,
                int num_threads, Make make, Done done, FaceBoxes* boxes = nullptr) {
  const std::size_t count = layer.num_faces(), parts = num_parts(count / stride, num_threads);
  // Each part has a sink of its own: no locks, and a result that does not depend on the order of
  // threads.
  std::vector<Sink> sinks(parts, make());
  std::vector<char> complete(parts);
  for_each_part(
      count, static_cast<int>(parts), [&](std::size_t part, std::size_t first, std::size_t last) {
        Sink& sink = sinks[part];
        TriangleRaster raster(view);
        complete[part] =
            view.turning()
                ? draw_faces<true>(layer, view, wanted, first, last, stride, raster, sink)
                : draw_faces<false>(layer, view, wanted, first, last, stride, raster, sink, boxes);
      });
  for (Sink& sink : sinks) done(sink);
  return std::find(complete.begin(), complete.end(), 0) == complete.end();
}

/// Region of pixels with non-empty intervals, and the hull of the intervals, grown by `later` at
/// the upper end.
inline Wanted wanted_of(const std::vector<float>& lower, const std::vector<float>& upper, int width,
                        float later) {
  // Pixels whose interval is empty, where nothing can be found any more, stay out of the region.
  Wanted out{kFloatInfinity, -kFloatInfinity, width, std::numeric_limits<int>::max(), -1, -1};
  for (std::size_t i = 0; i < lower.size(); ++i) {
    if (!(lower[i] <= upper[i])) continue;
    const int x = static_cast<int>(i) % width, y = static_cast<int>(i) / width;
    out.x0 = std::min(out.x0, x);
    out.x1 = std::max(out.x1, x);
    out.y0 = std::min(out.y0, y);
    out.y1 = std::max(out.y1, y);
    out.lower = std::min(out.lower, lower[i]);
    out.upper = std::max(out.upper, upper[i]);
  }
  // The end grows by rounding too, as depths are added in float32.
  if (out.x1 >= 0) out.upper += later + 1e-6F * (std::abs(out.upper) + later);
  return out;
}

}  // namespace trivet
