// A shape somewhere in the world, and its boxes seen from another frame.
#pragma once

#include "core/index/shape.h"

namespace trivet {

/// One shape somewhere in the world.
struct Body {
  const Shape* shape = nullptr;
  Affine world_from_object;  // rotation x uniform scale, translation
  Aabb world_box;            // holds all vertices

  Body() = default;
  /// The box is that of the root of the shape's tree, which it does not need.
  Body(const Shape& s, const Affine& m);

  Vec3 vertex(Index v) const { return world_from_object.apply(shape->mesh.vertices[v]); }
  Triangle triangle(Index f) const {
    const Index3& t = shape->mesh.triangles[f];
    return {vertex(t[0]), vertex(t[1]), vertex(t[2])};
  }
  /// Length of the columns of the matrix.
  double scale() const { return world_from_object.linear.col(0).norm(); }
};

/// The boxes of a body's tree in the world, as axis-aligned boxes there.
struct PlacedBvh {
  const Bvh& bvh;
  Mat3 linear, abs_linear;
  Vec3 translation;
  double scale;

  explicit PlacedBvh(const Body& body)
      : bvh(body.shape->bvh()),
        linear(body.world_from_object.linear),
        abs_linear(linear.cwiseAbs()),
        translation(body.world_from_object.translation),
        scale(body.scale()) {}

  struct Box {
    Vec3 centre, half;
    double radius;  // of the sphere about the box
  };
  /// Number by number, as the innermost loops inline it: of an inline function that several
  /// libraries call, the linker keeps one copy, and where Eigen's vectors are not inlined, boxes
  /// take three times as long.
  Box box(Index node) const {
    const BvhNode& n = bvh.nodes[node];
    Vec3 centre, half;
    for (int k = 0; k < 3; ++k) {
      const double lower = n.lower[k], upper = n.upper[k];
      centre[k] = 0.5 * (lower + upper);
      half[k] = 0.5 * (upper - lower);
    }
    return {linear * centre + translation, abs_linear * half, scale * half.norm()};
  }
};

/// The frame of a fixed body at unit scale: its own boxes are axis-aligned and tight there.
struct UnitFrame {
  Mat3 unit_from_world;
  Vec3 origin;

  explicit UnitFrame(const Body& fixed);
  Vec3 point(const Vec3& world) const { return unit_from_world * (world - origin); }
  Vec3 direction(const Vec3& world) const { return unit_from_world * world; }
};

}  // namespace trivet
