// Contact points: known arrangements, and properties on random bodies brought into contact by a
// motion.

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
  // Beside the edge by less than the slack: over the face. By more: the closest points.
  const auto normal_at = [](double beside) {
    const Posed tip(pyramid(), Vec3(1 + beside, 0.1, 0.8 * kEps));
    const auto points = points_of(tip, table());
    EXPECT_FALSE(points.empty());
    return points.empty() ? Vec3::Zero().eval() : points[0].normal;
  };
  EXPECT_LT((normal_at(0.5 * kSlack) - Vec3::UnitZ()).norm(), 1e-9);
  EXPECT_LT((normal_at(0.6 * kEps) - Vec3(0.6, 0, 0.8)).norm(), 1e-6);
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

// --- random bodies ---------------------------------------------------------------------------

double distance_of(const Body& a, const Body& b) {
  double out = kInfinity;
  for (Index i = 0; i < static_cast<Index>(a.shape->mesh.triangles.size()); ++i)
    for (Index j = 0; j < static_cast<Index>(b.shape->mesh.triangles.size()); ++j)
      out = std::min(out, closest_points(a.triangle(i), b.triangle(j)).distance);
  return out;
}

double distance_of(const Vec3& p, const Body& b) {
  double out = kInfinity;
  for (Index j = 0; j < static_cast<Index>(b.shape->mesh.triangles.size()); ++j)
    out = std::min(out, closest_points({p, p, p}, b.triangle(j)).distance);
  return out;
}

TEST(ContactPoints, LieOnBothBodiesWhereverTheyAreNear) {
  constexpr unsigned kSeed = 41;
  const test::MeshPool pool(kSeed, 16);
  int num_near = 0, num_points = 0, num_missing = 0;
  const int num_queries = test::with_effort(6000);
  for (int i = 0; i < num_queries; i += 3) {  // each third starts in contact
    const test::RandomQuery q = test::random_query(pool, kSeed, i);
    const Body a = q.moving[0].body(), b = q.fixed[0].body();
    const double eps = q.clearance.distance, tolerance = kContactTolerance * eps;
    const double distance = distance_of(a, b);
    if (distance < 1e-12) continue;
    const auto points = contact_points(a, b, tolerance, kFootSlack * eps);
    num_points += static_cast<int>(points.size());
    for (const ContactPoint& p : points) {
      EXPECT_LE(p.gap, tolerance);
      EXPECT_NEAR(p.normal.norm(), 1, 1e-8);
      EXPECT_LE(distance_of(p.point, a), 1.1 * tolerance) << "seed " << kSeed << ", query " << i;
      EXPECT_LE(distance_of(p.point, b), 1.1 * tolerance) << "seed " << kSeed << ", query " << i;
    }
    if (distance > tolerance) {
      EXPECT_TRUE(points.empty());
    } else if (distance < 0.99 * tolerance) {
      ++num_near;
      num_missing += points.empty();
      EXPECT_FALSE(points.empty()) << "seed " << kSeed << ", query " << i << ", distance "
                                   << distance << ", clearance " << eps << ": " << q.describe();
    }
  }
  std::printf("seed %u: %d of %d pairs near, %d points\n", kSeed, num_near, num_queries / 3,
              num_points);
  EXPECT_GT(num_near, 0.3 * num_queries / 3);
}

/// The same shape, but nothing is pruned by slabs.
std::shared_ptr<const Shape> without_slabs(const Shape& shape) {
  auto out = make_shape(shape.mesh);
  out->index->bvh.get([&] {
    Bvh bvh = build_bvh(shape.mesh);
    for (BvhSlab& slab : bvh.slabs) slab = {};
    return bvh;
  });
  return out;
}

TEST(ContactPoints, AreNotLostBySlabs) {
  constexpr unsigned kSeed = 43;
  const test::MeshPool pool(kSeed, 16);
  size_t num_points = 0;
  for (int i = 0; i < test::with_effort(6000); i += 3) {
    const test::RandomQuery q = test::random_query(pool, kSeed, i);
    const Body a = q.moving[0].body(), b = q.fixed[0].body();
    const auto shape_a = without_slabs(*a.shape), shape_b = without_slabs(*b.shape);
    const double eps = q.clearance.distance, tolerance = kContactTolerance * eps;
    const auto with = contact_points(a, b, tolerance, kFootSlack * eps);
    const auto without =
        contact_points({*shape_a, a.world_from_object}, {*shape_b, b.world_from_object}, tolerance,
                       kFootSlack * eps);
    ASSERT_EQ(with.size(), without.size()) << "seed " << kSeed << ", query " << i;
    num_points += with.size();
    for (size_t k = 0; k < with.size(); ++k)
      EXPECT_TRUE(with[k].point == without[k].point && with[k].normal == without[k].normal &&
                  with[k].gap == without[k].gap)
          << "seed " << kSeed << ", query " << i;
  }
  EXPECT_GT(num_points, 500u * test::with_effort(6000) / 6000);
}

bool same(const ContactPoint& p, const ContactPoint& q) {
  return p.point == q.point && p.normal == q.normal && p.gap == q.gap && p.features == q.features &&
         p.feature_object == q.feature_object && p.feature_support == q.feature_support;
}

bool same(const std::vector<ContactPoint>& a, const std::vector<ContactPoint>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const ContactPoint& p, const ContactPoint& q) { return same(p, q); });
}

bool same(const Contact& a, const Contact& b) {
  return a.type == b.type && same(a.points, b.points) && a.hull == b.hull && a.normal == b.normal &&
         a.gap == b.gap && a.faces_object == b.faces_object && a.faces_support == b.faces_support;
}

// To the bit, whoever asks; also of bodies of the same shape.
TEST(ContactPoints, AreTheSameFromBothSides) {
  constexpr unsigned kSeed = 42;
  const test::MeshPool pool(kSeed, 16);
  int num_pairs = 0, num_swapped = 0;
  for (int i = 0; i < test::with_effort(3000); i += 3) {
    const test::RandomQuery q = test::random_query(pool, kSeed, i);
    if (!q.starts_near) continue;
    const Body a = q.moving[0].body(), b = q.fixed[0].body();
    const double eps = q.clearance.distance;
    const auto ab = contact_points(a, b, kContactTolerance * eps, kFootSlack * eps);
    std::vector<ContactPoint> turned;
    turned.reserve(ab.size());
    for (const ContactPoint& p : contact_points(b, a, kContactTolerance * eps, kFootSlack * eps))
      turned.push_back(seen_from_support(p));
    EXPECT_TRUE(same(ab, turned)) << "seed " << kSeed << ", query " << i;
    if (ab.empty()) continue;
    ++num_pairs;
    num_swapped += comes_first(b, a);
    EXPECT_NE(comes_first(a, b), comes_first(b, a));
    std::vector<ContactPoint> of_b;
    of_b.reserve(ab.size());
    for (const ContactPoint& p : ab) of_b.push_back(seen_from_support(p));
    EXPECT_TRUE(
        same(make_contact(ab, a, &b, eps), seen_from_support(make_contact(of_b, b, &a, eps))))
        << "seed " << kSeed << ", query " << i;
  }
  EXPECT_GT(num_swapped, num_pairs / 10);
  EXPECT_GT(num_pairs - num_swapped, num_pairs / 10);
}

TEST(ContactPoints, OfTheSameShapeAreFoundFromTheLeftOne) {
  const Vec3 origin(0, 0, 0);
  const Posed one = box(Vec3(0.5, 0.5, 0.5), origin), other = box(Vec3(0.5, 0.5, 0.4), origin);
  const Body moved(*one.shape, test::placed({}, Vec3(1, 0, 0)));
  EXPECT_TRUE(comes_first(one.body, moved));
  EXPECT_FALSE(comes_first(moved, one.body));
  EXPECT_FALSE(comes_first(one.body, one.body));
  EXPECT_NE(comes_first(one.body, other.body), comes_first(other.body, one.body));
}

TEST(ContactPoints, WithFloorAreAllLowVertices) {
  test::Random random(43);
  const test::MeshPool pool(43, 8);
  int num_points = 0;
  for (int i = 0; i < 2000; ++i) {
    const auto& shape = pool.pick(static_cast<test::MeshKind>(i % test::kNumMeshKinds), random);
    const Body body(*shape, test::placed(random.rotation(), Vec3(0, 0, random.uniform(-1, 1))));
    const double tolerance = std::pow(10.0, random.uniform(-3, 0));
    std::vector<Index> expected, found;
    for (Index v = 0; v < static_cast<Index>(shape->mesh.vertices.size()); ++v)
      if (body.vertex(v).z() <= tolerance) expected.push_back(v);
    for (const ContactPoint& p : floor_contact_points(body, tolerance))
      found.push_back(p.feature_object);
    EXPECT_EQ(found, expected);
    num_points += static_cast<int>(found.size());
  }
  EXPECT_GT(num_points, 2000);
}

}  // namespace
}  // namespace trivet
