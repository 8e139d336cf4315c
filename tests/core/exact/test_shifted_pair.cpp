#include <gtest/gtest.h>

#include "core/exact/predicates.h"
#include "core/exact/shifted_pair.h"
#include "placed_meshes.h"

namespace trivet::test {
namespace {

constexpr unsigned kShiftsSeed = 20261128;

/// By all pairs of faces, at positions of the moved placement.
bool cross_by_brute_force(const PlacedShape& a, const PlacedShape& b, const Vec3& by) {
  Affine moved = a.world_from_object;
  moved.translation += by;
  const Positions at_a = world_positions(*a.shape, moved);
  const Positions at_b = world_positions(*b.shape, b.world_from_object);
  const auto triangle = [](const Index3& t, const Positions& at) {
    return Triangle{at[t[0]], at[t[1]], at[t[2]]};
  };
  for (const Index3& t : a.shape->mesh.triangles)
    for (const Index3& u : b.shape->mesh.triangles)
      if (triangles_intersect(triangle(t, at_a), triangle(u, at_b))) return true;
  return false;
}

PlacedShape without_positions(const Placed& p) {
  return {p.shape.get(), nullptr, p.world_from_object, 0, {}};
}

Soup any_soup(Source& source) {
  const int kind = source.integer(0, 2);
  if (kind == 0) return sphere_soup(source.point(-0.2, 0.2), 0.5, source.integer(1, 2));
  if (kind == 1) return box_soup(-source.point(0.1, 0.5), source.point(0.1, 0.5));
  Soup out;  // some of them degenerate
  for (int i = source.integer(1, 40); i > 0; --i) {
    const Vec3 at = source.point(-0.5, 0.5);
    Triangle t{at, at + source.point(-0.3, 0.3), at + source.point(-0.3, 0.3)};
    if (source.integer(0, 5) == 0) t[2] = t[source.integer(0, 1)];
    out.push_back(t);
  }
  return out;
}

// Shifts grow, and are halved then, as those who look for a depth ask; flush boxes among them.
TEST(ShiftedPair, CrossesWhereBruteForceDoes) {
  Source source(kShiftsSeed);
  int num_crossing = 0, num_asked = 0;
  for (int i = 0; i < 150; ++i) {
    const bool is_flush = i % 5 == 0;
    const Affine any = random_affine(source, i % 3 == 0 ? 1e4 : 1, i % 2 == 0);
    Affine near = is_flush ? any : random_affine(source, 0.3, i % 2 == 0);
    if (!is_flush) near.translation += any.translation;
    const Vec3 half = Vec3::Constant(0.25);
    const Placed a(is_flush ? box_soup(-half, half) : any_soup(source), any);
    const Placed b(is_flush ? box_soup(-half, half) : any_soup(source), near);
    const PlacedShape of_a = without_positions(a), of_b = without_positions(b);
    ShiftedPair pair(of_a, of_b);
    Vec3 way = source.point(-1, 1).normalized();
    if (is_flush) way = any.linear.col(source.integer(0, 2));
    double held = 0, free = 1e-3;
    for (int k = 0; k < 24; ++k) {
      const double length = free < 2 ? free : 0.5 * (held + free);
      const bool cross = cross_by_brute_force(of_a, of_b, length * way);
      ASSERT_EQ(pair.cross(length * way), cross) << "case " << i << ", seed " << kShiftsSeed;
      num_crossing += cross;
      ++num_asked;
      if (free < 2 && cross)
        held = free, free *= 8;
      else
        (cross ? held : free) = length;
    }
  }
  std::printf("seed %u: %d of %d cross\n", kShiftsSeed, num_crossing, num_asked);
  EXPECT_GT(num_crossing, num_asked / 12);
  EXPECT_LT(num_crossing, num_asked * 4 / 5);
}

TEST(ShiftedPair, DoesNotCrossWithoutFaces) {
  const Placed none{Soup{}}, box(box_soup(Vec3::Zero(), Vec3::Ones()));
  const PlacedShape of_none = without_positions(none), of_box = without_positions(box);
  EXPECT_FALSE(ShiftedPair(of_none, of_box).cross(Vec3::Zero()));
  EXPECT_FALSE(ShiftedPair(of_box, of_none).cross(Vec3::Zero()));
  EXPECT_TRUE(ShiftedPair(of_box, of_box).cross(Vec3::Zero()));
}

}  // namespace
}  // namespace trivet::test
