// Flat faces that lie on each other: the whole overlap is found, with the normal of the faces.

#include <algorithm>

#include "contact_testing.h"

namespace trivet {
namespace {

using test::about, test::area_of, test::box, test::contact_of, test::expect_normals,
    test::points_of, test::Posed, test::table, test::kEps, test::kSlack, test::kTolerance;

// A turn of equal boxes that leaves all corners of each beside the face of the other, and edges
// too near to parallel to cross.
TEST(ContactPatches, EqualBoxesTurnedByAHairTouchInTheWholeFace) {
  for (const double angle : {1e-9, 3e-8, 1e-7, -3e-7, 1e-6, -3e-6, 1e-5, 1e-4})
    for (const double tilt : {0.0, 3e-8, 2e-7})
      for (const double gap : {0.1, 0.6, 1.0, 1.5}) {
        if (gap * kEps < 1.2 * std::abs(tilt)) continue;  // they would cross
        const Posed object = box(Vec3(1, 1, 0.3), Vec3(0, 0, 0.3 + gap * kEps),
                                 about(Vec3::UnitZ(), angle) * about(Vec3::UnitX(), tilt));
        const Contact c = contact_of(object, table());
        EXPECT_EQ(c.type, ContactType::Area) << angle << " " << tilt << " " << gap;
        EXPECT_NEAR(area_of(c.hull), 4, 1e-3) << angle << " " << tilt << " " << gap;
        for (const ContactPoint& p : c.points) EXPECT_GT(p.normal.z(), 1 - 1e-5);
      }
}

/// A flat square of n x n quads at z = 0, that looks up or down.
std::vector<Triangle> plate(int n, bool up) {
  std::vector<Triangle> out = test::terrain(n, 1, 0, 1);
  if (!up)
    for (Triangle& t : out) std::swap(t[1], t[2]);
  return out;
}

TEST(ContactPatches, PlatesOfManyFacesTouchInTheWholeAndGrowNoSlower) {
  size_t last = 0;
  for (const int n : {4, 8, 16}) {
    const Posed lower(plate(n, true), Vec3::Zero());
    const Posed upper(plate(n, false), Vec3(0, 0, kEps), about(Vec3::UnitZ(), 3e-7));
    const auto points = points_of(upper, lower);
    EXPECT_NEAR(area_of(contact_of(upper, lower).hull), 4, 1e-3);
    expect_normals(points, Vec3::UnitZ());
    if (last > 0) {
      EXPECT_LT(points.size(), 4.5 * last);  // the faces are four times as many
    }
    last = points.size();
  }
}

// An L lies on the edge of a table: the corner inside it is over nothing but what it hangs on.
TEST(ContactPatches, AHookOverAnEdgeTouchesTheTopToItsInnerCorner) {
  std::vector<Triangle> hook;
  const double w = 0.2;
  const Vec2 outline[] = {{-0.5, 0}, {0, 0}, {0, -0.3}, {0.1, -0.3}, {0.1, 0.1}, {-0.5, 0.1}};
  const auto at = [&](int i, double y) { return Vec3(outline[i % 6].x(), y, outline[i % 6].y()); };
  for (int i = 0; i < 6; ++i)
    test::add_quad(hook, at(i, -w), at(i, w), at(i + 1, w), at(i + 1, -w));
  for (const auto& [i, j, k] : {std::array{0, 1, 5}, {1, 4, 5}, {1, 2, 4}, {2, 3, 4}}) {
    hook.push_back({at(i, -w), at(j, -w), at(k, -w)});
    hook.push_back({at(i, w), at(k, w), at(j, w)});
  }
  const Posed object(hook, Vec3(1 + 0.5 * kEps, 0, kEps));
  std::vector<ContactPoint> top, side;
  for (const ContactPoint& p : points_of(object, table())) {
    if (p.normal.z() > 1 - 1e-6) top.push_back(p);
    if (p.normal.x() > 1 - 1e-6) side.push_back(p);
  }
  const auto contact = [&](const std::vector<ContactPoint>& points) {
    return make_contact(points, object.body, nullptr, test::kExtent);
  };
  ASSERT_FALSE(top.empty());
  EXPECT_NEAR(area_of(contact(top).hull), 0.5 * 0.4, 1e-5);
  ASSERT_FALSE(side.empty());
  double low = 0;
  for (const ContactPoint& p : side) low = std::min(low, p.point.z());
  EXPECT_NEAR(low, -0.3, 1e-5);
}

// Bricks with sides in one plane: a side that nearly touches the other's side from below is no
// contact, however small the gap and however the rounding of the sides falls.
TEST(ContactPatches, BricksWithSidesInOnePlaneTouchOnTopOnly) {
  test::Random random(46);
  int num_points = 0;
  for (int i = 0; i < 300; ++i) {
    const Rotation turn = i % 10 ? random.rotation() : Rotation{};
    const double gap = std::pow(10.0, random.uniform(-9, -5.8));
    const Vec3 shift(random.uniform(0.1, 0.9), 0, 0.25 + gap);
    const Posed lower = box(Vec3(0.5, 0.25, 0.125), Vec3::Zero(), turn);
    const Posed upper = box(Vec3(0.5, 0.25, 0.125), turn.matrix() * shift, turn);
    const auto points = points_of(upper, lower);
    EXPECT_FALSE(points.empty());
    const Vec3 up = turn.matrix() * Vec3::UnitZ();
    for (const ContactPoint& p : points) EXPECT_GT(p.normal.dot(up), 1 - 1e-6) << gap;
    num_points += static_cast<int>(points.size());
    const Contact c = contact_of(upper, lower);
    EXPECT_EQ(c.type, ContactType::Area);
  }
  EXPECT_GT(num_points, 4 * 300);
}

}  // namespace
}  // namespace trivet
