// Contact points of known arrangements.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "contact_testing.h"
#include "core/contact/triangle_distance.h"
#include "core/index/shape_index.h"
#include "support/effort.h"
#include "support/random_queries.h"

namespace trivet {
namespace {

using test::about, test::area_of, test::box, test::contact_of, test::expect_normals,
    test::points_of, test::Posed, test::table, test::kEps, test::kSlack, test::kTolerance;

/// Each of `expected` (in order) is within 2 clearances of a corner of the hull. Rounding may add
/// others on its sides, where edges meet the diagonal of a face.
void expect_hull(const Contact& contact, const std::vector<Vec3>& expected) {
  EXPECT_GE(contact.hull.size(), expected.size());
  EXPECT_NEAR(area_of(contact.hull), area_of(expected), 10 * kTolerance);
  for (const Vec3& e : expected) {
    double nearest = kInfinity;
    for (const Vec3& h : contact.hull) nearest = std::min(nearest, (h - e).norm());
    EXPECT_LT(nearest, kTolerance) << e.transpose();
  }
}

TEST(ContactPoints, BoxOnBoxGivesAreaOfFourCorners) {
  const Posed object = box(Vec3(0.3, 0.2, 0.1), Vec3(0.1, 0.2, 0.1 + kEps)), support = table();
  const Contact c = contact_of(object, support);
  EXPECT_EQ(c.type, ContactType::Area);
  expect_hull(c, {{-0.2, 0, 0}, {0.4, 0, 0}, {0.4, 0.4, 0}, {-0.2, 0.4, 0}});
  expect_normals(c.points, Vec3::UnitZ());
  EXPECT_NEAR(c.gap, kEps, 1e-15);
  EXPECT_LT((c.normal - Vec3::UnitZ()).norm(), 1e-12);
  // The two faces of the bottom, and the two of the table's top.
  for (const Index f : {0, 1})
    EXPECT_TRUE(std::binary_search(c.faces_object.begin(), c.faces_object.end(), f));
  EXPECT_TRUE(std::is_sorted(c.faces_support.begin(), c.faces_support.end()));
  EXPECT_FALSE(c.faces_support.empty());
  for (const Index f : c.faces_support) EXPECT_TRUE(f == 2 || f == 3);
}

TEST(ContactPoints, AreEmptyBeyondTolerance) {
  EXPECT_TRUE(
      points_of(box(Vec3(0.3, 0.2, 0.1), Vec3(0, 0, 0.1 + 1.01 * kTolerance)), table()).empty());
  EXPECT_FALSE(
      points_of(box(Vec3(0.3, 0.2, 0.1), Vec3(0, 0, 0.1 + 0.99 * kTolerance)), table()).empty());
}

TEST(ContactPoints, SquareTurnedByEighthGivesOctagon) {
  const Posed object = box(Vec3(1, 1, 0.1), Vec3(0, 0, 0.1 + kEps), about(Vec3::UnitZ(), M_PI / 4));
  const Contact c = contact_of(object, table());
  EXPECT_EQ(c.type, ContactType::Area);
  const double k = std::sqrt(2.0) - 1;
  expect_hull(c, {{1, k, 0},
                  {k, 1, 0},
                  {-k, 1, 0},
                  {-1, k, 0},
                  {-1, -k, 0},
                  {-k, -1, 0},
                  {k, -1, 0},
                  {1, -k, 0}});
  expect_normals(c.points, Vec3::UnitZ());
}

TEST(ContactPoints, BoxOverTableEdgeGivesOverlap) {
  const Contact c = contact_of(box(Vec3(0.5, 0.2, 0.1), Vec3(0.9, 0, 0.1 + kEps)), table());
  EXPECT_EQ(c.type, ContactType::Area);
  expect_hull(c, {{0.4, -0.2, 0}, {1, -0.2, 0}, {1, 0.2, 0}, {0.4, 0.2, 0}});
  expect_normals(c.points, Vec3::UnitZ());
}

TEST(ContactPoints, BoxOnEdgeGivesLine) {
  const double r = std::sqrt(0.5);
  const Posed object =
      box(Vec3(0.5, 0.4, 0.5), Vec3(0, 0, r + kEps), about(Vec3::UnitY(), M_PI / 4));
  const Contact c = contact_of(object, table());
  EXPECT_EQ(c.type, ContactType::Line);
  // The ends, and possibly, by rounding, the crossing with the diagonal of the top.
  double low = 0, high = 0;
  for (const Vec3& h : c.hull) {
    EXPECT_NEAR(h.x(), 0, 1e-15);
    low = std::min(low, h.y());
    high = std::max(high, h.y());
  }
  EXPECT_NEAR(low, -0.4, 1e-15);
  EXPECT_NEAR(high, 0.4, 1e-15);
  expect_normals(c.points, Vec3::UnitZ());
}

TEST(ContactPoints, CrossedRodsGivePointBetweenEdges) {
  const double r = std::sqrt(0.02);
  const Posed below = box(Vec3(2, 0.1, 0.1), Vec3(0.3, 0, -r), about(Vec3::UnitX(), M_PI / 4));
  const Posed above =
      box(Vec3(0.1, 2, 0.1), Vec3(0, 0.5, r + kEps), about(Vec3::UnitY(), M_PI / 4));
  const Contact c = contact_of(above, below);
  ASSERT_EQ(c.points.size(), 1u);
  EXPECT_EQ(c.type, ContactType::Point);
  EXPECT_EQ(c.points[0].features, ContactFeatures::EdgeEdge);
  EXPECT_LT((c.points[0].point - Vec3(0, 0, 0.5 * kEps)).norm(), 1e-14);
  expect_normals(c.points, Vec3::UnitZ());
  EXPECT_NEAR(c.gap, kEps, 1e-14);
  EXPECT_EQ(c.faces_object.size(), 2u);
  EXPECT_EQ(c.faces_support.size(), 2u);
}

TEST(ContactPoints, SphereTouchesFloorAndTable) {
  const Posed sphere(test::bumpy_sphere(12, 16, 0, 1), Vec3(0.2, 0.3, 1 + kEps));
  const auto on_floor = floor_contact_points(sphere.body, kTolerance);
  ASSERT_EQ(on_floor.size(), 1u);
  EXPECT_EQ(on_floor[0].features, ContactFeatures::VertexFace);
  EXPECT_EQ(on_floor[0].normal, Vec3::UnitZ());
  EXPECT_NEAR(on_floor[0].gap, kEps, 1e-15);
  EXPECT_LT((on_floor[0].point - Vec3(0.2, 0.3, kEps)).norm(), 1e-15);
  const Contact c = contact_of(sphere, table());
  ASSERT_EQ(c.points.size(), 1u);
  EXPECT_EQ(c.type, ContactType::Point);
  EXPECT_EQ(c.points[0].features, ContactFeatures::VertexFace);
  expect_normals(c.points, Vec3::UnitZ());
}

TEST(ContactPoints, TableOnSphereNamesItsOwnFace) {
  const Posed sphere(test::bumpy_sphere(12, 16, 0, 1), Vec3(0.2, 0.3, -1 - kEps));
  const Posed slab = box(Vec3(1, 1, 0.1), Vec3(0, 0, 0.1));
  const auto points = points_of(slab, sphere);
  ASSERT_FALSE(points.empty());
  for (const ContactPoint& p : points) EXPECT_EQ(p.features, ContactFeatures::FaceVertex);
  expect_normals(points, Vec3::UnitZ());
  EXPECT_LT((points[0].point - Vec3(0.2, 0.3, -kEps)).norm(), 1e-15);  // the vertex
}

std::vector<Triangle> pyramid() {  // tip at the origin, pointing down
  const Vec3 tip(0, 0, 0), a(1, 0, 2), b(-1, 1, 2), c(-1, -1, 2);
  return {{tip, b, a}, {tip, c, b}, {tip, a, c}, {a, b, c}};
}

TEST(ContactPoints, TipTouchesTip) {
  const Posed above(pyramid(), Vec3(0, 0, kEps));
  const Posed below(pyramid(), Vec3::Zero(), about(Vec3::UnitX(), M_PI - 1e-9));
  const Contact c = contact_of(above, below);
  ASSERT_EQ(c.points.size(), 1u);
  EXPECT_EQ(c.type, ContactType::Point);
  EXPECT_EQ(c.points[0].features, ContactFeatures::ClosestPoints);
  EXPECT_LT((c.points[0].normal - Vec3::UnitZ()).norm(), 1e-6);
  EXPECT_NEAR(c.gap, kEps, 1e-12);
  EXPECT_LT(c.points[0].point.norm(), kTolerance);  // either tip
}

TEST(ContactPoints, VertexNearDiagonalOfFlatQuadHasOnlyQuadNormal) {
  // The tip's edges pass over the diagonal, which is an edge of the mesh but not of the surface.
  for (const double off : {0.0, 1e-9, 1e-7, 1e-6, 1e-4}) {
    for (const double turn : {0.0, 0.3, 1.2, 2.0}) {
      const Posed tip(pyramid(), Vec3(0.2 + off, 0.2, kEps), about(Vec3::UnitZ(), turn));
      const auto points = points_of(tip, table());
      EXPECT_FALSE(points.empty());
      expect_normals(points, Vec3::UnitZ());
      EXPECT_EQ(merged(points, kTolerance).size(), 1u);
    }
  }
}

TEST(ContactPoints, VertexBesideTableEdgeTouchesIt) {
  // Less than the slack beside the edge: over the face. By more: the closest points.
  const auto normal_at = [](double beside) {
    const Posed tip(pyramid(), Vec3(1 + beside, 0.1, 0.8 * kEps));
    const auto points = points_of(tip, table());
    EXPECT_FALSE(points.empty());
    return points.empty() ? Vec3::Zero().eval() : points[0].normal;
  };
  EXPECT_LT((normal_at(0.5 * kSlack) - Vec3::UnitZ()).norm(), 1e-9);
  EXPECT_LT((normal_at(0.6 * kEps) - Vec3(0.6, 0, 0.8)).norm(), 1e-6);
}

TEST(ContactPoints, VertexThatGoesOnDownwardsBesideEdgeTouchesIt) {
  // Its foot is within the slack of the table's top, past the edge, where its own faces go on
  // down: it touches the edge. The edge belongs to the top or to the side, as the table is turned.
  const double h = kEps, beside = std::min(0.5 * kSlack, 0.03 * h);
  const Vec3 tip(1 + beside, 0.1, h), a = tip + Vec3(0.1, 0.3, -0.001),
                                      b = tip + Vec3(-0.1, 0, 0.1);
  const Vec3 c = tip + Vec3(0.1, -0.3, -0.001);
  for (const double turn : {0.0, 0.5, 1.0, 1.5}) {
    const Rotation about_z = about(Vec3::UnitZ(), M_PI * turn);
    const auto world = [&](const Vec3& p) { return Vec3(about_z.matrix() * p); };
    const Posed object({{world(tip), world(a), world(b)},
                        {world(tip), world(b), world(c)},
                        {world(tip), world(c), world(a)}},
                       Vec3::Zero());
    const auto points = points_of(object, table());
    const Vec3 normal = world(Vec3(beside, 0, h).normalized());
    EXPECT_TRUE(std::any_of(points.begin(), points.end(),
                            [&](const ContactPoint& p) {
                              return (p.normal - normal).norm() < 1e-3 &&
                                     (p.point - world(tip)).norm() < 2 * h;
                            }))
        << turn << " half turns, " << points.size() << " points";
  }
}

TEST(ContactPoints, ParallelEdgesGiveLine) {
  // The edges face each other at 37 degrees: neither is over a face of the other, nor do they
  // cross.
  for (const double half : {0.4, 1.0, 1.7})
    for (const double shift : {0.0, 0.1, 0.5}) {
      const Posed object =
          box(Vec3(0.3, half, 0.2), Vec3(1.3 + 0.6 * kEps, shift, 0.2 + 0.8 * kEps));
      const Contact c = contact_of(object, table());
      EXPECT_EQ(c.type, ContactType::Line);
      expect_normals(c.points, Vec3(0.6, 0, 0.8));
      double low = kInfinity, high = -kInfinity;
      for (const ContactPoint& p : c.points) {
        low = std::min(low, p.point.y());
        high = std::max(high, p.point.y());
      }
      EXPECT_NEAR(low, std::max(-1.0, shift - half), 1e-12);
      EXPECT_NEAR(high, std::min(1.0, shift + half), 1e-12);
    }
}

TEST(ContactPoints, KeepsParallelEdgesBesideCorners) {
  std::vector<Triangle> two_tables = test::box_triangles(Vec3(1, 1, 0.5));
  for (Triangle t : test::box_triangles(Vec3(1, 1, 0.5))) {
    for (Vec3& p : t) p += Vec3(2.4, 0, 0);
    two_tables.push_back(t);
  }
  const Posed support(two_tables, Vec3(0, 0, -0.5));
  const Posed object = box(Vec3(0.3, 0.4, 0.2), Vec3(1.3 + 0.6 * kEps, 0, 0.2 + 0.8 * kEps));
  int num_left = 0, num_right = 0;
  for (const ContactPoint& p : points_of(object, support))
    ++(p.point.x() < 1.2 ? num_left : num_right);
  EXPECT_GE(num_right, 2);
  EXPECT_GE(num_left, 2);
}

TEST(ContactPoints, FlushBoxesTouchInWholeFace) {
  for (const double off : {0.0, 0.9 * kSlack, -0.9 * kSlack, 5 * kEps, -5 * kEps}) {
    const Posed object = box(Vec3(1, 1, 0.3), Vec3(off, 0, 0.3 + kEps));
    const Contact c = contact_of(object, table());
    EXPECT_EQ(c.type, ContactType::Area) << off;
    expect_normals(c.points, Vec3::UnitZ());
    EXPECT_GE(c.hull.size(), 4u);
    for (const Vec3& corner : {Vec3(1, 1, 0), Vec3(1, -1, 0), Vec3(-1, 1, 0), Vec3(-1, -1, 0)}) {
      double nearest = kInfinity;
      for (const Vec3& h : c.hull) nearest = std::min(nearest, (h - corner).norm());
      EXPECT_LT(nearest, 10 * kEps) << off;
    }
  }
}

/// Each triangle in four, and the middle one in three.
std::vector<Triangle> split(const std::vector<Triangle>& triangles) {
  std::vector<Triangle> out;
  for (const auto& [a, b, c] : triangles) {
    const Vec3 ab = 0.5 * (a + b), bc = 0.5 * (b + c), ca = 0.5 * (c + a), m = (ab + bc + ca) / 3;
    for (const Triangle& t : {Triangle{a, ab, ca}, Triangle{ab, b, bc}, Triangle{ca, bc, c},
                              Triangle{ab, bc, m}, Triangle{bc, ca, m}, Triangle{ca, ab, m}})
      out.push_back(t);
  }
  return out;
}

// The sides of both boxes lie in one plane, or nearly, and the boxes lie on each other: no contact
// may push sideways, as opposite ones would hold the upper box like a pair of tongs.
void expect_upward_contacts(const std::vector<Triangle>& upper_box,
                            const std::vector<Triangle>& lower_box) {
  for (const Rotation& turn : {Rotation(), about(Vec3::UnitZ(), 0.3), about(Vec3(0.6, 0, 0.8), 1)})
    for (const double gap : {0.0, 1e-17, 1e-12, kEps})
      for (const double aside : {0.0, 1e-12, 1e-7, -1e-7})
        for (const double x : {0.0, 0.03, 0.05, 0.15, 0.199}) {
          SCOPED_TRACE(testing::Message()
                       << "gap " << gap << ", shifted by " << x << " and " << aside);
          const Mat3 m = turn.matrix();
          const Vec3 at(x, aside, 0.3 + gap), up = m * Vec3::UnitZ();
          const Posed upper(upper_box, m * at, turn), lower(lower_box, m * Vec3(0, 0, 0.1), turn);
          const Contact c = contact_of(upper, lower);
          EXPECT_EQ(c.type, ContactType::Area);
          expect_normals(c.points, up);
          expect_normals(contact_of(lower, upper).points, -up);
        }
}

TEST(ContactPoints, BoxesWithSidesInOnePlaneTouchUpwardsOnly) {
  const auto plain = test::box_triangles(Vec3::Constant(0.1)), fine = split(split(plain));
  expect_upward_contacts(plain, plain);
  expect_upward_contacts(fine, plain);
  expect_upward_contacts(plain, fine);
  expect_upward_contacts(fine, fine);
}

TEST(ContactPoints, BoxBetweenWallAndFloorHasOneNormalForEach) {
  const Posed wall = box(Vec3(0.1, 1, 1), Vec3(-0.1, 0, 1));
  const Posed object = box(Vec3(0.2, 0.3, 0.2), Vec3(0.2 + kEps, 0, 0.2 + kEps));
  expect_normals(points_of(object, wall), Vec3::UnitX());
  EXPECT_EQ(contact_of(object, wall).type, ContactType::Area);
  EXPECT_EQ(floor_contact_points(object.body, kTolerance).size(), 4u);
}

TEST(ContactPoints, BoxInVTouchesBothSlopes) {
  // One solid with a right-angled notch along y; a box with an edge down lies in it.
  const double r = std::sqrt(0.5);
  std::vector<Triangle> notch;
  test::add_quad(notch, Vec3(0, -1, 0), Vec3(0, 1, 0), Vec3(-1, 1, 1), Vec3(-1, -1, 1));
  test::add_quad(notch, Vec3(0, 1, 0), Vec3(0, -1, 0), Vec3(1, -1, 1), Vec3(1, 1, 1));
  const Posed support(notch, Vec3::Zero());
  const Posed object = box(Vec3(0.2, 0.5, 0.2), Vec3(0, 0, std::sqrt(0.08) + kEps / r),
                           about(Vec3::UnitY(), M_PI / 4));
  int left = 0, right = 0;
  for (const ContactPoint& p : points_of(object, support)) {
    left += (p.normal - Vec3(r, 0, r)).norm() < 1e-6;
    right += (p.normal - Vec3(-r, 0, r)).norm() < 1e-6;
  }
  EXPECT_GE(left, 4);
  EXPECT_GE(right, 4);
}

}  // namespace
}  // namespace trivet
