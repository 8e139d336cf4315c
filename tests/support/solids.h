// Closed solids for tests of contact and settling, oriented outwards, and scene objects made of
// them.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "core/base/float32.h"
#include "core/scene/scene.h"
#include "support/random_shapes.h"

namespace trivet::test {

using Triangles = std::vector<Triangle>;

inline double signed_volume(const Triangles& triangles) {
  double six = 0;
  for (const Triangle& t : triangles) six += t[0].dot(t[1].cross(t[2]));
  return six / 6;
}

/// Flipped if its volume is negative.
inline Triangles outward(Triangles triangles) {
  if (signed_volume(triangles) < 0)
    for (Triangle& t : triangles) std::swap(t[1], t[2]);
  return triangles;
}

inline Triangles moved(Triangles triangles, const Vec3& by) {
  for (Triangle& t : triangles)
    for (Vec3& p : t) p += by;
  return triangles;
}

inline Triangles box_between(const Vec3& lower, const Vec3& upper) {
  return moved(box_triangles(0.5 * (upper - lower)), 0.5 * (lower + upper));
}

inline Triangles joined(Triangles a, const Triangles& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

/// Tube around rings of points with the same number each; `closed` joins the last to the first,
/// otherwise fans close the ends.
inline Triangles skin(const std::vector<std::vector<Vec3>>& rings, bool closed) {
  Triangles out;
  const size_t n = rings.size(), m = rings[0].size();
  const auto add = [&](const Vec3& a, const Vec3& b, const Vec3& c) {
    if (a != b && b != c && c != a) out.push_back({a, b, c});
  };
  for (size_t i = 0; i + (closed ? 0 : 1) < n; ++i)
    for (size_t j = 0; j < m; ++j) {
      const Vec3 &a = rings[i][j], &b = rings[i][(j + 1) % m];
      const Vec3 &c = rings[(i + 1) % n][(j + 1) % m], &d = rings[(i + 1) % n][j];
      add(a, b, c);
      add(a, c, d);
    }
  for (size_t j = 1; !closed && j + 1 < m; ++j) {
    add(rings[0][0], rings[0][j + 1], rings[0][j]);
    add(rings[n - 1][0], rings[n - 1][j], rings[n - 1][j + 1]);
  }
  return outward(out);
}

/// The closed outline (radius, height) turned about z; radius 0 is a point of the axis.
inline Triangles revolved(const std::vector<Vec2>& outline, int segments) {
  std::vector<std::vector<Vec3>> rings;
  for (int i = 0; i < segments; ++i) {
    const double angle = 2 * M_PI * i / segments;
    std::vector<Vec3> ring;
    ring.reserve(outline.size());
    for (const Vec2& p : outline)
      ring.emplace_back(p.x() * std::cos(angle), p.x() * std::sin(angle), p.y());
    for (Vec3& p : ring)
      if (p.head<2>().norm() == 0) p.head<2>().setZero();  // -0
    rings.push_back(ring);
  }
  return skin(rings, true);
}

inline Triangles cylinder(double radius, double height, int segments) {
  const double h = height / 2;
  return revolved({{0, -h}, {radius, -h}, {radius, h}, {0, h}}, segments);
}

inline Triangles torus(double major, double minor, int segments, int sides) {
  std::vector<Vec2> circle;
  for (int k = 0; k < sides; ++k) {
    const double a = 2 * M_PI * (k + 0.5) / sides;
    circle.emplace_back(major + minor * std::cos(a), minor * std::sin(a));
  }
  return revolved(circle, segments);
}

/// Bowl, dish or saucer: a shell of the given thickness that rises from a flat foot at z = 0 like
/// (r / radius)^power to `height`.
inline Triangles dish(double radius, double height, double thickness, double power, int segments) {
  std::vector<Vec2> outline{{0, 0}, {0.3 * radius, 0}};
  const auto at = [&](double r) { return height * std::pow((r - 0.3) / 0.7, power); };
  for (double r : {0.5, 0.7, 0.85, 1.0}) outline.emplace_back(r * radius, at(r));
  for (double r : {1.0, 0.85, 0.7, 0.5, 0.3}) outline.emplace_back(r * radius, at(r) + thickness);
  outline.emplace_back(0, thickness);
  return revolved(outline, segments);
}

inline Triangles ball(double radius, int rings, int segments) {
  Triangles out = bumpy_sphere(rings, segments, 0, 1);
  for (Triangle& t : out)
    for (Vec3& p : t) p *= radius;
  return outward(out);
}

/// Round rod along a path in the plane y = 0.
inline Triangles rod(const std::vector<Vec3>& path, double radius, int sides) {
  std::vector<std::vector<Vec3>> rings;
  for (size_t i = 0; i < path.size(); ++i) {
    const Vec3 along = path[std::min(i + 1, path.size() - 1)] - path[i > 0 ? i - 1 : 0];
    const Vec3 y = Vec3::UnitY(), across = y.cross(along).normalized();
    std::vector<Vec3> ring;
    for (int k = 0; k < sides; ++k) {
      const double a = 2 * M_PI * (k + 0.5) / sides;
      ring.push_back(path[i] + radius * (std::cos(a) * across + std::sin(a) * y));
    }
    rings.push_back(ring);
  }
  return skin(rings, false);
}

/// A rod bent like a walking stick: a shaft along z, and half a turn at its upper end.
inline Triangles hook(double length, double bend, double radius) {
  std::vector<Vec3> path{{0, 0, -length}};
  for (int k = 0; k <= 10; ++k) {
    const double a = M_PI * k / 10;
    path.emplace_back(bend * (1 - std::cos(a)), 0, bend * std::sin(a));
  }
  path.emplace_back(2 * bend, 0, -bend);
  return rod(path, radius, 6);
}

/// Convex polygon in the plane y = 0, extruded to both sides of it.
inline Triangles prism(const std::vector<Vec2>& polygon, double half_width) {
  std::vector<std::vector<Vec3>> rings(2);
  for (const Vec2& p : polygon) {
    rings[0].emplace_back(p.x(), -half_width, p.y());
    rings[1].emplace_back(p.x(), half_width, p.y());
  }
  return skin(rings, false);
}

inline Triangles tetrahedron(double size) {
  const double k = size / 2;
  const Vec3 a(k, k, k), b(k, -k, -k), c(-k, k, -k), d(-k, -k, k);
  return outward({{a, b, c}, {a, d, b}, {b, d, c}, {c, d, a}});
}

/// A spoon's outline: a thin handle with a round, thicker end.
inline Triangles stick(double length) {
  return rod({{-0.5 * length, 0, 0},
              {0.2 * length, 0, 0.02 * length},
              {0.35 * length, 0, 0},
              {0.5 * length, 0, 0.04 * length}},
             0.03 * length, 6);
}

/// An unplaced object. Coordinates are rounded to float32, as in files.
inline Object object_of(const std::string& name, Triangles triangles, bool fixed = false) {
  for (Triangle& t : triangles)
    for (Vec3& p : t) p = as_float32(p);
  auto model = std::make_shared<Model>();
  model->path = name;
  model->format = "made";
  model->mesh = weld(triangles);
  model->materials.emplace_back();
  model->face_material.assign(triangles.size(), 0);
  Object object;
  object.name = name;
  object.shape = make_shape(model->mesh);
  object.model = std::move(model);
  object.fixed = fixed;
  return object;
}

}  // namespace trivet::test
