#include "placed_meshes.h"

#include <Eigen/Geometry>

namespace trivet::test {

Soup box_soup(const Vec3& lower, const Vec3& upper) {
  const auto corner = [&](int i) {
    return Vec3(i & 1 ? upper.x() : lower.x(), i & 2 ? upper.y() : lower.y(),
                i & 4 ? upper.z() : lower.z());
  };
  constexpr int kQuads[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  Soup out;
  for (const auto& q : kQuads) {
    out.push_back({corner(q[0]), corner(q[1]), corner(q[2])});
    out.push_back({corner(q[0]), corner(q[2]), corner(q[3])});
  }
  return out;
}

Soup sphere_soup(const Vec3& centre, double radius, int levels) {
  Soup unit;
  for (double x : {-1, 1})
    for (double y : {-1, 1})
      for (double z : {-1, 1}) {
        Triangle t = {Vec3(x, 0, 0), Vec3(0, y, 0), Vec3(0, 0, z)};
        if (x * y * z < 0) std::swap(t[1], t[2]);
        unit.push_back(t);
      }
  for (int level = 0; level < levels; ++level) {
    Soup finer;
    for (const auto& [a, b, c] : unit) {
      const Vec3 ab = (a + b).normalized(), bc = (b + c).normalized(), ca = (c + a).normalized();
      for (const Triangle& t : {Triangle{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}})
        finer.push_back(t);
    }
    unit = finer;
  }
  for (Triangle& t : unit)
    for (Vec3& p : t) p = centre + radius * p;
  return unit;
}

Soup reversed(Soup soup) {
  for (Triangle& t : soup) std::swap(t[1], t[2]);
  return soup;
}

Soup joined(Soup a, const Soup& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

Affine random_affine(Source& source, double translation, bool rigid) {
  const Vec3 axis = source.point(-1, 1).normalized();
  Affine out;
  out.linear = Eigen::AngleAxisd(source.uniform(0, 6), axis).toRotationMatrix();
  out.translation = source.point(-translation, translation);
  if (rigid) return out;
  Mat3 shear;
  do {
    for (double& x : shear.reshaped()) x = source.uniform(-1, 1);
  } while (std::abs(shear.determinant()) < 0.05);
  out.linear *= shear;
  return out;
}

Placed::Placed(const Soup& soup, const Affine& pose)
    : shape(make_shape(weld(soup))),
      world_from_object(pose),
      positions(world_positions(*shape, pose)) {}

Triangle Placed::triangle(Index face) const {
  const Index3& t = shape->mesh.triangles[face];
  return {positions[t[0]], positions[t[1]], positions[t[2]]};
}

}  // namespace trivet::test
