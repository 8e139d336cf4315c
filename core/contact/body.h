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

/// The boxes of a body's tree in a frame of unit scale (metres), as axis-aligned boxes there.
struct PlacedBvh {
  const Bvh& bvh;
  Mat3 linear, abs_linear;
  Vec3 translation;
  double scale;
  bool own_frame = false;  // only scaled: boxes stay as they are

  PlacedBvh(const Bvh& tree, const Mat3& m, const Vec3& t, double s)
      : bvh(tree), linear(m), abs_linear(m.cwiseAbs()), translation(t), scale(s) {}
  /// In the world.
  explicit PlacedBvh(const Body& body)
      : PlacedBvh(body.shape->bvh(), body.world_from_object.linear,
                  body.world_from_object.translation, body.scale()) {}

  struct Box {
    Vec3 centre, half;
    double radius;  // of the sphere about the box
    Vec3 own_half;  // along the body's own axes
  };
  /// Unit, in this frame.
  Vec3 own_axis(int k) const { return linear.col(k) / scale; }
  /// Number by number, as the innermost loops inline it: of an inline function that several
  /// libraries call, the linker keeps one copy, and where Eigen's vectors are not inlined, boxes
  /// take three times as long.
  Box box(Index node) const {
    const BvhNode& n = bvh.nodes[node];
    Vec3 centre, half, own_half;
    for (int k = 0; k < 3; ++k) {
      const double lower = n.lower[k], upper = n.upper[k];
      centre[k] = 0.5 * (lower + upper);
      half[k] = 0.5 * (upper - lower);
      own_half[k] = scale * half[k];
    }
    const double radius = scale * half.norm();
    if (own_frame) {
      for (int k = 0; k < 3; ++k) centre[k] *= scale;
      return {centre, own_half, radius, own_half};
    }
    return {linear * centre + translation, abs_linear * half, radius, own_half};
  }
};

/// The frame of a fixed body at unit scale: its own boxes are axis-aligned and tight there.
struct UnitFrame {
  Mat3 unit_from_world;
  Vec3 origin;

  explicit UnitFrame(const Body& fixed);
  Vec3 point(const Vec3& world) const { return unit_from_world * (world - origin); }
  Vec3 direction(const Vec3& world) const { return unit_from_world * world; }
  PlacedBvh tree(const Body& other) const;  // of another body, in this frame
  PlacedBvh own_tree(const Body& fixed) const;
};

}  // namespace trivet
