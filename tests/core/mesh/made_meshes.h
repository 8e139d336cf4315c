// Small meshes with known properties, and pathological random ones.
#pragma once

#include <array>
#include <random>
#include <vector>

#include "core/mesh/mesh.h"

namespace trivet::testing {

using Triangles = std::vector<Triangle>;

/// Two triangles for a planar quadrilateral with corners in order.
inline void add_quad(Triangles& out, const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  out.push_back({a, b, c});
  out.push_back({a, c, d});
}

/// Axis-aligned box, 12 faces, oriented outwards. The first two faces are the top.
inline Triangles make_box(const Vec3& lower, const Vec3& upper) {
  const auto corner = [&](int x, int y, int z) {
    return Vec3(x ? upper.x() : lower.x(), y ? upper.y() : lower.y(), z ? upper.z() : lower.z());
  };
  Triangles out;
  add_quad(out, corner(0, 0, 1), corner(1, 0, 1), corner(1, 1, 1), corner(0, 1, 1));
  add_quad(out, corner(0, 0, 0), corner(0, 1, 0), corner(1, 1, 0), corner(1, 0, 0));
  add_quad(out, corner(0, 0, 0), corner(1, 0, 0), corner(1, 0, 1), corner(0, 0, 1));
  add_quad(out, corner(1, 0, 0), corner(1, 1, 0), corner(1, 1, 1), corner(1, 0, 1));
  add_quad(out, corner(1, 1, 0), corner(0, 1, 0), corner(0, 1, 1), corner(1, 1, 1));
  add_quad(out, corner(0, 1, 0), corner(0, 0, 0), corner(0, 0, 1), corner(0, 1, 1));
  return out;
}

inline Triangles make_cube() { return make_box(Vec3::Zero(), Vec3::Ones()); }

inline Triangles make_tetrahedron(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return {{a, c, b}, {a, b, d}, {b, c, d}, {c, a, d}};
}

/// An octahedron, subdivided and projected to the sphere: 8 x 4^levels faces.
inline Triangles make_sphere(double radius, int levels) {
  Triangles faces;
  for (int signs = 0; signs < 8; ++signs) {
    const Vec3 x(signs & 1 ? -1 : 1, 0, 0), y(0, signs & 2 ? -1 : 1, 0),
        z(0, 0, signs & 4 ? -1 : 1);
    const bool mirrored = x.x() * y.y() * z.z() < 0;
    faces.push_back(mirrored ? Triangle{x, z, y} : Triangle{x, y, z});
  }
  for (int level = 0; level < levels; ++level) {
    Triangles finer;
    for (const auto& [a, b, c] : faces) {
      const Vec3 ab = (a + b).normalized(), bc = (b + c).normalized(), ca = (c + a).normalized();
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    faces = finer;
  }
  for (Triangle& t : faces)
    for (Vec3& p : t) p *= radius;
  return faces;
}

inline Triangles moved(Triangles triangles, const Vec3& by) {
  for (Triangle& t : triangles)
    for (Vec3& p : t) p += by;
  return triangles;
}

inline Triangles scaled(Triangles triangles, double by) {
  for (Triangle& t : triangles)
    for (Vec3& p : t) p *= by;
  return triangles;
}

inline Triangles inside_out(Triangles triangles) {
  for (Triangle& t : triangles) std::swap(t[1], t[2]);
  return triangles;
}

inline Triangles joined(Triangles a, const Triangles& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

/// Corners drawn from few points, so that faces share edges in any number, coincide and degenerate.
inline Triangles make_tangle(std::mt19937& random, int num_faces, int num_points) {
  std::uniform_real_distribution<double> coordinate(-1, 1);
  std::vector<Vec3> points(num_points);
  for (Vec3& p : points) p = {coordinate(random), coordinate(random), coordinate(random)};
  std::uniform_int_distribution<int> pick(0, num_points - 1);
  Triangles out;
  for (int i = 0; i < num_faces; ++i)
    out.push_back({points[pick(random)], points[pick(random)], points[pick(random)]});
  return out;
}

/// Small separate triangles in a cube of this size about a centre.
inline Triangles make_soup(std::mt19937& random, int num_faces, double size = 1,
                           const Vec3& centre = Vec3::Zero()) {
  std::uniform_real_distribution<double> coordinate(-1, 1);
  const auto point = [&] {
    const double x = coordinate(random), y = coordinate(random), z = coordinate(random);
    return Vec3(x, y, z);
  };
  Triangles out;
  for (int i = 0; i < num_faces; ++i) {
    const Vec3 place = centre + size * point();
    out.push_back({place, place + 0.05 * size * point(), place + 0.05 * size * point()});
  }
  return out;
}

}  // namespace trivet::testing
