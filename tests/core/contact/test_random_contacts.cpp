// Contact points of random bodies that a motion brought into contact.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <future>
#include <utility>

#include "contact_testing.h"
#include "core/contact/contact_memory.h"
#include "core/contact/triangle_distance.h"
#include "core/index/shape_index.h"
#include "support/effort.h"
#include "support/random_queries.h"

namespace trivet {
namespace {

using test::box, test::Posed;

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

bool same_points(const std::vector<ContactPoint>& a, const std::vector<ContactPoint>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const ContactPoint& x, const ContactPoint& y) {
                      return x.point == y.point && x.normal == y.normal && x.gap == y.gap &&
                             x.features == y.features && x.feature_object == y.feature_object &&
                             x.feature_support == y.feature_support;
                    });
}

// From either side, at each tolerance, and at another pose.
TEST(ContactMemory, GivesThePointsThatAreFoundWithout) {
  constexpr unsigned kSeed = 43;
  const test::MeshPool pool(kSeed, 16);
  EXPECT_EQ(ContactMemory::current(), nullptr);
  ContactMemory memory;
  {
    const ContactMemory inner;
    EXPECT_EQ(ContactMemory::current(), &memory);
  }
  size_t num_points = 0, num_asked = 0;
  for (int i = 0; i < 3000; i += 3) {
    test::RandomQuery q = test::random_query(pool, kSeed, i);
    for (const double shift : {0.0, 1e-9}) {
      q.moving[0].pose.translation.x() += shift;
      const Body a = q.moving[0].body(), b = q.fixed[0].body();
      const double eps = q.clearance.distance, slack = kFootSlack * eps;
      for (const double tolerance : {kContactTolerance * eps, kBalanceTolerance * eps}) {
        const auto ask = [&](const Body& x, const Body& y) {
          return contact_points(x, y, tolerance, slack);
        };
        const auto first = ask(a, b), other = ask(b, a), again = ask(a, b);
        EXPECT_TRUE(same_points(again, first)) << i;
        EXPECT_EQ(other.size(), first.size()) << i;
        // Another thread remembers nothing.
        const auto [alone, alone_other] =
            std::async(std::launch::async, [&] { return std::pair(ask(a, b), ask(b, a)); }).get();
        EXPECT_TRUE(same_points(alone, first) && same_points(alone_other, other)) << i;
        num_points += first.size();
        ++num_asked;
      }
    }
  }
  EXPECT_GT(num_points, 1000u);
  EXPECT_GT(memory.num_remembered(), num_asked / 4);
  EXPECT_LE(memory.num_remembered(), num_asked);
}

// A cube where a smaller one was, in memory, too.
TEST(ContactMemory, TellsAShapeFromThatWhichWasThereBefore) {
  const Posed below = box(Vec3(1, 1, 1), Vec3(0, 0, -1));
  Shape place = *box(Vec3(0.4, 0.4, 0.5), Vec3(0, 0, 0)).shape;
  const Body body(place, test::placed({}, Vec3(0, 0, 0.5)));
  const ContactMemory memory;
  const auto widest = [&] {
    double out = 0;
    for (const ContactPoint& p : contact_points(body, below.body, 1e-3, 1e-3))
      out = std::max(out, p.point.x());
    return out;
  };
  EXPECT_NEAR(widest(), 0.4, 1e-12);
  place = *box(Vec3(0.2, 0.4, 0.5), Vec3(0, 0, 0)).shape;
  EXPECT_NEAR(widest(), 0.2, 1e-12);
}

}  // namespace
}  // namespace trivet
