#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "apps/demo/shapes/assemble.h"
#include "core/base/error.h"
#include "core/mesh/mass.h"

namespace trivet::shapes {
namespace {

TEST(Curves, PassThroughControlPoints) {
  const std::vector<ControlPoint> points{smooth({0, 0}), smooth({1, 1}, 1), smooth({2, 0}, 2),
                                         corner({3, 1}), corner({4, 0})};
  const auto curve = flatten(points, 1e-3);
  EXPECT_EQ(curve.front().value, points.front().value);
  EXPECT_EQ(curve.back().value, points.back().value);
  for (const ControlPoint& p : points) {  // each is a sample: material change, corner or end
    const auto same = [&](const CurveSample& s) { return s.value == p.value; };
    EXPECT_EQ(std::count_if(curve.begin(), curve.end(), same), 1);
  }
}

TEST(Curves, UseFewerSamplesForMoreTolerance) {
  const std::vector<ControlPoint> points{pole(0), smooth({1, 1}), pole(2)};
  const auto coarse = flatten(points, 0.1), fine = flatten(points, 0.001);
  EXPECT_LT(coarse.size(), fine.size());
  EXPECT_GT(coarse.size(), 3u);
  EXPECT_EQ(flatten({corner({0, 0}), corner({1, 0}), corner({1, 1})}, 1e-6).size(), 3u);
}

TEST(Curves, MeetAxisAtRightAnglesInPoles) {
  const auto curve = flatten({pole(0), smooth({1, 1}), pole(2)}, 1e-5);
  EXPECT_LT(std::abs(curve[1][1] - curve[0][1]), 0.1 * std::abs(curve[1][0] - curve[0][0]));
}

double volume(const std::vector<Ring>& rings) { return signed_volume(skin(rings).triangles) / 6; }

TEST(Surfaces, HaveVolumeOfRevolution) {
  const auto cylinder =
      flatten({corner({0, 0}), corner({2, 0}), corner({2, 3}), corner({0, 3})}, 1e-3);
  const double n = 64, polygon = 0.5 * n * 4 * std::sin(2 * std::numbers::pi / n);
  EXPECT_NEAR(volume(revolve(cylinder, {64, 64, 0})), 3 * polygon, 1e-12);
  const double mixed = volume(revolve(cylinder, {64, 16, 1}));
  EXPECT_NEAR(mixed, 3 * polygon, 1e-12);  // no ring has a radius below 1, but the poles
}

TEST(Surfaces, HaveVolumeOfSlabsAndSweeps) {
  EXPECT_NEAR(volume(slab({2, 1}, 1e-4, 1e-5, 0, 0.5, 1)), 4, 1e-3);
  const auto path = flatten({corner({0, 0, 0.1, 0.2}), corner({0, 2, 0.1, 0.2})}, 1e-3);
  EXPECT_NEAR(volume(sweep(path, 128)), 2 * std::numbers::pi * 0.02, 1e-4);
}

TEST(Surfaces, RequireSegmentPerRoundedCorner) {
  EXPECT_THROW(rounded_rectangle(2, 1, 0.1, 0, 0), Error);
  EXPECT_THROW(slab({2, 1}, 0.1, 0.01, 0, 1, -3), Error);
  const Ring ring = rounded_rectangle(2, 1, 0.1, 1, 0);
  ASSERT_EQ(ring.points.size(), 8u);
  for (const Vec3& p : ring.points) EXPECT_TRUE(p.allFinite());
}

TEST(Surfaces, CloseUnequalRings) {
  for (const size_t n : {3u, 4u, 5u, 7u, 12u, 36u}) {
    std::vector<Ring> rings;
    for (const size_t m : {n, size_t{7}, size_t{24}, n}) {
      Ring ring;
      for (size_t k = 0; k < m; ++k) {
        const double angle = 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(m);
        ring.points.emplace_back(std::cos(angle), std::sin(angle),
                                 static_cast<double>(rings.size()));
      }
      rings.push_back(std::move(ring));
    }
    const Model model = assemble("test", {{skin(rings)}}, {Material{}});
    const Adjacency adjacency = make_adjacency(model.mesh);
    ASSERT_EQ(adjacency.components.size(), 1u) << n;
    EXPECT_TRUE(adjacency.components[0].manifold) << n;
    EXPECT_EQ(adjacency.edge_vertices.size() * 2, model.mesh.triangles.size() * 3);
  }
}

TEST(Assemble, SnapsToGridAndFloor) {
  EXPECT_EQ(snap_to_grid(0.3), 314573 * kGrid);
  EXPECT_FALSE(std::signbit(snap_to_grid(-1e-9)));
  const Model model = assemble("box", {{skin(slab({1, 1}, 0.1, 0.05, 3, 4, 3))}}, {Material{}});
  EXPECT_EQ(model.mesh.box().lower.z(), 0);
  EXPECT_EQ(model.mesh.box().upper.z(), 1);
}

TEST(Assemble, KeepsHardEdgesHard) {
  // A cylinder: round about its axis, flat on top.
  const auto profile =
      flatten({corner({0, 0}), corner({1, 0}), corner({1, 1}), corner({0, 1})}, 1e-3);
  const Model model = assemble("drum", {{skin(revolve(profile, {32, 32, 0}))}}, {Material{}});
  for (size_t f = 0; f < model.mesh.triangles.size(); ++f) {
    for (int c = 0; c < 3; ++c) {
      const Vec3 p = model.mesh.vertices[model.mesh.triangles[f][c]];
      const Eigen::Vector3f n = model.corner_normals[f][c];
      if (std::abs(n.z()) > 0.5f) {
        EXPECT_NEAR(std::abs(n.z()), 1, 1e-6);
      } else {
        EXPECT_NEAR(p.x() * n.x() + p.y() * n.y(), 1, 1e-3);
      }
    }
  }
}

}  // namespace
}  // namespace trivet::shapes
