// Small meshes with known insides, placed in the world.
#pragma once

#include <memory>

#include "core/exact/interpenetration.h"
#include "integer_reference.h"

namespace trivet::test {

using Soup = std::vector<Triangle>;

/// Closed, 12 faces, oriented outwards.
Soup box_soup(const Vec3& lower, const Vec3& upper);
/// Closed, 8 x 4^levels faces, oriented outwards; corners on the sphere.
Soup sphere_soup(const Vec3& centre, double radius, int levels);
Soup reversed(Soup soup);
Soup joined(Soup a, const Soup& b);

/// Any invertible matrix: rotation x scale, sometimes sheared or mirrored, and a translation.
Affine random_affine(Source& source, double translation, bool rigid);

/// A shape and its positions, kept alive together.
struct Placed {
  std::shared_ptr<const Shape> shape;
  Affine world_from_object;
  Positions positions;
  double slack = 0;

  explicit Placed(const Soup& soup, const Affine& pose = {});
  operator PlacedShape() const { return {shape.get(), &positions, world_from_object, slack}; }
  Triangle triangle(Index face) const;
};

}  // namespace trivet::test
