// Boxes in contact, and what their contacts must be.
#pragma once

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/tunables.h"
#include "core/contact/contact_points.h"
#include "support/random_shapes.h"

namespace trivet::test {

inline constexpr double kEps = 1e-6;  // clearance; sizes are about 1
inline constexpr double kTolerance = kContactTolerance * kEps;
inline constexpr double kSlack = kFootSlack * kEps;
inline constexpr double kExtent = kContactExtent;

struct Posed {
  std::shared_ptr<const Shape> shape;
  Body body;

  Posed(const std::vector<Triangle>& triangles, const Vec3& at, const Rotation& rotation = {})
      : shape(shape_of(triangles)), body(*shape, placed(rotation, at)) {}
};

inline Posed box(const Vec3& half, const Vec3& at, const Rotation& rotation = {}) {
  return {box_triangles(half), at, rotation};
}

/// Square top at z = 0.
inline Posed table(double half = 1) { return box(Vec3(half, half, 0.5), Vec3(0, 0, -0.5)); }

inline Rotation about(const Vec3& axis, double angle) {
  return Rotation::about_axis(axis, std::tan(0.5 * angle));
}

inline std::vector<ContactPoint> points_of(const Posed& object, const Posed& support) {
  return contact_points(object.body, support.body, kTolerance, kSlack);
}

inline Contact contact_of(const Posed& object, const Posed& support) {
  return make_contact(merged(points_of(object, support), kTolerance), object.body, &support.body,
                      kExtent);
}

inline void expect_normals(const std::vector<ContactPoint>& points, const Vec3& normal) {
  for (const ContactPoint& p : points)
    EXPECT_LT((p.normal - normal).norm(), 1e-9) << p.normal.transpose();
}

/// Area of a polygon seen from above.
inline double area_of(const std::vector<Vec3>& polygon) {
  double twice = 0;
  for (size_t i = 0; i < polygon.size(); ++i) {
    const Vec3 &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    twice += p.x() * q.y() - p.y() * q.x();
  }
  return twice / 2;
}

}  // namespace trivet::test
