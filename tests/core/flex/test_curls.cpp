// Paper that is curled at rest: an open mesh, a part of a cylinder.
#include <gtest/gtest.h>

#include <cmath>

#include "core/flex/elasticity.h"
#include "tests/core/flex/stage.h"

namespace trivet::test {
namespace {

constexpr double kRadius = 0.05, kAngle = 2;   // of the curl, radians
constexpr int kAround = 16, kAlong = 8;        // cells
constexpr double kWidth = 0.08, kOver = 2e-3;  // metres, also above the floor

int vertex_of(int i, int j) { return j * (kAround + 1) + i; }

// It opens upwards; its lowest line is along y. The halves are mirrored.
DrapeProblem curled_paper() {
  DrapeProblem out;
  out.material.bending = 0.05;
  for (int j = 0; j <= kAlong; ++j)
    for (int i = 0; i <= kAround; ++i) {
      const double angle = kAngle * (static_cast<double>(i) / kAround - 0.5);
      out.start.emplace_back(kRadius * std::sin(angle),
                             kWidth * (static_cast<double>(j) / kAlong - 0.5),
                             kOver + kRadius * (1 - std::cos(angle)));
    }
  for (int j = 0; j < kAlong; ++j)
    for (int i = 0; i < kAround; ++i) {
      const int a = vertex_of(i, j), b = vertex_of(i + 1, j);
      const int c = vertex_of(i + 1, j + 1), d = vertex_of(i, j + 1);
      if (i < kAround / 2) {
        out.faces.push_back({a, b, c}), out.faces.push_back({a, c, d});
      } else {
        out.faces.push_back({a, b, d}), out.faces.push_back({b, c, d});
      }
    }
  out.pinned.assign(out.start.size(), false);
  return out;
}

TEST(FlexCurls, HaveNoEnergyButTheirWeight) {
  const DrapeProblem paper = curled_paper();
  const Body body = body_of(paper);
  Points gradient(paper.start.size(), Vec3::Zero());
  Total total{&gradient, nullptr, Curvature::Exact};
  elastic_energy(body, paper.start, total);
  for (size_t v = 0; v < body.size(); ++v)
    EXPECT_LT((gradient[v] - Vec3(0, 0, body.mass[v] * kGravity)).norm(),
              1e-9 * body.mean_weight());
}

// Flattened, it would push with far more than its weight.
TEST(FlexCurls, RestAlongALineAndKeepTheirCurl) {
  const DrapeProblem paper = curled_paper();
  Obstacles room;
  add_box(room, {-1, -1, -0.05}, {1, 1, 0});
  room.build();
  const DrapeResult result = drape(paper, room, {});
  ASSERT_EQ(result.ending, Ending::AtRest);
  EXPECT_TRUE(result.certificate.stable);
  EXPECT_NEAR(result.certificate.balance, 1, 1e-4);
  const double clear = paper.material.thickness / 2 + result.layer;
  for (int j = 0; j <= kAlong; ++j) {
    const Vec3 &left = result.x[vertex_of(0, j)], &right = result.x[vertex_of(kAround, j)];
    const double chord = 2 * kRadius * std::sin(kAngle / 2);
    EXPECT_NEAR((right - left).norm(), chord, 1e-3 * chord);
    EXPECT_NEAR(left.z(), right.z(), 1e-5) << "it is as symmetric as it was";
    EXPECT_LT(result.x[vertex_of(kAround / 2, j)].z(), clear);
    for (int i = 0; i <= kAround; ++i) {
      if (std::abs(i - kAround / 2) > 1) {
        EXPECT_GT(result.x[vertex_of(i, j)].z(), clear);
      }
    }
  }
}

}  // namespace
}  // namespace trivet::test
