// Contact points merged, summed up, and their hulls.

#include <algorithm>

#include "contact_testing.h"

namespace trivet {
namespace {

using test::kEps, test::kExtent, test::Posed, test::table;

ContactPoint point_at(const Vec3& p, double gap = kEps, const Vec3& normal = Vec3::UnitZ()) {
  return {p, normal, gap, ContactFeatures::VertexFace, 0, 0};
}

Contact made(const std::vector<Vec3>& places) {
  const Posed any = table();
  std::vector<ContactPoint> points;
  for (const Vec3& p : places) points.push_back(point_at(p));
  return make_contact(points, any.body, nullptr, kExtent);
}

TEST(MakeContact, TypeFollowsTheExtents) {
  EXPECT_EQ(made({{0, 0, 0}}).type, ContactType::Point);
  EXPECT_EQ(made({{0, 0, 0}, {0.5e-4, 0, 0}}).type, ContactType::Point);
  EXPECT_EQ(made({{0, 0, 0}, {1, 0, 0}}).type, ContactType::Line);
  EXPECT_EQ(made({{0, 0, 0}, {0.5, 0.5e-4, 0}, {1, 0, 0}}).type, ContactType::Line);
  EXPECT_EQ(made({{0, 0, 0}, {0.5, 2e-4, 0}, {1, 0, 0}}).type, ContactType::Area);
  EXPECT_EQ(made({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}, {0.5, 0.5, 0}}).hull.size(), 4u);
}

TEST(MakeContact, SumsUpNormalsAndGaps) {
  const Posed any = table();
  const Vec3 x = Vec3::UnitX(), z = Vec3::UnitZ();
  const Contact c = make_contact({point_at({0, 0, 0}, 3e-7, x), point_at({0, 1, 0}, 2e-7, z)},
                                 any.body, nullptr, kExtent);
  EXPECT_EQ(c.gap, 2e-7);
  EXPECT_LT((c.normal - (x + z).normalized()).norm(), 1e-15);
  EXPECT_EQ(c.points.size(), 2u);
  // Opposite normals have no mean: the first counts.
  const Contact clamp = make_contact({point_at({0, 0, 0}, 1e-7, x), point_at({0, 1, 0}, 1e-7, -x)},
                                     any.body, nullptr, kExtent);
  EXPECT_EQ(clamp.normal, x);
  EXPECT_TRUE(clamp.faces_support.empty());
}

TEST(Merged, KeepsTheSmallestGapOfEachPlaceAndNormal) {
  const auto out = merged({point_at({0, 0, 0}, 3e-7), point_at({1e-7, 0, 0}, 2e-7),
                           point_at({0, 1e-7, 0}, 2e-7), point_at({1, 0, 0}, 5e-7)},
                          1e-6);
  ASSERT_EQ(out.size(), 2u);
  EXPECT_EQ(out[0].point, Vec3(1e-7, 0, 0));
  EXPECT_EQ(out[1].point, Vec3(1, 0, 0));
  const auto corner = merged({point_at({0, 0, 0}), point_at({0, 0, 0}, kEps, Vec3::UnitX())}, 1e-6);
  EXPECT_EQ(corner.size(), 2u);  // another normal is another contact
  EXPECT_TRUE(merged({}, 1).empty());
}

TEST(Merged, LeavesAPointNearEachAndNoneNearAnother) {
  test::Random random(44);
  size_t num_left = 0;
  for (int i = 0; i < 300; ++i) {
    std::vector<ContactPoint> points;
    for (int k = 0; k < 60; ++k)
      points.push_back(point_at(random.in_cube(1), random.uniform(0, kEps),
                                random.integer(0, 1) ? Vec3::UnitZ() : Vec3::UnitX()));
    const double distance = random.uniform(0.05, 0.3);
    const auto out = merged(points, distance);
    num_left += out.size();
    for (size_t a = 0; a < out.size(); ++a)
      for (size_t b = a + 1; b < out.size(); ++b)
        EXPECT_TRUE((out[a].point - out[b].point).norm() > distance ||
                    out[a].normal != out[b].normal);
  }
  EXPECT_LT(num_left, 0.97 * 300 * 60);
  EXPECT_GT(num_left, 0.3 * 300 * 60);
}

double cross(const Vec2& a, const Vec2& b, const Vec2& c) {
  return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
}

TEST(ConvexHull, HoldsAllPointsAndTurnsLeft) {
  test::Random random(45);
  for (int i = 0; i < 2000; ++i) {
    std::vector<Vec2> points;
    const bool grid = i % 2;  // many collinear and equal points
    for (int k = random.integer(3, 40); k > 0; --k)
      points.push_back(grid ? Vec2(random.integer(-2, 2), random.integer(-2, 2))
                            : Vec2(random.uniform(-1, 1), random.uniform(-1, 1)));
    const std::vector<Vec2> hull = convex_hull(points);
    const size_t n = hull.size();
    for (size_t k = 0; n > 2 && k < n; ++k) {
      EXPECT_GT(cross(hull[k], hull[(k + 1) % n], hull[(k + 2) % n]), 0);
      for (const Vec2& p : points) EXPECT_GE(cross(hull[k], hull[(k + 1) % n], p), -1e-15);
    }
    for (const Vec2& h : hull) EXPECT_NE(std::find(points.begin(), points.end(), h), points.end());
  }
}

// A hull of a few points at a time, none of which is left out before sorting. Whole numbers: exact.
TEST(ConvexHull, OfManyPointsIsThatOfItsParts) {
  test::Random random(46);
  for (int i = 0; i < 500; ++i) {
    const int side = random.integer(1, 40), away = i % 3 * 1'000'000;
    std::vector<Vec2> points, part;
    for (int k = random.integer(24, 400); k > 0; --k) {
      points.emplace_back(away + random.integer(-side, side), random.integer(-side, side) - away);
      part.push_back(points.back());
      if (part.size() == 23) part = convex_hull(part);
      ASSERT_LT(part.size(), 23u);
    }
    EXPECT_EQ(convex_hull(points), convex_hull(part));
  }
}

TEST(ConvexHull, Degenerate) {
  EXPECT_TRUE(convex_hull({}).empty());
  EXPECT_EQ(convex_hull({{1, 2}}).size(), 1u);
  EXPECT_EQ(convex_hull({{1, 2}, {1, 2}, {1, 2}, {1, 2}}).size(), 1u);
  EXPECT_EQ(convex_hull({{0, 0}, {1, 1}, {2, 2}, {3, 3}, {1, 1}}).size(), 2u);
}

}  // namespace
}  // namespace trivet
