// Brackets from the GPU equal those of the software bit for bit.

#include <gtest/gtest.h>

#include <memory>

#include "core/base/error.h"
#include "gpu/zlist/drop_brackets_gpu.h"
#include "raster/height_map/drop_brackets.h"
#include "support/random_shapes.h"

namespace trivet {
namespace {

HeightMap random_map(int width, int height, double sign, test::Random& random) {
  HeightMap map(width, height, static_cast<float>(sign * kInfinity));
  for (size_t i = 0; i < map.bound.size(); ++i) {
    if (random.integer(0, 4) == 0) continue;
    map.bound[i] = static_cast<float>(random.uniform(-1, 1));
    if (random.integer(0, 1)) map.sample[i] = static_cast<float>(random.uniform(-1e3, 1e3));
  }
  return map;
}

TEST(GpuDropBrackets, EqualSoftware) {
  std::unique_ptr<GpuDropBrackets> gpu;
  try {
    gpu = std::make_unique<GpuDropBrackets>();
  } catch (const Error& e) {
    GTEST_SKIP() << e.what();
  }
  test::Random random(17);
  for (const int width : {1, 5, 16, 33})
    for (const int height : {1, 7, 20}) {
      const int columns = random.integer(1, 40), rows = random.integer(1, 40);
      const HeightMap object = random_map(width, height, 1, random);
      const HeightMap scene = random_map(columns + width + 1, rows + height - 1, -1, random);
      const auto truth = drop_brackets(object, scene, columns, rows);
      const auto found = (*gpu)(object, scene, columns, rows);
      ASSERT_EQ(found.size(), truth.size());
      for (size_t i = 0; i < truth.size(); ++i) {
        ASSERT_EQ(found[i].lower, truth[i].lower);
        ASSERT_EQ(found[i].upper, truth[i].upper);
      }
    }
}

}  // namespace
}  // namespace trivet
