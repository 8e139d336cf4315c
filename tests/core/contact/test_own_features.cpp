// Contacts of features that belong to one face each, beside those of all faces that share them.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <tuple>

#include "contact_testing.h"
#include "core/contact/feature_contacts.h"
#include "support/effort.h"
#include "support/random_shapes.h"

namespace trivet {
namespace {

constexpr double kRoundingOfPoints = 1e-9;  // metres, more than rounding

using PairOfFeatures = std::tuple<ContactFeatures, Index, Index>;

PairOfFeatures pair_of(const ContactPoint& p) {
  return {p.features, p.feature_object, p.feature_support};
}

/// Every pair of faces tries all of its features, and whatever it finds several times is the same.
struct AllFaces {
  std::map<PairOfFeatures, std::vector<ContactPoint>> found;
  std::vector<ContactPoint> ends;

  AllFaces(const Body& a, const Body& b, double tolerance, double slack) {
    FeatureContacts contacts(a, b, tolerance, 1.001 * tolerance, slack);
    for (Index i = 0; i < static_cast<Index>(a.shape->mesh.triangles.size()); ++i)
      for (Index j = 0; j < static_cast<Index>(b.shape->mesh.triangles.size()); ++j)
        contacts.add(ContactFace(PlainFace(a.triangle(i))), i,
                     ContactFace(PlainFace(b.triangle(j))), j, existing(a, i, b, j));
    for (const ContactPoint& p : contacts.found()) found[pair_of(p)].push_back(p);
    ends = contacts.ends_and_corners();
  }

  // A face with two equal corners has no edge between them.
  static FacingFeatures existing(const Body& a, Index i, const Body& b, Index j) {
    FacingFeatures out;
    for (size_t k = 0; k < 3; ++k) {
      out.a.vertices[k] = out.b.vertices[k] = true;
      out.a.edges[k] = a.shape->adjacency.face_edges[i][k] >= 0;
      out.b.edges[k] = b.shape->adjacency.face_edges[j][k] >= 0;
    }
    return out;
  }
};

bool are_the_same(const ContactPoint& p, const ContactPoint& q) {
  return (p.point - q.point).norm() < kRoundingOfPoints && p.normal.dot(q.normal) > 1 - 1e-9;
}

std::shared_ptr<const Shape> random_shape(test::Random& random, int i) {
  if (i % 3 == 0) return test::shape_of(test::soup(12, i % 5, random));
  if (i % 3 == 1) return test::shape_of(test::box_triangles(random.in_cube(0.5).cwiseAbs()));
  return test::shape_of(test::bumpy_sphere(5, 8, 0.3, static_cast<unsigned>(i)));
}

TEST(OwnFeatures, GiveAllContactsOfAllFaces) {
  test::Random random(31);
  int num_found = 0, num_shared = 0, num_ends = 0;
  const int num = test::with_effort(1500);
  for (int i = 0; i < num; ++i) {
    const auto of_a = random_shape(random, i), of_b = random_shape(random, i / 3);
    Body a(*of_a, world_from_object({random.rotation(), random.in_cube(0.8)}, UpAxis::Z, 1));
    Body b(*of_b, world_from_object({random.rotation(), random.in_cube(0.8)}, UpAxis::Z, 1));
    if (comes_first(b, a)) std::swap(a, b);
    const double tolerance = i % 2 == 0 ? 0.3 : 0.03,
                 slack = (i % 4 < 2 ? 1e-4 : 0.025) * tolerance;
    const AllFaces all(a, b, tolerance, slack);
    const std::vector<ContactPoint> points = contact_points(a, b, tolerance, slack);
    size_t num_features = 0;
    for (const ContactPoint& p : points) {
      if (p.features == ContactFeatures::ClosestPoints) continue;
      ++num_features;
      const auto known = all.found.find(pair_of(p));
      ASSERT_NE(known, all.found.end()) << "pair " << i;
      for (const ContactPoint& q : known->second) EXPECT_TRUE(are_the_same(p, q)) << "pair " << i;
      num_shared += known->second.size() > 1;
    }
    EXPECT_EQ(num_features, all.found.size()) << "pair " << i;
    num_found += static_cast<int>(num_features);
    for (const ContactPoint& end : all.ends) {
      EXPECT_TRUE(std::any_of(points.begin(), points.end(),
                              [&](const ContactPoint& p) { return same_place(p, end, tolerance); }))
          << "pair " << i;
      ++num_ends;
    }
  }
  EXPECT_GT(num_found, num / 4);
  EXPECT_GT(num_shared, num_found / 20);
  EXPECT_GT(num_ends, num / 50);
}

}  // namespace
}  // namespace trivet
