// Height maps and brackets of falls: what a GPU and software compute from the same data.
#pragma once

#include <functional>
#include <vector>

#include "core/base/types.h"

namespace trivet {

/// Heights seen from above or below, pixel by pixel, row by row. Metres over a common level.
struct HeightMap {
  int width = 0, height = 0;
  /// Bounds of an object's underside: not higher than any point over the pixel; +infinity: nothing
  /// there. Of a scene's top: not lower than any point over the pixel; -infinity: nothing there.
  std::vector<float> bound;
  /// On the line through the pixel's centre; the same infinities where it certainly meets nothing
  /// or may miss.
  std::vector<float> sample;

  HeightMap() = default;
  HeightMap(int w, int h, float nothing)
      : width(w), height(h), bound(size_t(w) * h, nothing), sample(size_t(w) * h, nothing) {}
  size_t index(int column, int row) const { return size_t(row) * width + column; }
};

/// Drop of the object at one place until it touches the scene: in [lower, upper].
/// upper infinite: perhaps never; lower infinite: never; lower negative: it may start inside.
struct DropBracket {
  float lower, upper;
};

/// The brackets for all places (column, row) in [0, columns) x [0, rows), row by row, at which the
/// object's map lies with its first pixel on the scene's pixel (column, row). The scene's map is at
/// least columns + object.width - 1 wide, and so on.
using DropBracketFunction = std::function<std::vector<DropBracket>(
    const HeightMap& object, const HeightMap& scene, int columns, int rows)>;

}  // namespace trivet
