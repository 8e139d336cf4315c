// Smallest and largest depth of all drawn faces per pixel: the paper's second stage.
#pragma once

#include <algorithm>
#include <vector>

#include "raster/zlist/draw_faces.h"

namespace trivet {

/// Bounds of depths in each pixel, row by row. Empty pixels: +infinity and -infinity.
struct DepthMap {
  int width = 0, height = 0;
  std::vector<float> lower, upper;  // contain all faces in the pixel
  /// On the line through the pixel's centre, some face lies at `highest_centre` or farther, and
  /// some at `lowest_centre` or nearer.
  std::vector<float> highest_centre, lowest_centre;

  DepthMap() = default;
  DepthMap(int w, int h);
  bool empty_at(int pixel) const { return lower[pixel] > upper[pixel]; }

  void add(const Span& span);
  void add(const SmallFace& f) {
    for (int y = f.y0; y <= f.y1; ++y)
      for (int x = f.x0; x <= f.x1; ++x) {
        const int at = y * width + x;
        lower[at] = std::min(lower[at], f.lower);  // branchless: unpredictable
        upper[at] = std::max(upper[at], f.upper);
      }
  }
  /// The line through the pixel's centre meets a face at `depth`, give or take `error`.
  void add_sample(int pixel, float depth, float error);
  void add(const DepthMap& other);
};

/// Draws into a depth map.
class DepthMapSink final : public SpanSink {
 public:
  static constexpr bool kCentres = true;
  explicit DepthMapSink(DepthMap& map) : m_map(map) {}
  void span(const Span& s) override { m_map.add(s); }
  void small(const SmallFace& f) { m_map.add(f); }
  void sample(int pixel, float depth, float error) { m_map.add_sample(pixel, depth, error); }

 private:
  DepthMap& m_map;
};

/// Draws all faces of a projected layer.
/// @param boxes  receives the boxes of runs, along a direction; null: not needed.
/// @return false if a face had too many pieces: the map is incomplete.
bool draw_depth_map(const Layer& layer, const View& view, int num_threads, DepthMap& out,
                    FaceBoxes* boxes = nullptr);

}  // namespace trivet
