#include "raster/height_map/drop_brackets.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cassert>
#include <limits>

#include "core/base/parallel.h"

namespace trivet {
namespace {

constexpr int kSide = 8;                       // of a tile, pixels
constexpr int kLanes = 8;                      // neighbouring places, judged together
using Lanes = Eigen::Array<float, kLanes, 1>;  // which Eigen vectorises
constexpr float kEmpty = std::numeric_limits<float>::infinity();

void take_gaps(const float* low, const float* high, int count, Lanes& minima) {
  // Neighbouring pixels are compared in lanes; the rest of a row goes one by one.
  int i = 0;
  for (; i + kLanes <= count; i += kLanes)
    minima = minima.min(Eigen::Map<const Lanes>(low + i) - Eigen::Map<const Lanes>(high + i));
  for (; i < count; ++i) minima[0] = std::min(minima[0], low[i] - high[i]);
}

// A square of the object's pixels, filled up with empty ones.
struct Tile {
  int column, row;
  float lowest = kEmpty;
  std::array<float, size_t(kSide) * kSide> heights;
};

// Tiles that are not empty.
std::vector<Tile> tiles_of(const HeightMap& object, const std::vector<float>& heights) {
  std::vector<Tile> out;
  // Tiles that hold nothing of the object are left out.
  for (int row = 0; row < object.height; row += kSide)
    for (int column = 0; column < object.width; column += kSide) {
      Tile tile{column, row, kEmpty, {}};
      tile.heights.fill(kEmpty);
      for (int y = row; y < std::min(row + kSide, object.height); ++y)
        for (int x = column; x < std::min(column + kSide, object.width); ++x)
          tile.heights[(y - row) * kSide + x - column] = heights[object.index(x, y)];
      tile.lowest = *std::min_element(tile.heights.begin(), tile.heights.end());
      if (tile.lowest < kEmpty) out.push_back(tile);
    }
  return out;
}

// The lowest and highest of heights in the window that begins at each pixel.
struct Windows {
  std::vector<float> lowest, highest;

  Windows() = default;
  // Windows must end within their rows.
  Windows(const std::vector<float>& heights, int stride, int width, int height)
      : lowest(heights), highest(heights) {
    widen(1, width);
    widen(size_t(stride), height);
  }

 private:
  // Two windows that overlap make one, at most twice as long.
  void widen(size_t along, int wanted) {
    for (int length = 1, more = 0; length < wanted; length += more) {
      more = std::min(length, wanted - length);
      const size_t step = along * more;
      const auto count = static_cast<Eigen::Index>(lowest.size() - step);
      using Line = Eigen::Map<Eigen::ArrayXf>;
      Line low(lowest.data(), count), high(highest.data(), count);
      low = low.min(Line(lowest.data() + step, count));
      high = high.max(Line(highest.data() + step, count));
    }
  }
};

// The scene with an empty margin to the right and below, so that tiles and lanes fit everywhere.
struct Top {
  int stride = 0, num_rows = 0;
  std::vector<float> heights;
  Windows tiles, objects;  // of the size of a tile, and of the object

  Top() = default;
  Top(const HeightMap& object, const HeightMap& scene, const std::vector<float>& from)
      : stride(scene.width + kSide + kLanes),
        num_rows(scene.height + kSide),
        heights(size_t(stride) * num_rows, -kEmpty) {
    for (int y = 0; y < scene.height; ++y)
      std::copy_n(&from[scene.index(0, y)], scene.width, &heights[index(0, y)]);
    objects = Windows(heights, stride, object.width, object.height);
  }
  void add_tiles() { tiles = Windows(heights, stride, kSide, kSide); }
  size_t index(int column, int row) const { return size_t(row) * stride + column; }
};

// The smallest difference of an object's heights and a scene's. Over a flat part of the scene it is
// the object's lowest less that height. Elsewhere by branch and bound: it is at most a tile's
// lowest less the lowest under the tile, and in no tile below the lowest less the highest there.
// Rounding is monotone, so that all this holds for rounded differences.
class SmallestGaps {
 public:
  SmallestGaps(const HeightMap& object, const std::vector<float>& object_heights,
               const HeightMap& scene, const std::vector<float>& scene_heights)
      : m_tiles(tiles_of(object, object_heights)) {
    if (m_tiles.empty()) return;
    m_top = Top(object, scene, scene_heights);
    for (const Tile& tile : m_tiles) m_lowest = std::min(m_lowest, tile.lowest);
  }

  // Needed by at() and by farther_by_tiles().
  void prepare_tiles() {
    if (!m_tiles.empty()) m_top.add_tiles();
  }

  // At the first `count` places from (column, row) on.
  // @param bounds  scratch.
  Lanes at(int column, int row, int count, std::vector<Lanes>& bounds) const {
    if (m_tiles.empty()) return Lanes::Constant(kEmpty);
    const size_t place = m_top.index(column, row);
    const Eigen::Map<const Lanes> low(&m_top.objects.lowest[place]);
    const Eigen::Map<const Lanes> high(&m_top.objects.highest[place]);
    // A scene that is flat under the object needs its lowest point alone.
    if ((low == high).head(count).all()) return m_lowest - high;
    // Tiles bound the difference at several places at once; only those left in doubt look at
    // pixels.
    const auto [least, most] = bounded(column, row, bounds);
    Lanes out = most;
    for (int lane = 0; lane < count; ++lane)
      if (least[lane] < most[lane])
        out[lane] = at_place(column + lane, row, lane, least[lane], most[lane], bounds);
    return out;
  }

  // Tells if the differences are larger than `falls` at the first `count` places from (column, row)
  // on, by what is under the whole object; 0 for infinite falls.
  // @return whether all are decided; those that are not are kUndecided.
  bool farther(int column, int row, int count, const float* falls, char* out) const {
    bool all = true;
    for (int lane = 0; lane < count; ++lane) {
      // The lowest point over the highest ground is a lower bound, over the lowest ground an upper
      // one.
      const size_t place = m_top.index(column + lane, row);
      const bool never = !(falls[lane] < kEmpty);
      if (m_tiles.empty() || never) {
        out[lane] = !never;
      } else if (m_lowest - m_top.objects.highest[place] > falls[lane]) {
        out[lane] = 1;
      } else if (m_lowest - m_top.objects.lowest[place] > falls[lane]) {
        out[lane] = kUndecided;
        all = false;
      } else {
        out[lane] = 0;
      }
    }
    return all;
  }

  // Decides those that farther() left.
  void farther_by_tiles(int column, int row, int count, const float* falls,
                        std::vector<Lanes>& bounds, char* out) const {
    if (std::find(out, out + count, kUndecided) == out + count) return;
    // Bounds of the tiles decide most; the rest compares pixels.
    const auto [least, most] = bounded(column, row, bounds);
    for (int lane = 0; lane < count; ++lane) {
      if (out[lane] != kUndecided) continue;
      if (least[lane] > falls[lane])
        out[lane] = 1;
      else
        out[lane] = most[lane] > falls[lane] && at_place(column + lane, row, lane, least[lane],
                                                         most[lane], bounds) > falls[lane];
    }
  }

 private:
  static constexpr char kUndecided = 2;

  struct Bounds {
    Lanes least, most;  // of the difference at each place
  };

  // @param bounds  scratch: the least difference within each tile.
  Bounds bounded(int column, int row, std::vector<Lanes>& bounds) const {
    bounds.resize(m_tiles.size());
    Bounds out{Lanes::Constant(kEmpty), Lanes::Constant(kEmpty)};
    for (size_t k = 0; k < m_tiles.size(); ++k) {
      const Tile& tile = m_tiles[k];
      const size_t under = m_top.index(column + tile.column, row + tile.row);
      bounds[k] = tile.lowest - Eigen::Map<const Lanes>(&m_top.tiles.highest[under]);
      out.least = out.least.min(bounds[k]);
      out.most = out.most.min(tile.lowest - Eigen::Map<const Lanes>(&m_top.tiles.lowest[under]));
    }
    return out;
  }

  // The most promising tile, the first of the least bound, then all that can still go below
  // `found`.
  float at_place(int column, int row, int lane, float least, float found,
                 const std::vector<Lanes>& bounds) const {
    // The tile with the least bound most likely holds the smallest difference, and rules out the
    // others.
    size_t best = 0;
    while (bounds[best][lane] != least) ++best;
    found = std::min(found, in_tile(m_tiles[best], column, row));
    for (size_t k = 0; k < bounds.size(); ++k)
      if (k != best && bounds[k][lane] < found)
        found = std::min(found, in_tile(m_tiles[k], column, row));
    return found;
  }

  float in_tile(const Tile& tile, int column, int row) const {
    const float* high = &m_top.heights[m_top.index(column + tile.column, row + tile.row)];
    Lanes minima = Lanes::Constant(kEmpty);
    for (int y = 0; y < kSide; ++y)
      minima = minima.min(Eigen::Map<const Lanes>(&tile.heights[size_t(y) * kSide]) -
                          Eigen::Map<const Lanes>(high + size_t(y) * m_top.stride));
    return minima.minCoeff();
  }

  std::vector<Tile> m_tiles;
  float m_lowest = kEmpty;  // of all tiles
  Top m_top;
};

}  // namespace

DropProbe::DropProbe(const HeightMap& object) : m_object(object) {
  // Empty pixels at both ends of a row are skipped for all places.
  for (int row = 0; row < object.height; ++row) {
    const float* line = &object.bound[object.index(0, row)];
    int first = 0, last = object.width;
    while (first < last && line[first] == kEmpty) ++first;
    while (last > first && line[last - 1] == kEmpty) --last;
    if (first < last) m_runs.push_back({row, first, last});
  }
}

DropBracket DropProbe::at(const HeightMap& scene, int column, int row) const {
  Lanes lower = Lanes::Constant(kEmpty), upper = Lanes::Constant(kEmpty);
  for (const RowRun& run : m_runs) {
    const size_t from = m_object.index(run.first, run.row);
    const size_t to = scene.index(column + run.first, row + run.row);
    take_gaps(&m_object.bound[from], &scene.bound[to], run.last - run.first, lower);
    take_gaps(&m_object.sample[from], &scene.sample[to], run.last - run.first, upper);
  }
  return {lower.minCoeff(), upper.minCoeff()};
}

std::vector<DropBracket> drop_brackets(const HeightMap& object, const HeightMap& scene, int columns,
                                       int rows) {
  assert(scene.width >= columns + object.width - 1 && scene.height >= rows + object.height - 1);
  SmallestGaps lower(object, object.bound, scene, scene.bound);
  SmallestGaps upper(object, object.sample, scene, scene.sample);
  lower.prepare_tiles();
  upper.prepare_tiles();
  std::vector<DropBracket> out(size_t(columns) * rows);
  // Rows of places are independent: threads share them.
  in_parallel(static_cast<size_t>(rows), [&](size_t row) {
    std::vector<Lanes> bounds;
    for (int column = 0; column < columns; column += kLanes) {
      const int count = std::min(kLanes, columns - column);
      const Lanes low = lower.at(column, static_cast<int>(row), count, bounds);
      const Lanes high = upper.at(column, static_cast<int>(row), count, bounds);
      for (int lane = 0; lane < count; ++lane)
        out[row * columns + column + lane] = {low[lane], high[lane]};
    }
  });
  return out;
}

std::vector<char> falls_farther(const HeightMap& object, const HeightMap& scene, int columns,
                                int rows, std::span<const float> falls) {
  assert(falls.size() == size_t(columns) * rows);
  SmallestGaps gaps(object, object.bound, scene, scene.bound);
  std::vector<char> out(falls.size());
  // First by what is under the whole object; tiles are prepared where that leaves something.
  std::vector<int> left;
  for (int row = 0; row < rows; ++row) {
    const size_t first = size_t(row) * columns;
    if (!gaps.farther(0, row, columns, &falls[first], &out[first])) left.push_back(row);
  }
  if (left.empty()) return out;
  gaps.prepare_tiles();
  in_parallel(left.size(), [&](size_t i) {
    std::vector<Lanes> bounds;
    const size_t first = size_t(left[i]) * columns;
    for (int column = 0; column < columns; column += kLanes)
      gaps.farther_by_tiles(column, left[i], std::min(kLanes, columns - column),
                            &falls[first + column], bounds, &out[first + column]);
  });
  return out;
}

}  // namespace trivet
