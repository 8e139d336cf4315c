#include "raster/height_map/drop_brackets.h"

#include <Eigen/Core>
#include <algorithm>
#include <cassert>
#include <limits>

#include "raster/zlist/parallel.h"

namespace trivet {
namespace {

constexpr int kLanes = 8;
using Lanes = Eigen::Array<float, kLanes, 1>;  // independent minima, which Eigen vectorises
constexpr float kEmpty = std::numeric_limits<float>::infinity();  // height of an empty pixel

// A run of the object's pixels in one row, non-empty at its first and its last.
struct RowRun {
  int row, first, last;  // [first, last)
};

std::vector<RowRun> spans_of(const HeightMap& object) {
  std::vector<RowRun> out;
  for (int row = 0; row < object.height; ++row) {
    const float* line = &object.bound[object.index(0, row)];
    int first = 0, last = object.width;
    while (first < last && line[first] == kEmpty) ++first;
    while (last > first && line[last - 1] == kEmpty) --last;
    if (first < last) out.push_back({row, first, last});
  }
  return out;
}

void take_gaps(const float* low, const float* high, int count, Lanes& minima) {
  int i = 0;
  for (; i + kLanes <= count; i += kLanes)
    minima = minima.min(Eigen::Map<const Lanes>(low + i) - Eigen::Map<const Lanes>(high + i));
  for (; i < count; ++i) minima[0] = std::min(minima[0], low[i] - high[i]);
}

DropBracket bracket_at(const HeightMap& object, const std::vector<RowRun>& spans,
                       const HeightMap& scene, int column, int row) {
  Lanes lower = Lanes::Constant(kEmpty), upper = Lanes::Constant(kEmpty);
  for (const RowRun& s : spans) {
    const size_t from = object.index(s.first, s.row);
    const size_t to = scene.index(column + s.first, row + s.row);
    take_gaps(&object.bound[from], &scene.bound[to], s.last - s.first, lower);
    take_gaps(&object.sample[from], &scene.sample[to], s.last - s.first, upper);
  }
  return {lower.minCoeff(), upper.minCoeff()};
}

}  // namespace

std::vector<DropBracket> drop_brackets(const HeightMap& object, const HeightMap& scene, int columns,
                                       int rows) {
  assert(scene.width >= columns + object.width - 1 && scene.height >= rows + object.height - 1);
  const std::vector<RowRun> spans = spans_of(object);
  std::vector<DropBracket> out(size_t(columns) * rows);
  in_parallel(static_cast<size_t>(rows), [&](size_t row) {
    for (int column = 0; column < columns; ++column)
      out[row * columns + column] = bracket_at(object, spans, scene, column, static_cast<int>(row));
  });
  return out;
}

}  // namespace trivet
