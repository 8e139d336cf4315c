// Shares of a load between points.
#include <gtest/gtest.h>

#include "ops/stability/certificate.h"
#include "support/random_shapes.h"

namespace trivet::test {
namespace {

TEST(Shares, ReachTargetAndAreNotNegative) {
  Random random(7);
  int num_inside = 0;
  for (int i = 0; i < 2000; ++i) {
    std::vector<Vec2> points;
    const int n = random.integer(1, 9);
    for (int k = 0; k < n; ++k)
      points.push_back(i % 3 == 0 ? Vec2(random.integer(-2, 2), random.integer(-2, 2))
                                  : Vec2(random.uniform(-1, 1), random.uniform(-1, 1)));
    // A mean of the points, so inside.
    Vec2 target = Vec2::Zero();
    double sum = 0;
    for (const Vec2& p : points) {
      const double w = random.uniform(0.01, 1);
      target += w * p;
      sum += w;
    }
    target /= sum;
    const std::vector<double> parts = shares(points, target, 1e-12);
    ASSERT_EQ(parts.size(), points.size());
    Vec2 mean = Vec2::Zero();
    double total = 0;
    for (size_t k = 0; k < parts.size(); ++k) {
      EXPECT_GE(parts[k], 0);
      mean += parts[k] * points[k];
      total += parts[k];
    }
    EXPECT_NEAR(total, 1, 1e-12);
    EXPECT_LT((mean - target).norm(), 1e-9);
    num_inside += n > 2;
    EXPECT_TRUE(shares(points, Vec2(5, 5), 0).empty());
  }
  EXPECT_GT(num_inside, 1000);
}

}  // namespace
}  // namespace trivet::test
