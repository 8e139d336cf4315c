// Obstacles and problems of the tests of flexible bodies.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "core/flex/drape.h"

namespace trivet::test {

using namespace trivet::flex;

inline void add_box(Obstacles& out, const Vec3& low, const Vec3& high, double friction = 10) {
  Points corners;
  for (int i = 0; i < 8; ++i)
    corners.emplace_back(i & 1 ? high[0] : low[0], i & 2 ? high[1] : low[1],
                         i & 4 ? high[2] : low[2]);
  const std::vector<std::array<Index, 3>> faces{{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6},
                                                {0, 1, 5}, {0, 5, 4}, {2, 6, 7}, {2, 7, 3},
                                                {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  out.add(corners, faces, friction);
}

/// A surface of revolution of a profile (radius, height) about the axis through the origin along z,
/// or y.
inline void add_lathe(Obstacles& out, const std::vector<Vec2>& profile, int sides, const Vec3& at,
                      bool along_y = false) {
  Points x;
  for (const Vec2& p : profile)
    for (int i = 0; i < sides; ++i) {
      const double angle = 2 * M_PI * i / sides;
      const Vec3 v(p[0] * std::cos(angle), p[0] * std::sin(angle), p[1]);
      x.push_back(at + (along_y ? Vec3(v[0], -v[2], v[1]) : v));
    }
  std::vector<std::array<Index, 3>> faces;
  for (int k = 0; k + 1 < static_cast<int>(profile.size()); ++k)
    for (int i = 0; i < sides; ++i) {
      const int a = k * sides + i, b = k * sides + (i + 1) % sides;
      faces.push_back({a, b, b + sides});
      faces.push_back({a, b + sides, a + sides});
    }
  out.add(x, faces, 10);
}

/// A level sheet with its middle at a point.
inline DrapeProblem sheet(int num_u, int num_v, double length_u, double length_v, const Vec3& at,
                          const FlexMaterial& material = {}) {
  DrapeProblem out;
  out.material = material;
  out.grid = Grid{num_u, num_v, length_u, length_v};
  for (int j = 0; j <= num_v; ++j)
    for (int i = 0; i <= num_u; ++i)
      out.start.push_back(
          at + Vec3(length_u * i / num_u - length_u / 2, length_v * j / num_v - length_v / 2, 0));
  out.pinned.assign(out.start.size(), false);
  return out;
}

/// A cable along a line of these corners.
inline DrapeProblem cable(int num_segments, double length, const Points& path,
                          const FlexMaterial& material) {
  DrapeProblem out;
  out.material = material;
  out.num_segments = num_segments;
  out.length = length;
  std::vector<double> at{0};
  for (size_t i = 1; i < path.size(); ++i) at.push_back(at.back() + (path[i] - path[i - 1]).norm());
  size_t k = 0;
  for (int i = 0; i <= num_segments; ++i) {
    const double s = at.back() * i / num_segments;
    while (k + 2 < at.size() && at[k + 1] < s) ++k;
    const double share = (s - at[k]) / (at[k + 1] - at[k]);
    out.start.push_back((1 - share) * path[k] + share * path[k + 1]);
  }
  out.pinned.assign(out.start.size(), false);
  return out;
}

inline Obstacles built(Obstacles obstacles) {
  obstacles.build();
  return obstacles;
}

}  // namespace trivet::test
