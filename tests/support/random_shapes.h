// Meshes and motions for random tests: round, needle-like, flat, degenerate.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "core/contact/first_contact.h"

namespace trivet::test {

class Random {
 public:
  explicit Random(unsigned seed) : m_engine(seed) {}
  double uniform(double low, double high) {
    return low + (high - low) * (static_cast<double>(m_engine() >> 11) * 0x1p-53);
  }
  int integer(int low, int high) {
    return low + static_cast<int>(m_engine() % static_cast<unsigned>(high - low + 1));
  }
  Vec3 in_cube(double half) {
    const double x = uniform(-half, half), y = uniform(-half, half);
    return {x, y, uniform(-half, half)};
  }
  /// At most `half` from the z axis, along x and y.
  Vec3 beside(double half, double z) {
    const double x = uniform(-half, half), y = uniform(-half, half);
    return {x, y, z};
  }
  Vec3 direction() {
    for (;;) {
      const Vec3 v = in_cube(1);
      if (v.norm() > 0.1 && v.norm() < 1) return v.normalized();
    }
  }
  Rotation rotation() {
    return Rotation{uniform(-1, 1), uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)}.normalized();
  }

 private:
  std::mt19937_64 m_engine;
};

inline void add_quad(std::vector<Triangle>& out, const Vec3& a, const Vec3& b, const Vec3& c,
                     const Vec3& d) {
  out.push_back({a, b, c});
  out.push_back({a, c, d});
}

/// Closed box of 12 triangles about the origin.
inline std::vector<Triangle> box_triangles(const Vec3& half) {
  const auto p = [&](int i) {
    return Vec3(i & 1 ? half.x() : -half.x(), i & 2 ? half.y() : -half.y(),
                i & 4 ? half.z() : -half.z());
  };
  std::vector<Triangle> out;
  add_quad(out, p(0), p(2), p(3), p(1));
  add_quad(out, p(4), p(5), p(7), p(6));
  add_quad(out, p(0), p(1), p(5), p(4));
  add_quad(out, p(2), p(6), p(7), p(3));
  add_quad(out, p(0), p(4), p(6), p(2));
  add_quad(out, p(1), p(3), p(7), p(5));
  return out;
}

/// Sphere of rings x segments with bumps, radius about 1; closed.
inline std::vector<Triangle> bumpy_sphere(int rings, int segments, double bump, unsigned seed) {
  Random random(seed);
  const double a = random.uniform(2, 5), b = random.uniform(2, 5), c = random.uniform(0, 6);
  const auto at = [&](int i, int j) -> Vec3 {
    const double theta = M_PI * i / rings, phi = 2 * M_PI * (j % segments) / segments;
    const Vec3 d(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
    if (i == 0 || i == rings) return (i == 0 ? 1.0 : -1.0) * Vec3::UnitZ();
    return (1 + bump * std::sin(a * d.x() + c) * std::sin(b * d.y()) * std::sin(theta)) * d;
  };
  std::vector<Triangle> out;
  for (int i = 0; i < rings; ++i)
    for (int j = 0; j < segments; ++j) {
      if (i > 0) out.push_back({at(i, j), at(i + 1, j), at(i, j + 1)});
      if (i + 1 < rings) out.push_back({at(i, j + 1), at(i + 1, j), at(i + 1, j + 1)});
    }
  return out;
}

/// Height field over [-half, half]^2, open.
inline std::vector<Triangle> terrain(int n, double half, double height, unsigned seed) {
  Random random(seed);
  const double a = random.uniform(2, 5), b = random.uniform(2, 5);
  const auto at = [&](int i, int j) {
    const double x = half * (2.0 * i / n - 1), y = half * (2.0 * j / n - 1);
    return Vec3(x, y, height * std::sin(a * x) * std::cos(b * y));
  };
  std::vector<Triangle> out;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      add_quad(out, at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
  return out;
}

/// Unconnected triangles in the unit cube: `kind` 0 any, 1 needles, 2 degenerate (segments and
/// points), 3 on a coarse grid (coplanar and parallel pairs abound), 4 tiny.
inline std::vector<Triangle> soup(int n, int kind, Random& random) {
  std::vector<Triangle> out;
  for (int i = 0; i < n; ++i) {
    const Vec3 p = random.in_cube(1);
    if (kind == 1) {
      const Vec3 d = random.direction();
      out.push_back({p, p + d, p + 0.5 * d + 1e-7 * random.direction()});
    } else if (kind == 2) {
      const Vec3 d = random.integer(0, 1) * random.direction();
      out.push_back({p, p + d, p + random.integer(0, 2) * 0.5 * d});
    } else if (kind == 3) {
      Triangle t;
      for (Vec3& q : t)
        q = Vec3(random.integer(-2, 2), random.integer(-2, 2), random.integer(-2, 2)) * 0.5;
      out.push_back(t);
    } else {
      const double size = kind == 4 ? 1e-3 : 0.7;
      out.push_back({p, p + size * random.direction(), p + size * random.direction()});
    }
  }
  return out;
}

inline std::shared_ptr<const Shape> shape_of(const std::vector<Triangle>& triangles) {
  return make_shape(weld(triangles));
}

inline Affine placed(const Rotation& rotation, const Vec3& translation, double scale = 1) {
  return world_from_object({rotation, translation}, UpAxis::Z, scale);
}

/// A motion of either kind; rotations are about axes near the moving body's centre.
inline Motion random_motion(bool rotation, const Vec3& centre, double reach, Random& random) {
  if (!rotation) return Motion::translation(random.direction(), random.uniform(0.5, 3) * reach);
  return Motion::rotation(centre + random.in_cube(reach), random.direction(),
                          random.uniform(0.2, 1));
}

}  // namespace trivet::test
