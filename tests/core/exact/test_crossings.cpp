#include <gtest/gtest.h>

#include "core/exact/predicates.h"
#include "placed_meshes.h"

namespace trivet::test {
namespace {

constexpr unsigned kCrossingsSeed = 20240613;

struct BruteForce {
  std::int64_t count = 0;
  std::optional<CrossingPair> first;
};

BruteForce brute_force(const Placed& a, const Placed& b) {
  BruteForce out;
  const auto num_faces = [](const Placed& p) {
    return static_cast<Index>(p.shape->mesh.triangles.size());
  };
  for (Index i = 0; i < num_faces(a); ++i)
    for (Index j = 0; j < num_faces(b); ++j) {
      if (!triangles_intersect(a.triangle(i), b.triangle(j))) continue;
      ++out.count;
      if (!out.first) out.first = CrossingPair{i, j};
    }
  return out;
}

// Returns the number of crossings.
std::int64_t expect_like_brute_force(const Placed& a, const Placed& b) {
  const BruteForce truth = brute_force(a, b);
  std::optional<CrossingPair> first = CrossingPair{-1, -1};
  EXPECT_EQ(count_crossings(a, b, std::numeric_limits<std::int64_t>::max(), &first), truth.count);
  EXPECT_EQ(first.has_value(), truth.first.has_value());
  if (first && truth.first) {
    EXPECT_EQ(first->face_a, truth.first->face_a);
    EXPECT_EQ(first->face_b, truth.first->face_b);
  }
  EXPECT_EQ(count_crossings(b, a), truth.count);
  for (std::int64_t limit : {0, 1, 3})
    EXPECT_EQ(count_crossings(a, b, limit), std::min(limit, truth.count));
  return truth.count;
}

// Triangles of all sizes, some degenerate.
Soup random_soup(Source& source, int num_faces) {
  Soup out;
  for (int i = 0; i < num_faces; ++i) {
    const Vec3 at = source.point(-1, 1);
    const double size = source.uniform(0, 0.6);
    Triangle t;
    for (Vec3& p : t) p = at + size * source.point(-1, 1);
    if (source.integer(0, 9) == 0) t[2] = t[source.integer(0, 1)];
    out.push_back(t);
  }
  return out;
}

}  // namespace

TEST(Crossings, EqualBruteForceOnRandomShapes) {
  Source source(kCrossingsSeed);
  int crossing = 0;
  constexpr int kCases = 400;
  for (int i = 0; i < kCases; ++i) {
    const bool rigid = i % 2;
    const double far = i % 8 < 2 ? 1e7 : i % 8 < 4 ? 1e-3 : 1.0;
    const Placed a(random_soup(source, source.integer(1, 120)), random_affine(source, far, rigid));
    Affine pose = random_affine(source, 1.2, rigid);
    pose.translation += a.world_from_object.translation;
    const Placed b(random_soup(source, source.integer(1, 120)), pose);
    crossing += expect_like_brute_force(a, b) > 0;
    ASSERT_FALSE(HasFailure()) << "case " << i << ", seed " << kCrossingsSeed;
  }
  std::printf("seed %u: %.1f %% of %d pairs of shapes cross\n", kCrossingsSeed,
              100.0 * crossing / kCases, kCases);
  EXPECT_GE(crossing, kCases / 2);
  EXPECT_LE(crossing, kCases * 19 / 20);
}

// Boxes face on face, under rotations that round: a BVH without a margin would miss pairs.
TEST(Crossings, EqualBruteForceOnTouchingBoxes) {
  Source source(kCrossingsSeed + 1);
  int touching = 0;
  constexpr int kCases = 1000;
  for (int i = 0; i < kCases; ++i) {
    Affine pose = random_affine(source, i % 2 ? 1e6 : 1, true);
    if (i % 5 == 0) pose.linear = Mat3::Identity();
    const Vec3 step = Vec3(source.integer(0, 1), source.integer(0, 1), 1) / 3;
    const Placed a(box_soup(Vec3::Zero(), Vec3::Constant(1.0 / 3)), pose);
    const Placed b(box_soup(step, step + Vec3::Constant(1.0 / 3)), pose);
    touching += expect_like_brute_force(a, b) > 0;
    ASSERT_FALSE(HasFailure()) << "case " << i << ", seed " << kCrossingsSeed;
  }
  std::printf("seed %u: %.1f %% touch\n", kCrossingsSeed + 1, 100.0 * touching / kCases);
  EXPECT_GE(touching, kCases * 9 / 10);
}

// Positions that deviate from the transform, as after export in float32.
TEST(Crossings, EqualBruteForceWithSlack) {
  Source source(kCrossingsSeed + 2);
  constexpr double kSlack = 0.05;
  int differs = 0;
  for (int i = 0; i < 200; ++i) {
    Placed a(sphere_soup(Vec3::Zero(), 1, 2), random_affine(source, 1, true));
    Placed b(sphere_soup(Vec3::Zero(), 1, 2), random_affine(source, 1, true));
    b.world_from_object.translation =
        a.world_from_object.translation +
        (2 + source.uniform(-0.1, 0.1)) * source.point(-1, 1).normalized();
    b.positions = world_positions(*b.shape, b.world_from_object);
    const std::int64_t before = count_crossings(a, b);
    for (Placed* p : {&a, &b}) {
      p->slack = kSlack;
      for (Vec3& x : p->positions) x += kSlack * source.point(-0.57, 0.57);
    }
    differs += (expect_like_brute_force(a, b) > 0) != (before > 0);
    ASSERT_FALSE(HasFailure()) << "case " << i << ", seed " << kCrossingsSeed;
  }
  std::printf("seed %u: %d of 200 verdicts changed by slack\n", kCrossingsSeed + 2, differs);
  EXPECT_GE(differs, 5);
}

TEST(Crossings, HandleMeshesFlattenedToPlane) {
  Affine flat;
  flat.linear.row(2).setZero();
  const Placed a(sphere_soup(Vec3::Zero(), 1, 1), flat);
  const Placed b(sphere_soup(Vec3(0.5, 0.25, 0), 1, 1), flat);
  EXPECT_GT(expect_like_brute_force(a, b), 0);
  Affine point;
  point.linear.setZero();
  EXPECT_GT(expect_like_brute_force(a, Placed(box_soup(Vec3::Zero(), Vec3::Ones()), point)), 0);
}

TEST(Crossings, AreZeroWithoutFaces) {
  const Placed none{Soup{}}, box(box_soup(Vec3::Zero(), Vec3::Ones()));
  std::optional<CrossingPair> first = CrossingPair{1, 2};
  EXPECT_EQ(count_crossings(none, box, 10, &first), 0);
  EXPECT_FALSE(first.has_value());
  EXPECT_EQ(count_components_inside(none, box), 0);
  EXPECT_EQ(count_components_inside(box, none), 0);
}

}  // namespace trivet::test
