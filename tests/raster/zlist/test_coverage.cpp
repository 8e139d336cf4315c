// Coverage of every pixel that a triangle meets, including needles, segments and points.
#include <gtest/gtest.h>

#include <tuple>

#include "raster/zlist/coverage.h"
#include "support/random_shapes.h"

namespace trivet {
namespace {

constexpr int kSize = 24;

// Triangles of every shape; the third corner often on the edge of the others, up to rounding.
std::array<Vec2, 3> random_triangle(test::Random& random) {
  const auto point = [&] { return Vec2(random.uniform(-5, kSize + 5), random.uniform(-5, 29)); };
  std::array<Vec2, 3> p = {point(), point(), point()};
  const int kind = random.integer(0, 4);
  if (kind == 0) p[2] = 0.5 * (p[0] + p[1]);
  if (kind == 1) p[2] = p[0] + random.uniform(0, 1) * (p[1] - p[0]) + Vec2(1e-13, 0);
  if (kind == 2) p[1] = p[0] + 1e-15 * Vec2(random.uniform(-1, 1), random.uniform(-1, 1));
  if (kind == 3 && random.integer(0, 3) == 0) p[1] = p[2] = p[0];
  std::swap(p[0], p[random.integer(0, 2)]);
  return p;
}

TEST(Coverage, TouchesEveryPixelThatTriangleMeets) {
  test::Random random(11);
  int num_inside = 0, num_touched = 0, num_met = 0;
  for (int i = 0; i < 20000; ++i) {
    const std::array<Vec2, 3> p = random_triangle(random);
    const Coverage cover(p, 0.51, 0.51, kSize, kSize);
    for (int j = 0; j < 20; ++j) {
      double u = random.uniform(0, 1), v = random.uniform(0, 1);
      if (u + v > 1) u = 1 - u, v = 1 - v;
      const Vec2 x = p[0] + u * (p[1] - p[0]) + v * (p[2] - p[0]);
      if (!(x.minCoeff() >= 0 && x.maxCoeff() < kSize)) continue;
      const int column = static_cast<int>(x.x()), row = static_cast<int>(x.y());
      ASSERT_TRUE(row >= cover.first_row() && row <= cover.last_row());
      const Coverage::Columns touched = cover.touched(row);
      ASSERT_TRUE(column >= touched.first && column <= touched.last) << i;
      ++num_met;
    }
    std::vector<CoverageRow> rows;
    if (cover.is_empty()) continue;
    cover.rows(0.01, rows);
    for (int row = cover.first_row(); row <= cover.last_row(); ++row) {
      const Coverage::Columns touched = cover.touched(row), inside = cover.inside(row, 0.01);
      const CoverageRow& same = rows[row - cover.first_row()];
      ASSERT_EQ(std::tie(same.touched.first, same.touched.last),
                std::tie(touched.first, touched.last));
      ASSERT_EQ(std::tie(same.inside.first, same.inside.last), std::tie(inside.first, inside.last));
      num_touched += std::max(0, touched.last - touched.first + 1);
      num_inside += std::max(0, inside.last - inside.first + 1);
      for (int c = inside.first; c <= inside.last; ++c) {
        ASSERT_TRUE(c >= touched.first && c <= touched.last);
        const Vec2 centre(c + 0.5, row + 0.5);
        int sides = 0;
        for (int k = 0; k < 3; ++k) {
          const Vec2 e = p[(k + 1) % 3] - p[k], f = centre - p[k];
          sides += e.x() * f.y() - e.y() * f.x() > 0 ? 1 : -1;
        }
        ASSERT_EQ(std::abs(sides), 3);
      }
    }
  }
  EXPECT_GT(num_met, 100000);
  EXPECT_GT(num_inside, num_touched / 4);
  EXPECT_LT(num_inside, num_touched);
}

}  // namespace
}  // namespace trivet
