#include <gtest/gtest.h>

#include <vector>

#include "core/base/float32.h"

namespace trivet {
namespace {

// In place, in an array, and at compile time unknown: where gcc 12.2 lost the first two.
TEST(Float32, RoundsEveryCoordinate) {
  const volatile double unknown = 0.1;
  const double tenth = unknown;
  std::vector<Vec3> points(3, Vec3(tenth, -2 * tenth, 3 * tenth));
  for (Vec3& p : points) p = as_float32(p);
  for (const Vec3& p : points)
    EXPECT_EQ(p, Vec3(0.1f, -0.2f, static_cast<double>(static_cast<float>(3 * tenth))));
}

TEST(Float32, KeepsFloats) {
  for (const float x : {0.0f, 1.0f, -0.1f, 1e-40f, 3.4e38f}) EXPECT_EQ(as_float32(double{x}), x);
  EXPECT_EQ(as_float32(1e300), kInfinity);
}

}  // namespace
}  // namespace trivet
