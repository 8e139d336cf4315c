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

void take_gaps(const float* low, const float* high, int count, Lanes& minima) {
  int i = 0;
  for (; i + kLanes <= count; i += kLanes)
    minima = minima.min(Eigen::Map<const Lanes>(low + i) - Eigen::Map<const Lanes>(high + i));
  for (; i < count; ++i) minima[0] = std::min(minima[0], low[i] - high[i]);
}

}  // namespace

DropProbe::DropProbe(const HeightMap& object) : m_object(object) {
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
  const DropProbe probe(object);
  std::vector<DropBracket> out(size_t(columns) * rows);
  in_parallel(static_cast<size_t>(rows), [&](size_t row) {
    for (int column = 0; column < columns; ++column)
      out[row * columns + column] = probe.at(scene, column, static_cast<int>(row));
  });
  return out;
}

}  // namespace trivet
