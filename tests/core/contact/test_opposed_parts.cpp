// Contacts are the same whether faces that do not face each other are asked or not.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "contact_testing.h"
#include "core/contact/opposed_parts.h"
#include "support/effort.h"
#include "support/random_queries.h"

namespace trivet {
namespace {

bool same_bits(const ContactPoint& p, const ContactPoint& q) {
  return p.point == q.point && p.normal == q.normal && p.gap == q.gap && p.features == q.features &&
         p.feature_object == q.feature_object && p.feature_support == q.feature_support;
}

class WideContacts {
 public:
  void compare(const Body& a, const Body& b, double tolerance, double slack) {
    const auto all = contact_points_of_all_faces(a, b, tolerance, slack);
    const auto fast = contact_points(a, b, tolerance, slack);
    EXPECT_TRUE(std::equal(all.begin(), all.end(), fast.begin(), fast.end(), same_bits))
        << all.size() << " points, by cones " << fast.size();
    num_points += all.size();
    num_held += OpposedParts::hold(a, b, slack);
    ++num_asked;
  }

  size_t num_points = 0;
  int num_held = 0, num_asked = 0;
};

TEST(OpposedParts, HaveNoContacts) {
  constexpr unsigned kSeed = 48;
  const test::MeshPool pool(kSeed, 16);
  WideContacts contacts;
  test::Random random(kSeed);
  for (int i = 0; i < test::with_effort(4000); ++i) {
    test::RandomQuery q = test::random_query(pool, kSeed, i);
    const Body b = q.fixed[0].body();
    // Every second one is beside the other, or in it.
    if (i % 2 == 0)
      q.moving[0].pose.translation +=
          b.world_box.centre() - q.moving[0].body().world_box.centre() +
          random.uniform(0, 1) * b.world_box.diagonal() * random.direction();
    const Body a = q.moving[0].body();
    normal_cones_of(*a.shape), normal_cones_of(*b.shape);
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", query " + std::to_string(i) + ": " +
                 q.describe());
    const double eps = q.clearance.distance;
    contacts.compare(a, b, std::pow(10.0, random.uniform(-3, 0)), kFootSlack * eps);
    contacts.compare(a, b, kContactTolerance * eps, kFootSlack * eps);
    if (::testing::Test::HasFailure()) return;
  }
  std::printf("seed %u: %zu points, cones hold of %d of %d\n", kSeed, contacts.num_points,
              contacts.num_held, contacts.num_asked);
  EXPECT_GT(contacts.num_held, contacts.num_asked / 2);
  EXPECT_GT(contacts.num_points, contacts.num_asked / 2u);
}

// Finer meshes beside each other, in each other, and on flat sides.
TEST(OpposedParts, OfRoundThingsHaveNoContacts) {
  WideContacts contacts;
  test::Random random(49);
  for (int i = 0; i < test::with_effort(20); ++i) {
    const auto round = test::shape_of(test::bumpy_sphere(8, 16, 0.3 * (i % 3), 50 + i));
    const auto hilly = test::shape_of(test::terrain(12, 2, 0.3, 70 + i));
    const auto cube = test::shape_of(test::box_triangles(Vec3(0.5, 0.7, 0.9)));
    for (const auto& other : {round, hilly, cube}) {
      const Vec3 at = random.uniform(0, 2.4) * random.direction();
      const Rotation turn = i % 2 == 0 ? Rotation{} : random.rotation();
      const Body a(*round, test::placed(turn, at)), b(*other, test::placed({}, Vec3(0, 0, 0)));
      for (const double tolerance : {0.01, 0.3}) contacts.compare(a, b, tolerance, 1e-6);
      if (::testing::Test::HasFailure()) return;
    }
  }
  EXPECT_EQ(contacts.num_held, contacts.num_asked);
  EXPECT_GT(contacts.num_points, 3u * contacts.num_asked);
}

TEST(OpposedParts, AreNotToldWhereRoundingIsLarge) {
  const test::Posed near = test::box(Vec3(1, 1, 1), Vec3(0, 0, 0));
  const test::Posed far = test::box(Vec3(1, 1, 1), Vec3(1e6, 0, 0));
  EXPECT_TRUE(OpposedParts::hold(near.body, near.body, 1e-6));
  EXPECT_FALSE(OpposedParts::hold(near.body, far.body, 1e-6));
  EXPECT_FALSE(OpposedParts::hold(near.body, near.body, 0));
  EXPECT_FALSE(OpposedParts::hold(near.body, near.body, 0.01));
}

}  // namespace
}  // namespace trivet
