// Scenes of mechanics with known answers: boxes, prisms and cylinders on slopes, walls and each
// other.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <string>
#include <vector>

#include "core/scene/transaction.h"
#include "ops/settle/settle.h"
#include "support/solids.h"

namespace trivet::test {

inline constexpr double kEps = 1e-6;    // clearance
inline constexpr double kGap = 1.5e-6;  // at which things stand on each other at first

inline double radians(double degrees) { return degrees * M_PI / 180; }
/// About y: the x axis goes down.
inline Rotation about_y(double degrees) {
  return Rotation::about_axis(Vec3::UnitY(), std::tan(radians(degrees) / 2));
}

inline std::vector<Triangle> box(double x, double y, double z) {
  return box_triangles(0.5 * Vec3(x, y, z));
}

/// A polygon in xz, convex, drawn out along y.
inline std::vector<Triangle> extruded(const std::vector<Vec2>& polygon, double depth) {
  const size_t n = polygon.size();
  const auto at = [&](size_t i, double side) {
    return Vec3(polygon[i % n].x(), side * depth / 2, polygon[i % n].y());
  };
  std::vector<Triangle> out;
  for (size_t i = 1; i + 1 < n; ++i) {
    out.push_back({at(0, -1), at(i, -1), at(i + 1, -1)});
    out.push_back({at(0, 1), at(i + 1, 1), at(i, 1)});
  }
  for (size_t i = 0; i < n; ++i) add_quad(out, at(i, -1), at(i, 1), at(i + 1, 1), at(i + 1, -1));
  return outward(std::move(out));
}

/// Axis along y.
inline std::vector<Triangle> lying_cylinder(double radius, double length, int sides) {
  std::vector<Vec2> polygon;
  for (int k = 0; k < sides; ++k) {
    const double a = 2 * M_PI * k / sides;
    polygon.push_back(radius * Vec2(std::cos(a), std::sin(a)));
  }
  return extruded(polygon, length);
}

struct Stage {
  Scene scene;
  double friction = 0.5;

  explicit Stage(double friction_of_all, bool floor = true) : friction(friction_of_all) {
    scene.floor = floor;
    scene.floor_material.friction = friction;
  }

  ObjectId add(const std::vector<Triangle>& triangles, const Vec3& at, const Rotation& turned = {},
               bool fixed = false) {
    Object object = object_of("o" + std::to_string(scene.num_objects()), triangles, fixed);
    object.material.friction = friction;
    object.placed = true;
    object.state = fixed ? ObjectState::Fixed : ObjectState::Stable;
    object.pose = {turned, at};
    return scene.add(std::move(object));
  }

  /// A slope of 2 x 1 m through (0, 0, 1.2), down along +x, and something on it: `along` m down
  /// from the middle, its centre `above` m over it.
  ObjectId add_on_slope(double degrees, const std::vector<Triangle>& triangles, double above,
                        double along = -0.5, const Rotation& turned = {}) {
    add(box(2, 1, 0.1), Vec3(0, 0, 1.2), about_y(degrees), true);
    const double a = radians(degrees);
    const Vec3 up(std::sin(a), 0, std::cos(a)), down(std::cos(a), 0, -std::sin(a));
    return add(triangles, Vec3(0, 0, 1.2) + (0.05 + above + kGap) * up + along * down,
               about_y(degrees) * turned);
  }

  SettleOutcome settle(ObjectId id, const SettleOptions& more = {}) const {
    const Neighbourhood others(scene, id);
    return trivet::settle(problem(id, others, more));
  }

  SettleProblem problem(ObjectId id, const Neighbourhood& others,
                        const SettleOptions& more = {}) const {
    const Object& object = scene.at(id);
    SettleProblem out;
    out.shape = object.shape.get();
    out.surface = surface_of(object);
    out.start = object.pose;
    out.others = &others;
    out.clearance = kEps;
    out.options = more;
    out.options.perfect_friction = false;
    return out;
  }
};

/// n bricks, each shifted by `shift` against the one below.
inline void add_stack(Stage& stage, int n, double shift) {
  for (int i = 0; i < n; ++i)
    stage.add(box(0.4, i % 2 ? 0.2 : 0.22, 0.1),
              Vec3(i * shift, 0, 0.05 + kGap + i * (0.1 + kGap)));
}

}  // namespace trivet::test
